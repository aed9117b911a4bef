#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

constexpr uint64_t default_max_file_bytes = uint64_t{256} << 20;

/// Reads the file at `path`; pipes and devices too, up to the limit. Errors: `file` if it cannot be
/// opened or read, `limit` if it has more than `max_bytes`; `where` is the path.
Result<Bytes> read_file(const std::filesystem::path& path,
                        uint64_t max_bytes = default_max_file_bytes);

/// A file to be written.
struct OutputFile {
  std::filesystem::path path;
  Bytes bytes;
};

/// Writes all of `outputs` or none. Each is first written beside its destination under a temporary
/// name and renamed when all are complete; if a rename fails, the files replaced before are
/// restored. A destination that is a link stays one: its target is replaced. Errors (`where` is the
/// path): `usage` if a destination is one of `inputs`, under any name, or is given twice; `file` if
/// its folder is missing, it is not a regular file, or writing fails. After an error no temporary
/// file remains.
Status write_files(const std::vector<OutputFile>& outputs,
                   const std::vector<std::filesystem::path>& inputs = {});

}  // namespace relievo
