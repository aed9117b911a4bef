#include "apps/cli/sequence/sequence_command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>

#include "apps/cli/common_arguments.h"
#include "apps/cli/cost.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/pixel_art.h"
#include "apps/cli/reconstruct.h"
#include "apps/cli/relief_arguments.h"
#include "apps/cli/sequence/frame_maps.h"
#include "apps/cli/sequence/frames.h"
#include "io/files/paths.h"
#include "io/image/png.h"
#include "relief/maps/ambient_occlusion.h"
#include "relief/maps/relief_maps.h"
#include "relief/session/relief_session.h"
#include "relievo/pixel_art.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

constexpr const char* help =
    R"(Makes consistent maps for the frames of an animation. All frames have the same scale and depth
range, parts of the same name have the same number, and still parts keep their heights. The
frames are drawings of the same size, in order, those of an animated GIF or WebP, or the sprites
of a sheet.

Examples:
  relievo sequence walk-*.svg -o maps
  relievo sequence walk-*.svg -o maps --columns 5 --make colour,normal,depth,part,occlusion
  relievo sequence walk.json -o maps
  relievo sequence walk.png --grid 8x2 -o maps
  relievo sequence walk.gif -o maps)";

/// Maximum number of pixels of all frames together.
constexpr size_t max_pixels = size_t{1} << 27;

bool wants(const SequenceArguments& sequence, const char* kind) {
  return std::find(sequence.make.begin(), sequence.make.end(), kind) != sequence.make.end();
}

/// Makes the maps of one frame after the other. Each build starts from the results of the last one.
class Animator {
 public:
  explicit Animator(const SequenceArguments& sequence) : sequence_(sequence) {}

  Status add(const Frame& frame, SceneInput input, ImageSize size, const RunContext& context) {
    auto options = settle_options(input.scene, sequence_.relief);
    if (!options) return options.error();
    options->hidden = false;
    if (edge_length_ > 0) options->layers.edge_length = edge_length_;
    if (Status s =
            without_bad_guesses({input.scene, input.guesses, input.warnings},
                                [&] { return session_.update(input.scene, *options, context); });
        !s)
      return s;
    const relief::Relief& relief = session_.relief();
    edge_length_ = relief.layers.edge_length;
    for (const std::string& warning : relief.layers.warnings) warn(frame, warning);
    for (const std::string& warning : input.warnings) warn(frame, warning);
    auto maps =
        relief::rasterize_relief({relief.layers, relief.inflation, relief.ordering, input.scene},
                                 size.width, size.height, context);
    if (!maps) return maps.error();
    FrameMaps made;
    made.name = frame.name;
    made.colour = input.drawing.rgba.empty() ? Image8(size.width, size.height, 4)
                                             : resized(input.drawing.rgba, size);
    const std::vector<int> number = numbers_.renumber(input.scene, frame.flat, maps->part);
    for (size_t p = 0; p < number.size(); ++p)
      made.outlines[number[p]] = std::move(input.scene.parts[p].outline);
    made.part = maps->part;
    made.height = maps->height;
    const double pixel = input.scene.width / size.width;
    if (!frames_.empty()) hold_heights(frames_.back(), pixel, made, maps->normal);
    maps->height = made.height;
    made.normal = normal_image(*maps, sequence_.normal_y_down);
    if (wants(sequence_, "occlusion"))
      made.occlusion = share_image(relief::ambient_occlusion(*maps, pixel));
    range_.add(made.height);
    frames_.push_back(std::move(made));
    return Done{};
  }

  void add_blank(const Frame& frame, ImageSize size) {
    frames_.push_back(blank_maps(frame.name, size));
  }

