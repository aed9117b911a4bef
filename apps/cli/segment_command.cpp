#include "apps/cli/segment_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/inputs.h"
#include "api/read_picture.h"
#include "apps/cli/common_arguments.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/pictures.h"
#include "apps/cli/report.h"
#include "apps/cli/segment_hints.h"
#include "apps/cli/segment_layers.h"
#include "io/files/number_text.h"
#include "io/files/paths.h"
#include "io/image/animation.h"
#include "io/image/decode_image.h"
#include "io/image/heif.h"
#include "io/image/png.h"
#include "io/project/project_file.h"
#include "io/project/project_json.h"
#include "io/psd/write_psd.h"
#include "io/svg/read_svg.h"
#include "kernel/base/stopwatch.h"
#include "kernel/image/compose.h"
#include "relievo/files.h"
#include "relievo/pixel_art.h"
#include "understanding/labels/segment_drawing.h"
#include "understanding/marks/make_parts.h"
#include "understanding/perception/built_in_network.h"
#include "understanding/perception/perceive.h"
#include "understanding/scene/understand_drawing.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* segment_help =
    R"(Turns a flat drawing into a scene. Finds the parts, completes the regions that other parts hide,
orders the parts in depth and proposes joins. A layered drawing keeps its own parts with their names,
unless an option asks for others, or its layers are none.

Examples:
  relievo segment wolf.png -o wolf.relievo
  relievo segment photo.jpg --scribbles strokes.png -o wolf.relievo --overlay understood.png
  relievo segment wolf.png --labels wolf-parts.png -o wolf.json --overlay understood.png
  relievo segment wolf.png -o wolf.psd
  relievo segment wolf.ora -o wolf.relievo
  relievo build wolf.relievo -o wolf.glb)";

struct SegmentArguments {
  CommonArguments common;
  std::string labels;     ///< file; empty: found in the drawing, or those of the project
  std::string scribbles;  ///< .png or .json
  std::string figure;     ///< mask of the figure (.png); empty: found
  int parts = 0;          ///< number of parts to propose; 0: as many as are found
  std::string output;     ///< project .relievo, scene .json or layers .psd
  std::string overlay;    ///< files; empty: not wanted
  std::string report;

  /// Returns whether parts are to be found in pixels.
  bool asks_for_parts() const {
    return parts > 0 || !labels.empty() || !scribbles.empty() || !figure.empty();
  }
};

/// A flat drawing with what is known of it.
struct SegmentInput {
  std::string drawing_file;  ///< its path or "-"; empty if a project holds it or it was made here
  Project project;           ///< new, or as it was read; it has a segmentation
  FittedImage picture;       ///< the drawing as its parts are sought
  understanding::Segmentation found;  ///< empty if the project has the labels
  std::string first_frame{};          ///< a warning about an animation, or empty
};

/// Longest side of the picture that is made from a vector drawing, px.
constexpr double vector_side = 1600;

Result<SegmentInput> from_project(const InputFile& file) {
  auto project = decode_project(file.bytes);
  if (!project) return project.error();
  if (!project->segmentation)
    return Error{ErrorCode::bad_input,
                 "is a project of a layered drawing, whose layers are its parts already", ""};
  return SegmentInput{"", std::move(*project), {}, {}};
}

/// Paints a vector drawing as the picture to segment, a PNG file.
Result<Bytes> picture_of(const Bytes& svg) {
  auto drawing = read_svg(text_of(svg));
  if (!drawing) return drawing.error();
  understanding::settle_layers(*drawing);
  const auto picture = rasterize(drawing->paintable, vector_side);
  if (!picture) return picture.error();
  return encode_png(picture->rgba);
}

SegmentInput from_picture(const InputFile& file) {
  SegmentInput input;
  input.drawing_file = file.name;
  input.project.segmentation.emplace();
  input.project.drawing = {file.name == "-" ? "drawing" : fs::path(file.name).filename().string(),
                           "image", "image/" + picture_kind(file.bytes), file.bytes};
  return input;
}

