#pragma once

#include <cstddef>

namespace relievo {

/// glTF 2.0's numbers for the types of an accessor's components.
constexpr size_t component_u16 = 5123;
constexpr size_t component_u32 = 5125;
constexpr size_t component_f32 = 5126;

}  // namespace relievo