  const std::vector<FrameMaps>& frames() const { return frames_; }
  const HeightRange& range() const { return range_; }
  const PartNumbers& numbers() const { return numbers_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void warn(const Frame& frame, const std::string& text) {
    warnings_.push_back(frame.name + ": " + text);
  }

  const SequenceArguments& sequence_;
  relief::ReliefSession session_;
  double edge_length_ = 0;
  PartNumbers numbers_;
  HeightRange range_;
  std::vector<FrameMaps> frames_;
  std::vector<std::string> warnings_;
};

/// A map of 8 bits, or 16 for depth and parts.
using Picture = std::variant<Image8, Image16>;

Result<Picture> picture_of(const FrameMaps& frame, const std::string& kind,
                           const DepthScale& depth) {
  if (kind == "colour") return Picture(frame.colour);
  if (kind == "normal") return Picture(frame.normal);
  if (kind == "occlusion") return Picture(frame.occlusion);
  if (kind == "depth") return Picture(depth_image(frame.height, depth));
  auto part = part_image(frame.part);
  if (!part) return part.error();
  return Picture(std::move(*part));
}

Result<Bytes> encode(const Picture& picture, const std::string& kind, const DepthScale& depth) {
  if (const auto* small = std::get_if<Image8>(&picture)) return encode_png(*small);
  const auto& large = std::get<Image16>(picture);
  return kind == "depth" ? encode_depth_image(large, depth) : encode_png(large);
}

/// Puts all frames of a kind on one sheet.
Result<Picture> sheet_of(const std::vector<FrameMaps>& frames, const std::string& kind,
                         const DepthScale& depth, const Frames& layout) {
  auto sheet = picture_of(blank_maps("", layout.sheet_size), kind, depth);
  if (!sheet) return sheet;
  for (size_t i = 0; i < frames.size(); ++i) {
    const auto picture = picture_of(frames[i], kind, depth);
    if (!picture) return picture.error();
    std::visit(
        [&](auto& whole) {
          put_sprite(std::get<std::decay_t<decltype(whole)>>(*picture), layout.sheet->sprites[i],
                     whole);
        },
        *sheet);
  }
  return sheet;
}

OrderedJson report_of(const Animator& animator, const DepthScale& depth) {
  OrderedJson json;
  json["format"] = "relievo-sequence";
  json["version"] = 1;
  json["height_scale"] = depth.scale;
  json["height_offset"] = depth.offset;
  json["parts"] = animator.numbers().names();
  json["frames"] = OrderedJson::array();
  const std::vector<FrameMaps>& frames = animator.frames();
  for (size_t i = 0; i < frames.size(); ++i) {
    OrderedJson frame{{"name", frames[i].name}};
    if (i > 0) {
      const Flicker flicker = measure_flicker(frames[i - 1], frames[i], animator.range());
      frame["still"] = flicker.still;
      frame["change"] = {
          {"median", flicker.median}, {"most99", flicker.most99}, {"most", flicker.most}};
    }
    json["frames"].push_back(std::move(frame));
  }
  return json;
}

/// Lays the frames out in the columns of a new sheet, if the arguments ask for one.
void lay_out(const SequenceArguments& sequence, ImageSize size, Frames& frames) {
  if (frames.sheet || sequence.columns == 0) return;
  const int count = static_cast<int>(frames.frames.size());
  frames.sheet = grid_sheet(size, sequence.columns, count);
  for (int i = 0; i < count; ++i) frames.sheet->sprites[i].name = frames.frames[i].name;
  frames.sheet->picture = "sheet-colour.png";
  frames.sheet_size = extent(*frames.sheet);
}

std::string sheet_name(const SequenceArguments& sequence, const Frames& frames) {
  return sequence.columns > 0 ? "sheet" : fs::path(frames.sheet->picture).stem().string();
}

Outputs encode_all(const SequenceArguments& sequence, const Animator& animator,
                   const Frames& frames) {
  const fs::path folder = sequence.output;
  const DepthScale depth = depth_scale(animator.range());
  Outputs outputs;
  const auto add = [&](const std::string& name, const std::string& kind, auto draw) {
    outputs.add(folder / (name + "-" + kind + ".png"), [&]() -> Result<Bytes> {
      const Result<Picture> picture = draw();
      if (!picture) return picture.error();
      return encode(*picture, kind, depth);
    });
  };
  for (const std::string& kind : sequence.make) {
    if (frames.sheet) {
      add(sheet_name(sequence, frames), kind,
          [&] { return sheet_of(animator.frames(), kind, depth, frames); });
      continue;
    }
    for (const FrameMaps& frame : animator.frames())
      add(frame.name, kind, [&] { return picture_of(frame, kind, depth); });
  }
  if (sequence.columns > 0)
    outputs.add(folder / "sheet.json",
                [&] { return bytes_of(write_sprite_sheet(*frames.sheet, frames.sheet_size)); });
  outputs.add(folder / "sequence.json",
              [&] { return bytes_of(report_of(animator, depth).dump(1) + "\n"); });
  return outputs;
}

/// Checks that a frame has the canvas of the first one, whose size is set here (x width, y height).
Status check_canvas(const Scene& scene, const Frame& frame, Point2& canvas) {
  const Point2 size{scene.width, scene.height};
  if (canvas == Point2{}) canvas = size;
  if (canvas == size) return Done{};
  return Error{ErrorCode::bad_input, "differs in size from the first frame", frame.name};
}

/// Adds the pixels of a frame to the total. Errors: `limit`.
Status count_pixels(ImageSize size, size_t& pixels) {
  pixels += static_cast<size_t>(size.width) * size.height;
  if (pixels <= max_pixels) return Done{};
  return Error{ErrorCode::limit,
               "the maps of all frames have too many pixels; use fewer frames or smaller maps",
               "--map-size"};
}

Status animate(const SequenceArguments& sequence, Frames& frames, Animator& animator,
               const RunContext& context) {
  Point2 canvas;
  size_t pixels = 0;
  int longest = sequence.map_size > 0 ? sequence.map_size : frames.longest;
  for (size_t i = 0; i < frames.frames.size(); ++i) {
    const Frame& frame = frames.frames[i];
    if (context.cancelled()) return interrupted_error();
    ImageSize size;
    if (frames.sheet) {
      size = frames.sheet->sprites[i].whole;
      if (Status s = count_pixels(size, pixels); !s) return s;
    }
    if (frame.empty) {
      if (!frames.sheet) size = fitted_size(frame.canvas.width, frame.canvas.height, longest);
      animator.add_blank(frame, size);
      continue;
    }
    auto input = frame.load(context);
    if (!input) return input.error();
    settle_pixel_art(sequence.common, input->drawing);
    if (!frames.sheet) {
      if (Status s = check_canvas(input->scene, frame, canvas); !s) return s;
      if (longest == 0) longest = map_side(input->drawing, usual_map_side);
      size = fitted_size(canvas.x, canvas.y, longest);
      if (Status s = count_pixels(size, pixels); !s) return s;
    }
    if (Status s = animator.add(frame, std::move(*input), size, context); !s)
      return in_file(s.error(), frame.name);
  }
  lay_out(sequence, fitted_size(canvas.x, canvas.y, longest), frames);
  return Done{};
}

Status run_sequence(const SequenceArguments& sequence, Interruption& interruption) {
  if (Status s = check_cost(sequence.relief.options); !s) return s;
  auto frames = collect_frames(sequence);
  if (!frames) return frames.error();
  std::optional<Progress> progress(std::in_place);
  const RunContext context = progress->context(interruption.flag());
  Animator animator(sequence);
  if (Status s = animate(sequence, *frames, animator, context); !s) return s;
  progress.reset();
  const Outputs outputs = encode_all(sequence, animator, *frames);
  if (!outputs.status) return outputs.status;
  if (Status s = make_folder(sequence.output); !s) return s;
  if (Status s = save(outputs, frames->files, interruption); !s) return s;
  print_warnings(animator.warnings());
  for (const OutputFile& file : outputs.files) print_result(file.path.string());
  return Done{};
}

ImageSize grid(const std::string& text) {
  ImageSize cells;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%dx%d%c", &cells.width, &cells.height, &rest);
  const auto sound = [](int n) { return n >= 1 && n <= 1000; };
  if (read != 2 || !sound(cells.width) || !sound(cells.height))
    throw CLI::ValidationError("--grid " + text, "must be columns and rows, of the form 8x2");
  return cells;
}

}  // namespace

