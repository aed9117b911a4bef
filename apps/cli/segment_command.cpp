#include <algorithm>
#include <cmath>

#include "apps/cli/commands.h"
#include "apps/cli/inputs.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/segment_report.h"
#include "apps/cli/stopwatch.h"
#include "io/files/read_file.h"
#include "io/image/decode_image.h"
#include "io/image/png_decode.h"
#include "io/image/png_encode.h"
#include "io/overlay/overlay_svg.h"
#include "io/scene/write_scene.h"
#include "io/svg/render_svg.h"
#include "relief/pipeline/propose_scene.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// The overlay is at least so large, so that lines of small drawings can be told apart, px.
constexpr double overlay_side = 1200;

struct Inputs {
  InputFile file;
  Image8 drawing;  ///< RGBA
  Image16 labels;
};

Error in(const std::string& file, Error error) {
  error.where = error.where.empty() ? file : file + ": " + error.where;
  return error;
}

Result<Inputs> load(const SegmentArguments& segment) {
  auto file = read_input(segment.common.input);
  if (!file) return file.error();
  auto drawing = decode_image(file->bytes);
  if (!drawing) return in(file->name, drawing.error());
  const auto bytes = read_file(segment.labels);
  if (!bytes) return bytes.error();
  auto labels = decode_png_values(*bytes);
  if (!labels) return in(segment.labels, labels.error());
  if (labels->width != drawing->width || labels->height != drawing->height)
    return Error{ErrorCode::bad_input,
                 "must be as large as the drawing, " + std::to_string(drawing->width) + " x " +
                     std::to_string(drawing->height) + " pixels",
                 segment.labels};
  return Inputs{std::move(*file), std::move(*drawing), std::move(*labels)};
}

/// The path of the drawing seen from the scene's folder, or empty where it is not inside.
std::string path_from(const fs::path& scene, const std::string& drawing) {
  if (drawing == "-") return "";
  std::error_code code;
  const fs::path folder = fs::weakly_canonical(fs::absolute(scene, code), code).parent_path();
  const fs::path path = fs::weakly_canonical(fs::absolute(drawing, code), code);
  const fs::path inside = path.lexically_relative(folder);
  return code || inside.empty() || *inside.begin() == ".." ? "" : inside.generic_string();
}

/// The file beside the scene that takes a copy of a drawing from elsewhere.
fs::path copy_of_drawing(const fs::path& scene, ByteView drawing) {
  fs::path copy = scene;
  return copy.replace_extension(is_png(drawing) ? ".png" : ".jpg");
}

uint8_t over(uint8_t above, uint8_t below, uint8_t alpha) {
  return static_cast<uint8_t>((above * alpha + below * (255 - alpha) + 127) / 255);
}

/// The drawing on white, enlarged, with the overlay on it.
Image8 composed(const Image8& drawing, const Image8& overlay) {
  Image8 picture(overlay.width, overlay.height, 3);
  for (int y = 0; y < overlay.height; ++y)
    for (int x = 0; x < overlay.width; ++x) {
      const int sx = std::min(drawing.width - 1, x * drawing.width / overlay.width);
      const int sy = std::min(drawing.height - 1, y * drawing.height / overlay.height);
      for (int c = 0; c < 3; ++c) {
        const uint8_t paper = over(drawing.at(sx, sy, c), 255, drawing.at(sx, sy, 3));
        picture.at(x, y, c) = over(overlay.at(x, y, c), paper, overlay.at(x, y, 3));
      }
    }
  return picture;
}

Result<Bytes> overlay_png(const Scene& scene, const Image8& drawing) {
  const double scale =
      std::max(1.0, std::round(overlay_side / std::max(drawing.width, drawing.height)));
  const auto overlay = render_svg(overlay_svg(scene), static_cast<int>(drawing.width * scale),
                                  static_cast<int>(drawing.height * scale));
  if (!overlay) return overlay.error();
  return encode_png(composed(drawing, overlay->rgba));
}

Bytes to_bytes(const std::string& text) { return {text.begin(), text.end()}; }

/// Every file that the command writes.
Result<std::vector<OutputFile>> files_of(const SegmentArguments& segment, const Inputs& inputs,
                                         Proposal& proposal, double milliseconds) {
  std::vector<OutputFile> files;
  proposal.scene.drawing = path_from(segment.output, segment.common.input);
  if (proposal.scene.drawing.empty()) {
    const fs::path copy = copy_of_drawing(segment.output, inputs.file.bytes);
    proposal.scene.drawing = copy.filename().string();
    files.push_back({copy, inputs.file.bytes});
  }
  const auto scene = write_scene(proposal.scene);
  if (!scene) return scene.error();
  files.push_back({segment.output, to_bytes(*scene)});
  if (!segment.overlay.empty()) {
    auto overlay = overlay_png(proposal.scene, inputs.drawing);
    if (!overlay) return overlay.error();
    files.push_back({segment.overlay, std::move(*overlay)});
  }
  if (!segment.report.empty())
    files.push_back({segment.report,
                     to_bytes(write_segment_report(segment.common.input, proposal, milliseconds))});
  return files;
}

std::string summary(const Proposal& proposal) {
  return std::to_string(proposal.scene.parts.size()) + " parts, " +
         std::to_string(proposal.scene.joins.size()) + " joins, " +
         std::to_string(proposal.scene.relations.size()) + " relations";
}

}  // namespace

Status run_segment(const SegmentArguments& segment, Interruption& interruption) {
  const bool quiet = segment.common.quiet;
  std::vector<fs::path> outputs = {segment.output};
  for (const std::string* name : {&segment.overlay, &segment.report})
    if (!name->empty()) outputs.emplace_back(*name);
  const std::vector<fs::path> inputs = {segment.common.input, segment.labels};
  if (Status status = check_outputs(outputs, inputs); !status) return status;
  const auto loaded = load(segment);
  if (!loaded) return loaded.error();
  Progress progress(quiet);
  const Stopwatch watch;
  auto proposal =
      propose_scene(loaded->labels, {}, {}, {interruption.flag(), progress.callback(), {}});
  if (!proposal) return proposal.error();
  const auto files = files_of(segment, *loaded, *proposal, watch.milliseconds());
  if (!files) return files.error();
  if (Status status = save(*files, inputs, interruption); !status) return status;
  print_warnings(proposal->warnings, quiet);
  print_note(summary(*proposal), quiet);
  for (const OutputFile& file : *files) print_result(file.path.string(), quiet);
  return Done{};
}

}  // namespace relievo::cli
