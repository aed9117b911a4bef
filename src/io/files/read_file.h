#pragma once

#include <cstdint>
#include <filesystem>

#include "io/files/bytes.h"
#include "kernel/base/result.h"

namespace relievo {

constexpr uint64_t default_max_file_bytes = uint64_t{256} << 20;

/// The whole file at `path`. Pipes and devices are read too, up to the limit. Errors: `file` where
/// it cannot be opened or read, `limit` where it holds more than `max_bytes`; `where` is the path.
Result<Bytes> read_file(const std::filesystem::path& path,
                        uint64_t max_bytes = default_max_file_bytes);

}  // namespace relievo
