#include "apps/cli/segment_command.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/overlay_picture.h"
#include "apps/cli/scene_output.h"
#include "apps/cli/segment_report.h"
#include "face/inputs.h"
#include "io/files/number_text.h"
#include "io/files/paths.h"
#include "io/image/animation.h"
#include "io/image/decode_image.h"
#include "io/image/heif.h"
#include "io/image/png.h"
#include "io/project/project_file.h"
#include "io/project/project_json.h"
#include "io/psd/write_psd.h"
#include "io/scribbles/scribble_image.h"
#include "io/scribbles/scribbles_json.h"
#include "io/svg/read_svg.h"
#include "kernel/base/stopwatch.h"
#include "relievo/files.h"
#include "understanding/labels/segment_drawing.h"
#include "understanding/marks/make_parts.h"
#include "understanding/scene/understand_drawing.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// A flat drawing with its known segmentation and its project.
struct SegmentInput {
  std::string drawing_file;  ///< its path or "-"; empty if a project holds it or it was made here
  ProjectDrawing drawing;    ///< the artist's own file, or a picture of a vector drawing
  Image8 pixels;             ///< of the drawing, RGBA
  understanding::SegmentationRecord record;
  understanding::Segmentation found;              ///< empty if the record has the labels
  std::string name;                               ///< of the project; empty if there was none
  Scene scene;                                    ///< of the project; empty if there was none
  std::string first_frame{};                      ///< a warning about an animation, or empty
  std::map<std::string, std::string> other_keys;  ///< unknown keys of the project, kept
};

/// Longest side of the picture that is made from a vector drawing, px.
constexpr double vector_side = 1600;

Result<SegmentInput> from_project(const InputFile& file) {
  auto project = decode_project(file.bytes);
  if (!project) return project.error();
  if (!project->segmentation)
    return Error{ErrorCode::bad_input,
                 "is a project of a layered drawing, whose layers are its parts already", ""};
  SegmentInput input;
  input.drawing = std::move(project->drawing);
  input.record = std::move(*project->segmentation);
  input.name = std::move(project->name);
  input.other_keys = std::move(project->other_keys);
  input.scene = std::move(project->scene);
  return input;
}

/// Paints a vector drawing as the picture to segment, a PNG file.
Result<Bytes> picture_of(const Bytes& svg) {
  const std::string_view text{reinterpret_cast<const char*>(svg.data()), svg.size()};
  auto drawing = read_svg(text);
  if (!drawing) return drawing.error();
  understanding::settle_layers(*drawing);
  const auto picture = rasterize(drawing->paintable, vector_side);
  if (!picture) return picture.error();
  return encode_png(picture->rgba);
}

SegmentInput from_picture(const InputFile& file) {
  SegmentInput input;
  input.drawing_file = file.name;
  input.drawing = {file.name == "-" ? "drawing" : fs::path(file.name).filename().string(), "image",
                   "image/" + picture_kind(file.bytes), file.bytes};
  return input;
}

/// Unpacks a photo, a PNG file.
Result<Bytes> unpacked(const Bytes& heic) {
  const auto pixels = decode_heif(heic);
  if (!pixels) return pixels.error();
  return encode_png(*pixels);
}

/// Keeps a picture in place of a file: of vectors, since labels belong to pixels and a build reads
/// the same, or of HEIC, which browsers do not read.
Result<SegmentInput> from_picture_of(const InputFile& file, Result<Bytes> picture) {
  if (!picture) return picture.error();
  SegmentInput input = from_picture({file.name, std::move(*picture)});
  input.drawing_file.clear();
  input.drawing.name = fs::path(input.drawing.name).replace_extension("png").string();
  return input;
}

Result<SegmentInput> from_file(const InputFile& file) {
  if (is_project(file.bytes)) return from_project(file);
  const InputKind kind = sniff(file.bytes);
  if (kind == InputKind::svg) return from_picture_of(file, picture_of(file.bytes));
  if (is_heif(file.bytes) && !is_avif(file.bytes))
    return from_picture_of(file, unpacked(file.bytes));
  return from_picture(file);
}

Error wrong_size(const Image8& drawing, const std::string& name) {
  return {ErrorCode::bad_input,
          "must be as large as the drawing, " + std::to_string(drawing.width) + " x " +
              std::to_string(drawing.height) + " pixels",
          name};
}

