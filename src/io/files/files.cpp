#include "relievo/files.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <system_error>

namespace relievo {
namespace {

namespace fs = std::filesystem;

using OwnedFile = std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })>;

Error read_error(const fs::path& path, int code) {
  return {ErrorCode::file, "cannot be read: " + std::generic_category().message(code),
          path.string()};
}

Error too_large(const fs::path& path, uint64_t max_bytes) {
  return {ErrorCode::limit, "is larger than " + std::to_string(max_bytes) + " bytes",
          path.string()};
}

Error file_error(const fs::path& path, const std::string& reason) {
  return {ErrorCode::file, "cannot be written: " + reason, path.string()};
}

Status check_destination(const fs::path& path, const std::vector<fs::path>& inputs) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return file_error(path, "it is not a regular file");
  for (const fs::path& input : inputs)
    if (fs::exists(status) && fs::equivalent(path, input, code))
      return Error{ErrorCode::usage, "is an input, which is never overwritten; choose another name",
                   path.string()};
  if (!fs::is_directory(path.parent_path(), code))
    return file_error(path, "its folder does not exist");
  return Done{};
}

/// Creates an empty file in the destination's folder under an unused name, with the permissions of
/// a new file, and returns its path; empty on failure.
fs::path reserve_name_beside(const fs::path& destination) {
  static std::atomic<unsigned> next{0};
  while (true) {
    const std::string name =
        ".relievo-" + std::to_string(getpid()) + "-" + std::to_string(next.fetch_add(1));
    fs::path path = destination.parent_path() / name;
    if (std::FILE* file = std::fopen(path.c_str(), "wbx")) {
      std::fclose(file);
      return path;
    }
    if (errno != EEXIST) return {};
  }
}

bool write_bytes(const fs::path& path, const Bytes& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool complete =
      bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return (std::fclose(file) == 0) && complete;
}

/// One output on its way to its destination. The destructor removes temporary files.
class Staged {
 public:
  explicit Staged(fs::path destination) : destination_(std::move(destination)) {}
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;
  ~Staged() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
    if (!previous_.empty()) fs::remove(previous_, ignored);
  }

  Status write(const Bytes& bytes) {
    temporary_ = reserve_name_beside(destination_);
    if (temporary_.empty() || !write_bytes(temporary_, bytes)) return failed();
    std::error_code code;
    if (fs::exists(destination_, code))
      fs::permissions(temporary_, fs::status(destination_, code).permissions(), code);
    return Done{};
  }

  /// Keeps a second name for the file that is about to be replaced.
  Status keep_previous() {
    std::error_code code;
    if (!fs::exists(destination_, code)) return Done{};
    previous_ = reserve_name_beside(destination_);
    if (previous_.empty()) return failed();
    fs::remove(previous_, code);
    fs::create_hard_link(destination_, previous_, code);
    if (code && !fs::copy_file(destination_, previous_, code)) return failed();
    return Done{};
  }

  Status commit() {
    std::error_code code;
    fs::rename(temporary_, destination_, code);
    if (code) return file_error(destination_, code.message());
    temporary_.clear();
    return Done{};
  }

  void roll_back() {
    std::error_code ignored;
    if (previous_.empty()) {
      fs::remove(destination_, ignored);
    } else {
      fs::rename(previous_, destination_, ignored);
      previous_.clear();
    }
  }

 private:
  Status failed() const { return file_error(destination_, std::generic_category().message(errno)); }

  fs::path destination_;
  fs::path temporary_;
  fs::path previous_;
};

using StagedFiles = std::vector<std::unique_ptr<Staged>>;

Result<StagedFiles> stage(const std::vector<OutputFile>& outputs,
                          const std::vector<fs::path>& inputs) {
  std::set<fs::path> taken;
  std::vector<fs::path> destinations;
  for (const OutputFile& output : outputs) {
    std::error_code code;
    fs::path destination = fs::weakly_canonical(fs::absolute(output.path, code), code);
    if (code || output.path.empty()) return file_error(output.path, "the path is not valid");
    if (Status status = check_destination(destination, inputs); !status) return status.error();
    if (!taken.insert(destination).second)
      return Error{ErrorCode::usage, "is the name of two outputs; choose another name for one",
                   output.path.string()};
    destinations.push_back(std::move(destination));
  }
  StagedFiles staged;
  for (size_t i = 0; i < outputs.size(); ++i) {
    staged.push_back(std::make_unique<Staged>(destinations[i]));
    if (Status status = staged.back()->write(outputs[i].bytes); !status) return status.error();
  }
  return staged;
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

Status write_files(const std::vector<OutputFile>& outputs, const std::vector<fs::path>& inputs) {
  Result<StagedFiles> staged = stage(outputs, inputs);
  if (!staged) return staged.error();
  if (staged->size() > 1)
    for (const auto& file : *staged)
      if (Status status = file->keep_previous(); !status) return status;
  for (size_t i = 0; i < staged->size(); ++i) {
    Status status = (*staged)[i]->commit();
    if (status) continue;
    while (i-- > 0) (*staged)[i]->roll_back();
    return status;
  }
  return Done{};
}

}  // namespace relievo
