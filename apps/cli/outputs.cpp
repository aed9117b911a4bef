#include "apps/cli/outputs.h"

#include <set>

#include "io/files/paths.h"
#include "io/image/gif.h"
#include "io/image/heif.h"
#include "io/image/png.h"
#include "io/image/webp.h"
#include "io/mesh/obj_encode.h"
#include "io/scene/scene_json.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& path, const std::string& extension) {
  const std::string name = obj_file_name(path.stem().string()) + extension;
  return path.parent_path() / name;
}

/// Returns a path that is the same for all spellings of a file's path. The file need not exist.
fs::path identity(const fs::path& path) {
  std::error_code code;
  // A relative path to a file that does not exist yet would stay relative.
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path, code), code);
  return code ? fs::absolute(path, code).lexically_normal() : canonical;
}

/// Returns the path of the drawing relative to the scene's folder; empty if it is not inside or has
/// no file of its own.
std::string path_from(const fs::path& scene, const std::string& drawing) {
  if (drawing.empty() || drawing == "-") return "";
  const auto inside = path_below(drawing, identity(scene).parent_path());
  return inside ? inside->generic_string() : "";
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

std::vector<fs::path> planned_outputs(const BuildArguments& build) {
  std::vector<fs::path> paths;
  for (const std::string& model : build.models)
    for (int level = 0; level < build.levels; ++level) {
      const fs::path path = level_name(model, level);
      paths.push_back(path);
      if (path.extension() != ".obj") continue;
      paths.push_back(beside(path, ".mtl"));
      paths.push_back(beside(path, ".png"));
    }
  for (const std::string* name :
       {&build.normal_map, &build.depth_map, &build.part_map, &build.occlusion_map,
        &build.carve_map, &build.preview, &build.overlay, &build.convergence, &build.report})
    if (!name->empty()) paths.emplace_back(*name);
  return paths;
}

std::string level_name(const std::string& name, int level) {
  if (level == 0) return name;
  const fs::path path = name;
  const std::string stem = path.stem().string() + "-lod" + std::to_string(level);
  return (path.parent_path() / (stem + path.extension().string())).string();
}

Status check_outputs(const std::vector<fs::path>& paths, const std::vector<fs::path>& inputs) {
  std::set<fs::path> taken;
  for (const fs::path& path : paths) {
    if (path.empty()) continue;
    std::error_code code;
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    if (!fs::is_directory(folder, code))
      return Error{ErrorCode::file, "cannot be written: its folder does not exist", path.string()};
    if (fs::is_directory(path, code))
      return Error{ErrorCode::file, "cannot be written: it is a folder", path.string()};
    if (!taken.insert(identity(path)).second)
      return Error{ErrorCode::usage, "is the name of two outputs; choose another name for one",
                   path.string()};
    for (const fs::path& input : inputs)
      if (fs::equivalent(path, input, code))
        return Error{ErrorCode::usage, "is an input and is never overwritten", path.string()};
  }
  return Done{};
}

Status make_folder(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return Error{ErrorCode::file, "cannot be created: " + code.message(), folder.string()};
  return Done{};
}

std::string picture_kind(ByteView bytes) {
  if (is_png(bytes)) return "png";
  if (is_gif(bytes)) return "gif";
  if (is_webp(bytes)) return "webp";
  if (is_heif(bytes)) return is_avif(bytes) ? "avif" : "heic";
  return sniff(bytes) == InputKind::svg ? "svg" : "jpeg";
}

Result<SceneDrawing> drawing_of(const InputFile& file, const SceneInput& input) {
  const std::string& from = input.drawing_file;
  Result<Bytes> bytes = Bytes();
  if (from == "-")
    bytes = file.bytes;
  else if (!from.empty())
    bytes = read_file(from);
  else if (!input.drawing.rgba.empty())
    bytes = encode_png(input.drawing.rgba);
  if (!bytes) return bytes.error();
  return SceneDrawing{from, std::move(*bytes)};
}

void add_scene(Outputs& outputs, const std::string& output, Scene scene,
               const SceneDrawing& drawing) {
  scene.drawing = path_from(output, drawing.file);
  if (scene.drawing.empty() && !drawing.bytes.empty()) {
    const fs::path copy = copy_of_drawing(output, drawing.bytes);
    scene.drawing = copy.filename().string();
    outputs.add(copy, [&] { return drawing.bytes; });
  }
  outputs.add(output, [&]() -> Result<Bytes> {
    const auto text = write_scene(scene);
    if (!text) return text.error();
    return bytes_of(*text);
  });
}

Status save(const Outputs& outputs, const std::vector<fs::path>& inputs,
            Interruption& interruption) {
  if (!outputs.status) return outputs.status;
  const auto writing = interruption.hold_off();
  if (*interruption.flag()) return interrupted_error();
  Status status = write_files(outputs.files, inputs);
  if (status) interruption.finish();
  return status;
}

}  // namespace relievo::cli
