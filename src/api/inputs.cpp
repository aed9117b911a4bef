#include "api/inputs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "api/read_picture.h"
#include "io/archive/zip_archive.h"
#include "io/files/paths.h"
#include "io/image/decode_image.h"
#include "io/layered/merged_picture.h"
#include "io/layered/read_layer_folder.h"
#include "io/layered/read_ora.h"
#include "io/project/project_file.h"
#include "io/psd/psd_file.h"
#include "io/psd/read_psd.h"
#include "io/scene/scene_json.h"
#include "io/svg/read_svg.h"
#include "io/svg/render_svg.h"
#include "kernel/base/workers.h"
#include "kernel/image/image_size.h"
#include "relievo/files.h"
#include "relievo/pixel_art.h"
#include "understanding/marks/make_parts.h"
#include "understanding/marks/paint_gap.h"
#include "understanding/scene/connect_scene.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// Longest side of a vector drawing's texture, px.
constexpr double vector_texture_side = 2048;

/// Longest side of the picture of a vector drawing in which parts are sought, px.
constexpr double flat_picture_side = 1600;

/// Share of the paint that a person sees missing.
constexpr double seen_loose = 0.02;

/// Finds the parts in the picture of a vector drawing, as in a flat drawing. Adds a warning that
/// gives the reason.
Result<SceneInput> understand_painting(const InputFile& input,
                                       const understanding::PaintableSvg& svg, const char* reason,
                                       bool connect, const RunContext& context) {
  auto drawing = rasterize(svg, flat_picture_side);
  if (!drawing) return drawing.error();
  auto loaded = understand_flat(std::move(*drawing), input.name, connect, context);
  if (loaded) loaded->warnings.emplace_back(reason);
  return loaded;
}

/// Takes over the parts of a layered drawing, and connects them where that is wanted.
SceneInput with_layers(understanding::LayeredDrawing&& drawing, bool connect) {
  SceneInput loaded{std::move(drawing.scene), std::move(drawing.picture)};
  loaded.proposed = drawing.proposed;
  loaded.warnings = std::move(drawing.warnings);
  if (connect) {
    understanding::ConnectedScene connected = understanding::connect_scene(
        std::move(loaded.scene), loaded.proposed, drawing.colors, drawing.anchors);
    loaded.scene = std::move(connected.scene);
    loaded.guesses = std::move(connected.proposals);
  }
  return loaded;
}

/// Returns why the parts of a vector drawing come from its picture, null where its shapes are to be
/// taken. `made` says whether shapes made parts.
const char* why_painted(const understanding::LayeredDrawing& drawing, bool made,
                        bool painted_otherwise) {
  if (!made)
    return "no shape of the drawing makes a part: its parts are found as in a flat drawing; "
           "relievo segment can correct them";
  if (drawing.line_art)
    return "the drawing is made of lines: its parts are the areas that they enclose; relievo "
           "segment can correct them";
  if (drawing.proposed && painted_otherwise)
    return "the shapes that were read are not those that are painted: the parts are found as in a "
           "flat drawing; relievo segment can correct them";
  return nullptr;
}

/// Returns the share of the paint that is in no part of the scene and is not left out with a word.
double loose_paint(const Scene& scene, const Region& left_out, const Image8& painting) {
  understanding::LayeredDrawing drawing;
  drawing.scene = scene;
  drawing.left_out = left_out;
  return understanding::find_paint_gap(drawing, painting).loose;
}

/// Warns of paint that is missing in the model, with what to do about it.
void warn_of_loose(double loose, const char* remedy, std::vector<std::string>& warnings) {
  if (loose > seen_loose)
    warnings.push_back(std::to_string(std::lround(100 * loose)) +
                       " % of the drawing is in no part and missing in the model: " + remedy);
}

/// Finds the parts in the picture of a drawing whose shapes leave `loose` of its painting in no
/// part. Returns nothing where none are found, or where they leave much more.
std::optional<SceneInput> see_parts(const InputFile& input,
                                    const understanding::LayeredDrawing& read, double loose,
                                    const Image8& painting, const char* reason, bool connect,
                                    const RunContext& context) {
  auto seen = understand_painting(input, read.paintable, reason, connect, context);
  if (!seen || seen->scene.parts.empty()) return std::nullopt;
  const double missed = loose_paint(seen->scene, read.left_out, painting);
  if (missed > loose + understanding::most_loose) return std::nullopt;
  warn_of_loose(missed, "mark its parts with relievo segment", seen->warnings);
  return std::move(*seen);
}