Status read_labels(const std::string& name, SegmentInput& input) {
  const auto bytes = read_file(name);
  if (!bytes) return bytes.error();
  auto labels = decode_png_values(*bytes);
  if (!labels) return in_file(labels.error(), name);
  input.record.labels = std::move(*labels);
  return Done{};
}

Result<understanding::Scribbles> load_scribbles(const std::string& name, const Image8& pixels) {
  const auto bytes = read_file(name);
  if (!bytes) return bytes.error();
  if (!is_png(*bytes)) {
    auto scribbles = read_scribbles({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    return scribbles ? std::move(scribbles) : in_file(scribbles.error(), name);
  }
  const auto picture = decode_png(*bytes);
  if (!picture) return in_file(picture.error(), name);
  auto scribbles = scribbles_from_image(*picture, pixels.width, pixels.height);
  return scribbles ? std::move(scribbles) : in_file(scribbles.error(), name);
}

bool is_transparent_somewhere(const Image8& rgba) {
  for (size_t i = 3; i < rgba.pixels.size(); i += 4)
    if (rgba.pixels[i] < 128) return true;
  return false;
}

/// Makes the drawing transparent outside the mask `name`. The result replaces the drawing, so that
/// everything which reads it later finds the same figure.
Status cut_out(const std::string& name, SegmentInput& input) {
  const auto bytes = read_file(name);
  if (!bytes) return bytes.error();
  const auto mask = decode_image(*bytes);
  if (!mask) return in_file(mask.error(), name);
  if (mask->width != input.pixels.width || mask->height != input.pixels.height)
    return wrong_size(input.pixels, name);
  const bool by_alpha = is_transparent_somewhere(*mask);
  for (size_t i = 0; i < mask->pixels.size(); i += 4) {
    const uint8_t* p = &mask->pixels[i];
    const int value = by_alpha ? p[3] : std::max({p[0], p[1], p[2]});
    if (value < 128) std::fill_n(&input.pixels.pixels[i], 4, uint8_t{0});
  }
  auto cut = encode_png(input.pixels);
  if (!cut) return cut.error();
  const std::string title = fs::path(input.drawing.name).replace_extension("png").string();
  input.drawing = {title, "image", "image/png", std::move(*cut)};
  input.drawing_file.clear();
  return Done{};
}

/// Reads or finds the labels, as the arguments specify.
Status choose_labels(const SegmentArguments& segment, SegmentInput& input,
                     const RunContext& context) {
  if (!segment.labels.empty()) return read_labels(segment.labels, input);
  const bool as_in_project =
      segment.scribbles.empty() && segment.figure.empty() && segment.parts == 0;
  if (as_in_project && !input.record.labels.empty()) return Done{};
  if (!segment.figure.empty())
    if (Status status = cut_out(segment.figure, input); !status) return status;
  if (!segment.scribbles.empty()) {
    auto scribbles = load_scribbles(segment.scribbles, input.pixels);
    if (!scribbles) return scribbles.error();
    input.record.scribbles = std::move(*scribbles);
  }
  if (segment.parts > 0) input.record.scribbles.count = segment.parts;
  auto found =
      understanding::segment_drawing(Drawing{input.pixels}, input.record.scribbles, context);
  if (!found) return found.error();
  input.found = std::move(*found);
  return Done{};
}

Result<SegmentInput> load(const SegmentArguments& segment, const RunContext& context) {
  const auto file = read_input(segment.common.input);
  if (!file) return file.error();
  auto input = from_file(*file);
  if (!input) return in_file(input.error(), file->name);
  auto pixels = decode_image(input->drawing.bytes);
  if (!pixels) return in_file(pixels.error(), file->name);
  input->pixels = std::move(*pixels);
  if (Status status = choose_labels(segment, *input, context); !status)
    return in_first_frame(status.error(), file->bytes);
  input->first_frame = first_frame_warning(file->bytes);
  const Image16& labels = input->found.labels.empty() ? input->record.labels : input->found.labels;
  if (labels.width != input->pixels.width || labels.height != input->pixels.height)
    return wrong_size(input->pixels, segment.labels);
  return input;
}

using Files = std::vector<OutputFile>;

/// Makes a project of the drawing and its segmentation.
Project project_of(const SegmentInput& input, const understanding::Understanding& understanding) {
  Project project;
  project.name = input.name.empty() ? fs::path(input.drawing.name).stem().string() : input.name;
  project.drawing = input.drawing;
  project.segmentation = understanding.record;
  project.scene = understanding.scene;
  project.scene.drawing = "drawing";
  project.other_keys = input.other_keys;
  return project;
}

/// Makes the main output, in the format given by its extension.
Result<Files> main_files(const SegmentArguments& segment, const SegmentInput& input,
                         const understanding::Understanding& understanding) {
  const fs::path ending = fs::path(segment.output).extension();
  if (ending == ".json")
    return scene_files(segment.output, understanding.scene,
                       {input.drawing_file, input.drawing.bytes});
  Files files;
  const Status added =
      add_file(files, segment.output,
               ending == ".psd" ? encode_part_layers(understanding.scene, input.pixels)
                                : encode_project(project_of(input, understanding)));
  if (!added) return added.error();
  return files;
}

/// Makes all files that the command writes.
Result<Files> files_of(const SegmentArguments& segment, const SegmentInput& input,
                       const understanding::Understanding& understanding, double milliseconds) {
  auto files = main_files(segment, input, understanding);
  if (!files) return files.error();
  if (!segment.overlay.empty()) {
    std::vector<std::vector<Point2>> bridges;
    for (const understanding::Bridge& bridge : understanding.segmentation.bridges)
      bridges.push_back(bridge.points);
    const Status added = add_file(*files, segment.overlay,
                                  draw_overlay(understanding.scene, {bridges, {}}, input.pixels));
    if (!added) return added.error();
  }
  if (!segment.report.empty())
    files->push_back(
        {segment.report, bytes_of(write_segment_report(segment.common.input, understanding.proposal,
                                                       milliseconds))});
  return files;
}

/// Describes a scene: "6 parts, 5 joins, 8 relations, 1 tilted".
std::string summary(const Scene& scene) {
  const auto tilted = std::count_if(scene.parts.begin(), scene.parts.end(),
                                    [](const Part& part) { return part.lean != Point2{}; });
  const auto flat = std::count_if(scene.parts.begin(), scene.parts.end(),
                                  [](const Part& part) { return part.flat > 0; });
  return counted(scene.parts.size(), "part") + ", " + counted(scene.joins.size(), "join") + ", " +
         counted(scene.relations.size(), "relation") +
         (tilted > 0 ? ", " + std::to_string(tilted) + " tilted" : "") +
         (flat > 0 ? ", " + std::to_string(flat) + " flat" : "");
}

}  // namespace

Status run_segment(const SegmentArguments& segment, Interruption& interruption) {
  const bool quiet = segment.common.quiet;
  std::vector<fs::path> outputs = {segment.output};
  for (const std::string* name : {&segment.overlay, &segment.report})
    if (!name->empty()) outputs.emplace_back(*name);
  std::vector<fs::path> inputs;
  for (const std::string* name :
       {&segment.common.input, &segment.labels, &segment.scribbles, &segment.figure})
    if (!name->empty() && *name != "-") inputs.emplace_back(*name);
  if (Status status = check_outputs(outputs, inputs); !status) return status;
  Progress progress(quiet);
  RunContext context{interruption.flag()};
  progress.watch(context);
  auto loaded = load(segment, context);
  if (!loaded) return loaded.error();
  const Stopwatch watch;
  const auto understood = understanding::understand_drawing(
      loaded->pixels, std::move(loaded->found), std::move(loaded->record), loaded->scene, context);
  if (!understood) return understood.error();
  if (understood->scene.parts.empty())
    return Error{ErrorCode::bad_input, "has no parts: all were removed in the project", ""};
  const auto files = files_of(segment, *loaded, *understood, watch.milliseconds());
  if (!files) return files.error();
  if (Status status = save(*files, inputs, interruption); !status) return status;
  print_warnings(understood->warnings, quiet);
  if (!loaded->first_frame.empty()) print_warnings({loaded->first_frame}, quiet);
  print_note(summary(understood->scene), quiet);
  for (const OutputFile& file : *files) print_result(file.path.string(), quiet);
  return Done{};
}

}  // namespace relievo::cli