void add_sequence(CLI::App& main, Command& chosen) {
  const auto sequence = std::make_shared<SequenceArguments>();
  CLI::App& app = *main.add_subcommand("sequence", help);
  app.add_option("INPUT", sequence->inputs,
                 "Drawings as for build, an animated GIF or WebP, or a sprite sheet: its list of "
                 "sprites, as written by Aseprite or TexturePacker (.json), or its picture with "
                 "--grid")
      ->required();
  app.add_option("-o,--output", sequence->output, "Output folder")->required();
  app.add_option("--make", sequence->make,
                 "Outputs for each frame, separated by commas: colour, normal, depth, part, "
                 "occlusion (default: colour,normal,depth)")
      ->delimiter(',')
      ->check(CLI::IsMember({"colour", "normal", "depth", "part", "occlusion"}));
  auto* cells = app.add_option_function<std::string>(
      "--grid", [sequence](const std::string& text) { sequence->grid = grid(text); },
      "Columns and rows of a sprite sheet, such as 8x2");
  app.add_option(
         "--columns", sequence->columns,
         "Writes the frames on one sheet with this many columns, and a list of them (.json)")
      ->check(CLI::Range(1, 1000))
      ->excludes(cells);
  app.add_option("--map-size", sequence->map_size,
                 "Longest side of the maps of drawings in px (default 1024; of pixel art the "
                 "largest multiple "
                 "of its size up to that); sprites of a sheet keep their size")
      ->check(CLI::Range(1, 8192));
  add_normal_y(app, sequence->normal_y_down);
  add_run_options(app, sequence->common);
  add_connect(app, sequence->common);
  add_pixel_art(app, sequence->common);
  add_relief_options(app, sequence->relief);
  app.callback([sequence, &chosen] { chosen = command(sequence, run_sequence); });
}

}  // namespace relievo::cli
