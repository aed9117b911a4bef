#include "apps/cli/batch/digest.h"

#include <glib.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "relievo/files.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

class Sha256 {
 public:
  /// Adds a piece, with its length first so that different lists of pieces have different sums.
  void add(const void* bytes, size_t size) {
    const std::string length = std::to_string(size) + ":";
    update(length.data(), length.size());
    update(bytes, size);
  }
  std::string digits() { return g_checksum_get_string(sum_.get()); }

 private:
  void update(const void* bytes, size_t size) {
    g_checksum_update(sum_.get(), static_cast<const guchar*>(bytes), static_cast<gssize>(size));
  }

  std::unique_ptr<GChecksum, decltype(&g_checksum_free)> sum_{g_checksum_new(G_CHECKSUM_SHA256),
                                                              g_checksum_free};
};

Status add_file(const fs::path& path, const std::string& name, Sha256& sum) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  sum.add(name.data(), name.size());
  sum.add(bytes->data(), bytes->size());
  return Done{};
}

Status add_folder(const fs::path& folder, Sha256& sum) {
  std::error_code code;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator it(folder, code), end; !code && it != end;
       it.increment(code))
    if (it->is_regular_file(code)) files.push_back(it->path());
  if (code) return Error{ErrorCode::file, "cannot be read: " + code.message(), folder.string()};
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    if (Status status = add_file(file, file.lexically_relative(folder).generic_string(), sum);
        !status)
      return status;
  return Done{};
}

/// Returns the drawing that a scene file names; empty if it is not a scene or names none.
fs::path drawing_of(const fs::path& input) {
  if (input.extension() != ".json") return {};
  const auto bytes = read_file(input);
  if (!bytes) return {};
  const auto scene = nlohmann::json::parse(bytes->begin(), bytes->end(), nullptr, false);
  if (!scene.is_object() || !scene.contains("drawing") || !scene["drawing"].is_string()) return {};
  return input.parent_path() / scene["drawing"].get<std::string>();
}

}  // namespace

Result<std::string> digest_of(const fs::path& input) {
  Sha256 sum;
  std::error_code code;
  if (fs::is_directory(input, code)) {
    if (Status status = add_folder(input, sum); !status) return status.error();
    return sum.digits();
  }
  if (Status status = add_file(input, "", sum); !status) return status.error();
  // The build reports a drawing that cannot be read.
  if (const fs::path drawing = drawing_of(input); !drawing.empty() && fs::exists(drawing, code))
    if (Status status = add_file(drawing, "drawing", sum); !status) return status.error();
  return sum.digits();
}

}  // namespace relievo::cli