Result<SceneInput> load_svg(const InputFile& input, bool connect, const RunContext& context) {
  auto read = read_svg(text_of(input.bytes));
  if (!read) return read.error();
  if (read->flat)
    return understand_painting(
        input, read->paintable,
        "the drawing is a picture: its parts are found as in a flat drawing; relievo segment can "
        "correct them",
        connect, context);
  const auto painting = rasterize(read->paintable, understanding::compared_side);
  if (!painting) return painting.error();
  const bool painted_otherwise = understanding::departs_from_paint(*read, painting->rgba);
  const bool declared = read->marks.empty() && !read->scene.parts.empty();
  const Status made = understanding::make_parts(*read);
  if (!made && made.error().code != ErrorCode::bad_input) return made.error();
  const double loose = made ? loose_paint(read->scene, read->left_out, painting->rgba) : 1;
  if (const char* reason = why_painted(*read, made.ok(), painted_otherwise)) {
    auto seen = see_parts(input, *read, loose, painting->rgba, reason, connect, context);
    if (seen) return std::move(*seen);
  }
  if (!made) return made.error();
  if (painted_otherwise)
    read->warnings.emplace_back(
        "some parts are not painted as they were read: look at the model; if it is wrong, save the "
        "drawing as PNG and open that");
  else if (!declared)
    warn_of_loose(loose,
                  "convert texts, patterns and effects to paths, or save the drawing as PNG and "
                  "open that",
                  read->warnings);
  auto rendering = std::async(
      worker_count() > 1 ? std::launch::async : std::launch::deferred,
      [svg = std::move(read->paintable)] { return rasterize(svg, vector_texture_side); });
  SceneInput loaded = with_layers(std::move(*read), connect);
  loaded.drawing_file = input.name;
  loaded.rendering = std::move(rendering);
  return loaded;
}

/// Makes the scene of layers of pixels, or of the picture that they make where that shows more
/// parts.
Result<SceneInput> from_layers(Result<understanding::LayeredDrawing> drawing,
                               const InputFile& input, bool connect, const RunContext& context) {
  if (!drawing) return drawing.error();
  const bool several = drawing->marks.size() > 1;
  if (!drawing->flat || !drawing->marks.empty())
    if (Status status = understanding::make_parts(*drawing); !status) return status.error();
  if (!drawing->flat) return with_layers(std::move(*drawing), connect);
  auto loaded = understand_fitted(fitted(drawing->picture.rgba), input.name, connect, context);
  const bool is_one = !drawing->scene.parts.empty() && (!loaded || loaded->scene.parts.size() < 2);
  if (is_one) return with_layers(std::move(*drawing), connect);
  if (!loaded) return loaded.error();
  if (several)
    drawing->warnings.emplace_back(
        "the layers hold one part together, so its parts are found in the picture that they make");
  loaded->warnings.insert(loaded->warnings.begin(), drawing->warnings.begin(),
                          drawing->warnings.end());
  return loaded;
}

Result<SceneInput> load_folder(const InputFile& input, bool connect, const RunContext& context) {
  std::vector<fs::path> files;
  auto loaded = from_layers(read_layer_folder(input.name, files), input, connect, context);
  if (loaded) loaded->files = std::move(files);
  return loaded;
}

/// Paints a vector layer at its own size.
Result<Image8> paint_svg(const Bytes& svg) {
  SvgOptions own_size;
  own_size.min_side = 0;
  own_size.max_side = std::numeric_limits<double>::infinity();
  const auto drawing = read_svg(text_of(svg), own_size);
  if (!drawing) return drawing.error();
  const understanding::PaintableSvg& text = drawing->paintable;
  auto picture = rasterize(text, std::max(text.width, text.height));
  if (!picture) return picture.error();
  return std::move(picture->rgba);
}