/// Keeps a picture in place of a file: of vectors or fitted, since labels belong to pixels and a
/// build reads the same, or of HEIC, which browsers do not read.
Result<SegmentInput> from_picture_of(const InputFile& file, Result<Bytes> picture) {
  if (!picture) return picture.error();
  SegmentInput input = from_picture({file.name, std::move(*picture)});
  input.drawing_file.clear();
  input.project.drawing.name =
      fs::path(input.project.drawing.name).replace_extension("png").string();
  return input;
}

/// Decodes a picture. Scenes name its file, even where a project keeps it fitted.
Result<SegmentInput> from_flat(const InputFile& file) {
  auto picture = decode_fitted(file.bytes);
  if (!picture) return picture.error();
  const bool is_heic = is_heif(file.bytes) && !is_avif(file.bytes);
  const bool is_other = is_heic || picture->factor > 1 || picture->times > 1;
  auto input = is_other ? from_picture_of(file, encode_png(picture->rgba))
                        : Result<SegmentInput>(from_picture(file));
  if (!input) return input;
  if (!is_heic) input->drawing_file = file.name;
  input->picture = std::move(*picture);
  return input;
}

Result<SegmentInput> from_file(const InputFile& file) {
  if (is_project(file.bytes)) return from_project(file);
  const InputKind kind = sniff(file.bytes);
  if (kind == InputKind::svg) return from_picture_of(file, picture_of(file.bytes));
  return from_flat(file);
}

/// Makes the drawing transparent outside the mask `name`. The result replaces the drawing, so that
/// everything which reads it later finds the same figure.
Status cut_out(const std::string& name, SegmentInput& input) {
  const auto mask = read_mask(name, input.picture);
  if (!mask) return mask.error();
  Image8& drawing = input.picture.rgba;
  const bool by_alpha = least_alpha(*mask) < 128;
  for (size_t i = 0; i < mask->pixels.size(); i += 4) {
    const uint8_t* p = &mask->pixels[i];
    const int value = by_alpha ? p[3] : std::max({p[0], p[1], p[2]});
    if (value < 128) std::fill_n(&drawing.pixels[i], 4, uint8_t{0});
  }
  auto cut = encode_png(drawing);
  if (!cut) return cut.error();
  const std::string title = fs::path(input.project.drawing.name).replace_extension("png").string();
  input.project.drawing = {title, "image", "image/png", std::move(*cut)};
  input.drawing_file.clear();
  return Done{};
}

/// Finds which parts are in front where labels are given.
Status perceive_order(SegmentInput& input) {
  auto seen = understanding::perceive(input.picture.rgba, understanding::built_in_network());
  if (!seen) return seen.error();
  input.found.front = std::move(seen->front);
  return Done{};
}

/// Reads or finds the labels, as the arguments specify.
Status choose_labels(const SegmentArguments& segment, SegmentInput& input,
                     const RunContext& context) {
  understanding::SegmentationRecord& record = *input.project.segmentation;
  if (!segment.labels.empty()) {
    auto labels = read_labels(segment.labels, input.picture);
    if (!labels) return labels.error();
    record.labels = std::move(*labels);
    return perceive_order(input);
  }
  const bool as_in_project =
      segment.scribbles.empty() && segment.figure.empty() && segment.parts == 0;
  if (as_in_project && !record.labels.empty()) return perceive_order(input);
  if (!segment.figure.empty())
    if (Status status = cut_out(segment.figure, input); !status) return status;
  if (!segment.scribbles.empty()) {
    auto scribbles = read_strokes(segment.scribbles, input.picture);
    if (!scribbles) return scribbles.error();
    record.scribbles = std::move(*scribbles);
  }
  if (segment.parts > 0) record.scribbles.count = segment.parts;
  auto found =
      understanding::segment_drawing(Drawing{input.picture.rgba}, record.scribbles, context);
  if (!found) return found.error();
  input.found = std::move(*found);
  return Done{};
}

