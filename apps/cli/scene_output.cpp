#include "apps/cli/scene_output.h"

#include <filesystem>

#include "face/inputs.h"
#include "io/files/paths.h"
#include "io/image/gif_decode.h"
#include "io/image/png_decode.h"
#include "io/scene/write_scene.h"
#include "relievo/files.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// The path of the drawing seen from the scene's folder, or empty where it is not inside or has
/// no file of its own.
std::string path_from(const fs::path& scene, const std::string& drawing) {
  if (drawing.empty() || drawing == "-") return "";
  std::error_code code;
  const fs::path place = fs::weakly_canonical(fs::absolute(scene, code), code);
  const auto inside = path_below(drawing, place.parent_path());
  return code || !inside ? "" : inside->generic_string();
}

/// The file beside the scene that takes a copy of a drawing from elsewhere.
fs::path copy_of_drawing(const fs::path& scene, ByteView drawing) {
  fs::path copy = scene;
  return copy.replace_extension(picture_kind(drawing));
}

/// A copy is put where nothing is, or the same.
Status check_copy(const fs::path& copy, const Bytes& drawing) {
  std::error_code code;
  if (!fs::exists(copy, code)) return Done{};
  const auto there = read_file(copy);
  if (there && *there == drawing) return Done{};
  return Error{ErrorCode::usage,
               "is in the way of a copy of the drawing; write the scene beside the drawing, or a "
               "project (.relievo), which holds it",
               copy.string()};
}

}  // namespace

std::string picture_kind(ByteView bytes) {
  if (is_png(bytes)) return "png";
  if (is_gif(bytes)) return "gif";
  return sniff(bytes) == InputKind::svg ? "svg" : "jpeg";
}

Result<std::vector<OutputFile>> scene_files(const std::string& output, Scene scene,
                                            const SceneDrawing& drawing) {
  std::vector<OutputFile> files;
  scene.drawing = path_from(output, drawing.file);
  if (scene.drawing.empty() && !drawing.bytes.empty()) {
    const fs::path copy = copy_of_drawing(output, drawing.bytes);
    if (Status status = check_copy(copy, drawing.bytes); !status) return status.error();
    scene.drawing = copy.filename().string();
    files.push_back({copy, drawing.bytes});
  }
  const auto text = write_scene(scene);
  if (!text) return text.error();
  files.push_back({output, bytes_of(*text)});
  return files;
}

}  // namespace relievo::cli
