#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

#include "io/files/paths.h"
#include "relievo/files.h"

namespace relievo {

namespace fs = std::filesystem;

namespace {

using OwnedFile = std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })>;

Error read_error(const fs::path& path, int code) {
  return {ErrorCode::file, "cannot be read: " + std::generic_category().message(code),
          path.string()};
}

Error too_large(const fs::path& path, uint64_t max_bytes) {
  return {ErrorCode::limit, "is larger than " + std::to_string(max_bytes) + " bytes",
          path.string()};
}

}  // namespace

Result<Bytes> read_file(const fs::path& path, uint64_t max_bytes) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return read_error(path, EISDIR);
  const OwnedFile file(std::fopen(path.c_str(), "rb"));
  if (!file) return read_error(path, errno);

  std::error_code unsized;
  const uint64_t expected = fs::file_size(path, unsized);
  if (!unsized && expected > max_bytes) return too_large(path, max_bytes);

  Bytes bytes;
  if (!unsized) bytes.reserve(expected);
  constexpr size_t block = size_t{1} << 16;
  while (true) {
    const size_t size = bytes.size();
    bytes.resize(size + block);
    const size_t count = std::fread(bytes.data() + size, 1, block, file.get());
    bytes.resize(size + count);
    if (bytes.size() > max_bytes) return too_large(path, max_bytes);
    if (count < block) break;
  }
  if (std::ferror(file.get()) != 0) return read_error(path, errno);
  return bytes;
}

}  // namespace relievo