/// Loads a drawing to segment. `layers`: the drawing of layers that are no parts; empty for others.
Result<SegmentInput> load(const SegmentArguments& segment, const InputFile& file,
                          const Drawing& layers, const RunContext& context) {
  auto input =
      layers.rgba.empty() ? from_file(file) : from_picture_of(file, encode_png(layers.rgba));
  if (!input) return in_file(input.error(), file.name);
  if (input->picture.rgba.empty()) {
    auto pixels = decode_image(input->project.drawing.bytes);
    if (!pixels) return in_file(pixels.error(), file.name);
    input->picture.rgba = std::move(*pixels);
  }
  if (Status status = choose_labels(segment, *input, context); !status)
    return in_first_frame(status.error(), file.bytes);
  input->first_frame = first_frame_warning(file.bytes);
  const Image16& labels =
      input->found.labels.empty() ? input->project.segmentation->labels : input->found.labels;
  if (labels.width != input->picture.rgba.width || labels.height != input->picture.rgba.height)
    return wrong_size(input->picture, segment.labels);
  return input;
}

/// Makes a project of the drawing and its segmentation.
Project project_of(const SegmentInput& input, const understanding::Understanding& understanding) {
  Project project = input.project;
  if (project.name.empty()) project.name = fs::path(project.drawing.name).stem().string();
  project.segmentation = understanding.record;
  project.scene = understanding.scene;
  project.scene.drawing = "drawing";
  project.picture.clear();
  return project;
}

Drawing drawing_of(const SegmentArguments& segment, const SegmentInput& input) {
  return {input.picture.rgba, own_pixels(input.picture.rgba, segment.common.pixel_art)};
}

