#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace relievo {

/// The colour keyword of CSS as 0xrrggbb; `name` in lower case.
std::optional<uint32_t> named_color(std::string_view name);

}  // namespace relievo
