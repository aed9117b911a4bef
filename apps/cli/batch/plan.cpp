#include "apps/cli/batch/plan.h"

#include <glib.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "relievo/files.h"
#include "relievo/run_context.h"

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

/// Returns the SHA-256 of an input, in hexadecimal digits: of the file and the drawing that a scene
/// names, or of the files of a folder with their names. Errors: `file`, `limit`.
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

bool all_exist(const std::vector<std::string>& files) {
  std::error_code code;
  return std::all_of(files.begin(), files.end(),
                     [&](const std::string& file) { return fs::is_regular_file(file, code); });
}

/// Checks whether the journal entry of a drawing is up to date.
bool is_current(const JournalEntry& known, const JournalEntry& wanted, bool retry) {
  const bool same = known.digest == wanted.digest && known.options == wanted.options &&
                    known.version == wanted.version && known.input == wanted.input;
  return same && (known.code == 0 ? all_exist(wanted.files) : !retry);
}

}  // namespace

Result<BatchPlan> plan_batch(const BatchArguments& batch, std::vector<BatchJob> jobs,
                             const JournalEntries& known, const std::atomic<bool>& stop) {
  BatchPlan plan;
  for (size_t k = 0; k < jobs.size(); ++k) {
    if (static_cast<int>(k % batch.shards) != batch.shard - 1) continue;
    if (stop) return interrupted_error();
    JournalEntry& entry = jobs[k].entry;
    plan.names.insert(entry.name);
    // The build reports why a drawing cannot be read.
    if (auto digest = digest_of(entry.input)) entry.digest = std::move(*digest);
    const auto before = known.find(entry.name);
    if (before != known.end() && is_current(before->second, entry, batch.retry)) continue;
    plan.builds.push_back(std::move(jobs[k]));
  }
  return plan;
}

}  // namespace relievo::cli