/// Makes all files that the command writes, the main one in the format given by its extension.
Outputs outputs_of(const SegmentArguments& segment, const InputFile& file,
                   const SegmentInput& input, const understanding::Understanding& understanding,
                   double milliseconds) {
  Outputs outputs;
  const Bytes& drawing = input.drawing_file.empty() ? input.project.drawing.bytes : file.bytes;
  const fs::path ending = fs::path(segment.output).extension();
  if (ending == ".json")
    add_scene(outputs, segment.output, understanding.scene, {input.drawing_file, drawing});
  else
    outputs.add(segment.output, [&] {
      return ending == ".psd" ? encode_part_layers(understanding.scene, drawing_of(segment, input))
                              : encode_project(project_of(input, understanding));
    });
  outputs.add(segment.overlay, [&] {
    std::vector<std::vector<Point2>> bridges;
    for (const understanding::Bridge& bridge : understanding.segmentation.bridges)
      bridges.push_back(bridge.points);
    return draw_overlay(understanding.scene, {bridges, {}}, input.picture.rgba);
  });
  outputs.add(segment.report, [&] {
    return bytes_of(
        write_segment_report(segment.common.input, understanding.proposal, milliseconds));
  });
  return outputs;
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

/// Loads a layered drawing; nothing for other files. An SVG may also be one that only its picture
/// tells parts of.
Result<std::optional<SceneInput>> read_layers(const InputFile& file, const RunContext& context) {
  if (!is_layered(file)) return std::optional<SceneInput>();
  auto drawing = load_scene(file, true, context);
  if (drawing) return std::optional(std::move(*drawing));
  if (file.folder || sniff(file.bytes) != InputKind::svg) return drawing.error();
  return std::optional<SceneInput>();
}

Status write_own_parts(const SegmentArguments& segment, const InputFile& file,
                       const SceneInput& drawing, Interruption& interruption) {
  if (!segment.report.empty())
    return Error{ErrorCode::usage,
                 "--report is for parts that were found in a picture; for those of layers use: "
                 "relievo check",
                 ""};
  const auto made = layer_outputs(segment.output, segment.overlay, file, drawing);
  if (!made) return made.error();
  if (Status status = save(*made, drawing.files, interruption); !status) return status;
  print_warnings(drawing.warnings);
  print_note(summary(drawing.scene) + ": the layers of the drawing");
  for (const OutputFile& written : made->files) print_result(written.path.string());
  return Done{};
}

Status run_segment(const SegmentArguments& segment, Interruption& interruption) {
  std::vector<fs::path> inputs;
  for (const std::string* name :
       {&segment.common.input, &segment.labels, &segment.scribbles, &segment.figure})
    if (!name->empty() && *name != "-") inputs.emplace_back(*name);
  if (Status status = check_outputs({segment.output, segment.overlay, segment.report}, inputs);
      !status)
    return status;
  Progress progress;
  const RunContext context = progress.context(interruption.flag());
  const auto file = read_input(segment.common.input);
  if (!file) return file.error();
  auto layers = read_layers(*file, context);
  if (!layers) return layers.error();
  if (*layers && has_own_parts(**layers) && !segment.asks_for_parts())
    return write_own_parts(segment, *file, **layers, interruption);
  const bool is_svg = !file->folder && sniff(file->bytes) == InputKind::svg;
  auto loaded = load(segment, *file, *layers && !is_svg ? (*layers)->drawing : Drawing(), context);
  if (!loaded) return loaded.error();
  const Stopwatch watch;
  const auto understood = understanding::understand_drawing(
      loaded->picture.rgba, std::move(loaded->found), std::move(*loaded->project.segmentation),
      loaded->project.scene, context);
  if (!understood) return understood.error();
  if (understood->scene.parts.empty())
    return Error{ErrorCode::bad_input, "has no parts: all were removed in the project", ""};
  const Outputs made = outputs_of(segment, *file, *loaded, *understood, watch.milliseconds());
  if (Status status = save(made, inputs, interruption); !status) return status;
  if (*layers && !is_svg) print_warnings((*layers)->warnings);
  print_warnings(understood->warnings);
  if (!loaded->first_frame.empty()) print_warnings({loaded->first_frame});
  if (const std::string note = fitting_note(loaded->picture); !note.empty()) print_note(note);
  print_note(summary(understood->scene));
  for (const OutputFile& written : made.files) print_result(written.path.string());
  return Done{};
}

}  // namespace

void add_segment(CLI::App& main, Command& chosen) {
  const auto segment = std::make_shared<SegmentArguments>();
  CLI::App& app = *main.add_subcommand("segment", segment_help);
  add_common(app, segment->common,
             "Drawing (picture, SVG, OpenRaster, PSD, folder of pictures), or a project, whose "
             "corrections are applied");
  add_pixel_art(app, segment->common);
  auto* labels =
      add_path(app, "--labels", segment->labels,
               "Grey or palette picture whose values number the parts; 0 is background (.png)");
  add_path(app, "--scribbles", segment->scribbles,
           "Strokes that mark the parts: a picture with one colour for each part (.png), or a "
           "scribble file (.json)",
           {".png", ".json"})
      ->excludes(labels);
  add_path(app, "--figure", segment->figure,
           "Mask of the figure, white or opaque (.png): all of it becomes parts, and nothing else "
           "does")
      ->excludes(labels);
  app.add_option(
         "--parts", segment->parts,
         "Approximate number of parts: the pieces that most likely belong together are merged, or "
         "the least certain parts divided (default: decided by lines and colours)")
      ->check(CLI::Range(1, 1000))
      ->excludes(labels);
  add_path(app, "-o,--output", segment->output,
           "Project (.relievo), scene file (.json), or the parts as layers for further painting "
           "(.psd)",
           {".relievo", ".json", ".psd"})
      ->required();
  add_path(app, "--overlay", segment->overlay, overlay_help);
  add_path(app, "--report", segment->report, "The parts and guesses, with their confidence (.json)",
           {".json"});
  app.callback([segment, &chosen] { chosen = command(segment, run_segment); });
}

}  // namespace relievo::cli
