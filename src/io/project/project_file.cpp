#include "io/project/project_file.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "io/archive/archive.h"
#include "io/archive/zip_archive.h"
#include "io/files/paths.h"
#include "io/image/png.h"
#include "io/project/project_json.h"
#include "io/scene/scene_json.h"

namespace relievo {
namespace {

constexpr std::string_view mimetype = "application/vnd.relievo";
constexpr ArchiveLimits limits = {64, uint64_t{512} << 20, 1000};
/// Offset of the mimetype, behind a header of 30 bytes and its name.
constexpr size_t mimetype_offset = 38;

std::string_view text_of(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Error missing(const std::string& entry) {
  return {ErrorCode::bad_input, "is missing in the project file, which is incomplete", entry};
}

/// Reads a project from project.json and the other entries.
class Unpacker {
 public:
  explicit Unpacker(const std::vector<ArchiveEntry>& entries) : entries_(entries) {}

  Result<Project> project() const {
    const ArchiveEntry* head = find_entry(entries_, "project.json");
    if (head == nullptr) return missing("project.json");
    auto project = read_project_json(text_of(head->bytes));
    if (!project) return in_file(project.error(), "project.json");
    for (const auto read :
         {&Unpacker::read_scene_entry, &Unpacker::read_pictures, &Unpacker::read_labels})
      if (Status status = (this->*read)(*project); !status) return status.error();
    return std::move(*project);
  }

 private:
  Status read_scene_entry(Project& project) const {
    const ArchiveEntry* entry = find_entry(entries_, "scene.json");
    if (entry == nullptr) return missing("scene.json");
    auto scene = read_scene(text_of(entry->bytes));
    if (!scene) return in_file(scene.error(), "scene.json");
    project.scene = std::move(*scene);
    return Done{};
  }

  Status read_pictures(Project& project) const {
    if (const ArchiveEntry* entry = find_entry(entries_, "drawing"))
      project.drawing.bytes = entry->bytes;
    const std::string& name = project.scene.drawing;
    if (name.empty() || name == "drawing") return Done{};
    const ArchiveEntry* picture = find_entry(entries_, name);
    if (picture == nullptr) return missing(name);
    project.picture = picture->bytes;
    return Done{};
  }

  Status read_labels(Project& project) const {
    if (!project.segmentation) return Done{};
    const ArchiveEntry* entry = find_entry(entries_, "labels.png");
    if (entry == nullptr) return missing("labels.png");
    auto labels = decode_png_values(entry->bytes);
    if (!labels) return in_file(labels.error(), "labels.png");
    project.segmentation->labels = std::move(*labels);
    return Done{};
  }

  const std::vector<ArchiveEntry>& entries_;
};

}  // namespace

bool is_project(ByteView bytes) {
  return is_archive(bytes) && bytes.size() >= mimetype_offset + mimetype.size() &&
         std::equal(mimetype.begin(), mimetype.end(), bytes.begin() + mimetype_offset);
}

Result<Bytes> encode_project(const Project& project) {
  const auto scene = write_scene(project.scene);
  if (!scene) return in_file(scene.error(), "scene.json");
  std::vector<ArchiveEntry> entries = {{"mimetype", bytes_of(mimetype)},
                                       {"project.json", bytes_of(write_project_json(project))},
                                       {"scene.json", bytes_of(*scene)}};
  if (!project.drawing.bytes.empty()) entries.push_back({"drawing", project.drawing.bytes});
  if (!project.picture.empty()) entries.push_back({project.scene.drawing, project.picture});
  if (project.segmentation) {
    auto labels = encode_png(project.segmentation->labels);
    if (!labels) return in_file(labels.error(), "labels.png");
    entries.push_back({"labels.png", std::move(*labels)});
  }
  return pack_archive(entries);
}

Result<Project> decode_project(ByteView bytes) {
  const auto entries = unpack_archive(bytes, limits);
  if (!entries) return entries.error();
  const ArchiveEntry* type = find_entry(*entries, "mimetype");
  if (type == nullptr || text_of(type->bytes) != mimetype)
    return Error{ErrorCode::bad_input, "is not that of a Relievo project", "mimetype"};
  return Unpacker(*entries).project();
}

}  // namespace relievo