/// Returns the pixels of a picture, or of a vector drawing that covers the scene's canvas. A small
/// picture is enlarged where the scene was made of it so.
Result<Drawing> drawing_from(const Bytes& bytes, const Scene& scene) {
  if (sniff(bytes) == InputKind::svg) {
    auto svg = read_svg(text_of(bytes));
    if (!svg) return svg.error();
    understanding::settle_layers(*svg);
    const ImageSize size = fitted_size(scene.width, scene.height, vector_texture_side);
    return render_svg(svg->paintable, size.width, size.height);
  }
  auto picture = decode_fitted(bytes);
  if (!picture) return picture.error();
  if (picture->times == 1 || picture->rgba.width == scene.width)
    return Drawing{std::move(picture->rgba)};
  auto small = decode_image(bytes);
  if (!small) return small.error();
  return Drawing{std::move(*small)};
}

/// Returns the guessed joins of a segmented drawing, which may be left out if a mesh is too coarse
/// for them.
understanding::JoinProposals guessed_joins(const Scene& scene,
                                           const understanding::SegmentationRecord& record) {
  std::map<std::string_view, understanding::PartLabel> labels;
  for (const understanding::PartRecord& part : record.parts) labels[part.id] = part.label;
  const auto is_of = [&](const Join& join, int upper, int lower) {
    const auto above = labels.find(scene.parts[join.upper].id);
    const auto below = labels.find(scene.parts[join.lower].id);
    return above != labels.end() && below != labels.end() && above->second == upper &&
           below->second == lower;
  };
  understanding::JoinProposals guesses;
  for (const Join& join : scene.joins) {
    const auto& stated = record.corrections.joins;
    if (std::any_of(stated.begin(), stated.end(),
                    [&](const Join& one) { return is_of(join, one.upper, one.lower); }))
      continue;
    for (const understanding::JoinRecord& known : record.joins)
      if (is_of(join, known.upper, known.lower))
        guesses.joins.push_back({join, known.confidence, false});
  }
  return guesses;
}

Result<SceneInput> load_project(const InputFile& input) {
  auto project = decode_project(input.bytes);
  if (!project) return project.error();
  SceneInput loaded;
  if (project->segmentation) loaded.guesses = guessed_joins(project->scene, *project->segmentation);
  loaded.scene = std::move(project->scene);
  if (loaded.scene.drawing.empty()) return loaded;
  const Bytes& picture = project->picture.empty() ? project->drawing.bytes : project->picture;
  auto drawing = drawing_from(picture, loaded.scene);
  if (!drawing) return in_file(drawing.error(), loaded.scene.drawing);
  loaded.drawing = std::move(*drawing);
  return loaded;
}

/// Makes the scene of a painting of which only the merged picture, or a preview, can be read.
Result<SceneInput> load_preview(const InputFile& input, bool connect, const RunContext& context) {
  const auto entries = unpack_archive(
      input.bytes, {}, {"mergedimage.png", "preview.png", "QuickLook/Thumbnail.png"});
  if (!entries) return entries.error();
  for (const ArchiveEntry& entry : *entries) {
    auto picture = decode_fitted(entry.bytes);
    if (!picture || is_blank(picture->rgba)) continue;
    auto loaded = understand_fitted(std::move(*picture), input.name, connect, context);
    if (!loaded) return loaded.error();
    const FileKind kind = file_kind(input.bytes);
    loaded->warnings.insert(loaded->warnings.begin(),
                            "it is " + std::string(kind.name) + ", of which only the picture " +
                                entry.name + " is read; " + std::string(kind.remedy));
    return loaded;
  }
  return refused_file(input.bytes);
}

Result<SceneInput> load_archive(const InputFile& input, bool connect, const RunContext& context) {
  if (is_project(input.bytes)) return load_project(input);
  if (!file_kind(input.bytes).remedy.empty()) return load_preview(input, connect, context);
  const auto entries = unpack_archive(input.bytes);
  if (!entries) return entries.error();
  if (!is_ora(*entries))
    return Error{ErrorCode::bad_input,
                 "is an archive, but neither a project nor an OpenRaster drawing; unpack it, since "
                 "a folder of PNG files can be one drawing",
                 ""};
  return from_layers(read_ora(*entries, {}, paint_svg), input, connect, context);
}

