#include "apps/cli/segment_layers.h"

#include <filesystem>
#include <utility>

#include "apps/cli/pictures.h"
#include "io/files/file_kind.h"
#include "io/image/png.h"
#include "io/project/project_file.h"
#include "io/project/project_json.h"
#include "io/psd/write_psd.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// Makes a project of the parts and the picture of the layers.
Result<Bytes> encode_layers(const InputFile& file, const SceneInput& drawing) {
  auto picture = encode_png(drawing.drawing.rgba);
  if (!picture) return picture.error();
  Project project;
  project.name = fs::absolute(file.name).lexically_normal().stem().string();
  if (file.name == "-" || project.name.empty()) project.name = "drawing";
  project.drawing = {project.name + ".png", "image", "image/png", std::move(*picture)};
  project.scene = drawing.scene;
  project.scene.drawing = "drawing";
  return encode_project(project);
}

}  // namespace

bool is_layered(const InputFile& file) {
  if (file.folder) return true;
  const InputKind kind = sniff(file.bytes);
  return kind == InputKind::svg || kind == InputKind::psd ||
         (kind == InputKind::zip && !is_project(file.bytes));
}

bool has_own_parts(const SceneInput& drawing) {
  return drawing.understood.empty() && (!drawing.proposed || drawing.scene.parts.size() > 1);
}

Result<Outputs> layer_outputs(const std::string& output, const std::string& overlay,
                              const InputFile& file, const SceneInput& drawing) {
  Outputs outputs;
  const fs::path ending = fs::path(output).extension();
  if (ending == ".json") {
    const auto picture = drawing_of(file, drawing);
    if (!picture) return picture.error();
    add_scene(outputs, output, drawing.scene, *picture);
  } else {
    outputs.add(output, [&] {
      return ending == ".psd" ? encode_part_layers(drawing.scene, drawing.drawing)
                              : encode_layers(file, drawing);
    });
  }
  outputs.add(overlay, [&] { return draw_overlay(drawing.scene, {}, drawing.drawing.rgba); });
  return outputs;
}

}  // namespace relievo::cli
