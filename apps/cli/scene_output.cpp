#include "apps/cli/scene_output.h"

#include <filesystem>

#include "face/inputs.h"
#include "io/files/paths.h"
#include "io/image/gif.h"
#include "io/image/heif.h"
#include "io/image/png.h"
#include "io/image/webp.h"
#include "io/scene/scene_json.h"
#include "relievo/files.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// Returns the path of the drawing relative to the scene's folder; empty if it is not inside or has
/// no file of its own.
std::string path_from(const fs::path& scene, const std::string& drawing) {
  if (drawing.empty() || drawing == "-") return "";
  std::error_code code;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(scene, code), code);
  const auto inside = path_below(drawing, canonical.parent_path());
  return code || !inside ? "" : inside->generic_string();
}

/// Returns a path beside the scene for a copy of the drawing: a free name, or that of an identical
/// file. An existing file may be someone's drawing, so it is never replaced.
fs::path copy_of_drawing(const fs::path& scene, const Bytes& drawing) {
  const std::string extension = "." + picture_kind(drawing);
  for (int number = 1;; ++number) {
    const std::string end = number > 1 ? "-" + std::to_string(number) : "";
    const fs::path copy = scene.parent_path() / (scene.stem().string() + end + extension);
    std::error_code code;
    if (!fs::exists(copy, code)) return copy;
    const auto there = read_file(copy);
    if (there && *there == drawing) return copy;
  }
}

}  // namespace

std::string picture_kind(ByteView bytes) {
  if (is_png(bytes)) return "png";
  if (is_gif(bytes)) return "gif";
  if (is_webp(bytes)) return "webp";
  if (is_heif(bytes)) return is_avif(bytes) ? "avif" : "heic";
  return sniff(bytes) == InputKind::svg ? "svg" : "jpeg";
}

Result<std::vector<OutputFile>> scene_files(const std::string& output, Scene scene,
                                            const SceneDrawing& drawing) {
  std::vector<OutputFile> files;
  scene.drawing = path_from(output, drawing.file);
  if (scene.drawing.empty() && !drawing.bytes.empty()) {
    const fs::path copy = copy_of_drawing(output, drawing.bytes);
    scene.drawing = copy.filename().string();
    files.push_back({copy, drawing.bytes});
  }
  const auto text = write_scene(scene);
  if (!text) return text.error();
  files.push_back({output, bytes_of(*text)});
  return files;
}

}  // namespace relievo::cli