/// Returns the path of a scene's drawing; fails if a link leads out of the scene's folder.
Result<fs::path> drawing_path(const InputFile& input, const std::string& drawing) {
  const fs::path parent = fs::path(input.name).parent_path();
  const fs::path folder = input.name == "-" || parent.empty() ? fs::path(".") : parent;
  const auto inside = path_below(folder / drawing, folder);
  if (!inside) return Error{ErrorCode::bad_input, "leads out of the scene's folder", "drawing"};
  std::error_code code;
  return fs::weakly_canonical(folder, code) / *inside;
}

void warn_about_shape(const Drawing& drawing, const Scene& scene, SceneInput& loaded) {
  const double stretch = (drawing.rgba.width / scene.width) / (drawing.rgba.height / scene.height);
  if (stretch > 1.02 || stretch < 1 / 1.02)
    loaded.warnings.emplace_back(
        "the drawing is stretched, as its proportions differ from those of the canvas");
}

Status load_drawing(const InputFile& input, SceneInput& loaded) {
  const auto path = drawing_path(input, loaded.scene.drawing);
  if (!path) return path.error();
  const auto bytes = read_file(*path);
  if (!bytes) return bytes.error();
  loaded.files.push_back(*path);
  loaded.drawing_file = path->string();
  auto drawing = drawing_from(*bytes, loaded.scene);
  if (!drawing) return in_file(drawing.error(), path->string());
  loaded.drawing = std::move(*drawing);
  warn_about_shape(loaded.drawing, loaded.scene, loaded);
  return Done{};
}

Result<SceneInput> load_json(const InputFile& input) {
  auto scene = read_scene(text_of(input.bytes));
  if (!scene) return scene.error();
  SceneInput loaded;
  loaded.scene = std::move(*scene);
  if (loaded.scene.drawing.empty()) return loaded;
  if (Status status = load_drawing(input, loaded); !status) return status.error();
  return loaded;
}

Result<SceneInput> load(const InputFile& input, bool connect, const RunContext& context) {
  if (input.folder) return load_folder(input, connect, context);
  const InputKind kind = sniff(input.bytes);
  if (kind == InputKind::svg) return load_svg(input, connect, context);
  if (kind == InputKind::json) return load_json(input);
  if (kind == InputKind::zip) return load_archive(input, connect, context);
  if (kind == InputKind::psd) return from_layers(read_psd(input.bytes), input, connect, context);
  if (kind == InputKind::image) return read_picture(input, connect, context);
  return refused_file(input.bytes);
}

}  // namespace

Result<Drawing> rasterize(const understanding::PaintableSvg& svg, double longest) {
  const ImageSize size = fitted_size(svg.width, svg.height, longest);
  return render_svg(svg, size.width, size.height);
}

Result<InputFile> read_input(const std::string& name) {
  std::error_code ignored;
  if (name != "-" && fs::is_directory(name, ignored)) return InputFile{name, {}, true};
  auto bytes = read_file(name == "-" ? fs::path("/dev/stdin") : fs::path(name));
  if (!bytes) return bytes.error();
  if (bytes->empty()) return Error{ErrorCode::bad_input, "is empty", name};
  return InputFile{name, std::move(*bytes)};
}

Result<SceneInput> start_scene(const InputFile& input, bool connect, const RunContext& context) {
  auto loaded = load(input, connect, context);
  if (!loaded) return in_file(loaded.error(), input.name);
  if (input.name != "-" && !input.folder) loaded->files.emplace_back(input.name);
  loaded->drawing.pixel_art = own_pixels(loaded->drawing.rgba);
  return loaded;
}

Status finish_drawing(const InputFile& input, SceneInput& scene) {
  if (!scene.rendering.valid()) return Done{};
  auto drawing = scene.rendering.get();
  if (!drawing) return in_file(drawing.error(), input.name);
  scene.drawing = std::move(*drawing);
  return Done{};
}

Result<SceneInput> load_scene(const InputFile& input, bool connect, const RunContext& context) {
  auto scene = start_scene(input, connect, context);
  if (!scene) return scene;
  if (Status status = finish_drawing(input, *scene); !status) return status.error();
  return scene;
}

}  // namespace relievo
