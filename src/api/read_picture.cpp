#include "api/read_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "io/files/number_text.h"
#include "io/files/paths.h"
#include "io/image/animation.h"
#include "io/image/decode_image.h"
#include "relievo/read.h"
#include "understanding/labels/segment_drawing.h"
#include "understanding/scene/understand_drawing.h"

namespace relievo {
namespace {

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

/// Summarises what was found.
std::string summary(const Image16& labels, const Scene& scene) {
  const auto background = std::count(labels.pixels.begin(), labels.pixels.end(), 0);
  const double covered =
      1 - static_cast<double>(background) / static_cast<double>(labels.pixels.size());
  return "the picture was understood as " + counted(scene.parts.size(), "part") + " with " +
         counted(scene.joins.size(), "join") + "; they cover " + percent(covered) + " of it";
}

/// Names the most doubtful decision, and the ways to correct it.
std::string advice(const understanding::SegmentationRecord& record, const std::string& file) {
  const std::vector<understanding::OrderArrow>& arrows = record.order;
  const auto doubtful =
      std::min_element(arrows.begin(), arrows.end(),
                       [](const understanding::OrderArrow& a, const understanding::OrderArrow& b) {
                         return a.confidence < b.confidence;
                       });
  std::string doubt;
  if (doubtful != arrows.end()) {
    std::map<understanding::PartLabel, std::string> id_of;
    for (const understanding::PartRecord& part : record.parts) id_of[part.label] = part.id;
    doubt = "the most doubtful decision is that " + id_of[doubtful->upper] + " lies before " +
            id_of[doubtful->lower] + " (" + percent((1 + doubtful->confidence) / 2) + "); ";
  }
  return doubt + "look with --overlay, correct with strokes: relievo segment " + file +
         " --scribbles strokes.png, or in the editor";
}

DrawnScene drawn(SceneInput input) {
  return {std::move(input.scene), std::move(input.drawing), std::move(input.files),
          std::move(input.warnings), input.proposed};
}

}  // namespace

std::string fitting_note(const FittedImage& picture) {
  const std::string size =
      std::to_string(picture.rgba.width) + " x " + std::to_string(picture.rgba.height) + " px, ";
  if (picture.factor > 1)
    return "the picture was reduced to " + size + "1/" + std::to_string(picture.factor) +
           " of its size; parts and texture need no more";
  if (picture.times > 1)
    return "the picture is small: each of its pixels became " + std::to_string(picture.times) +
           " x " + std::to_string(picture.times) + ", which makes " + size +
           "so that its parts can be found";
  return "";
}

Result<SceneInput> understand_flat(Drawing drawing, const std::string& file, bool connect,
                                   const RunContext& context) {
  auto found = understanding::segment_drawing(drawing, {}, context);
  if (!found) return found.error();
  auto understood =
      understanding::understand_drawing(drawing.rgba, std::move(*found), {}, {}, context);
  if (!understood) return understood.error();
  SceneInput loaded{std::move(understood->scene), std::move(drawing)};
  loaded.drawing_file = file;
  loaded.proposed = true;
  loaded.understood = {summary(understood->record.labels, loaded.scene),
                       advice(understood->record, file)};
  loaded.warnings = std::move(understood->warnings);
  if (connect) {
    loaded.guesses = std::move(understood->proposal.joining);
  } else {
    loaded.scene.joins.clear();
    loaded.scene.relations.clear();
    loaded.scene.robin.clear();
  }
  return loaded;
}

Result<SceneInput> understand_fitted(FittedImage picture, const std::string& file, bool connect,
                                     const RunContext& context) {
  const std::string note = fitting_note(picture);
  auto loaded = understand_flat({std::move(picture.rgba)}, file, connect, context);
  if (loaded && !note.empty()) loaded->understood.insert(loaded->understood.begin(), note);
  return loaded;
}

Result<SceneInput> read_picture(const InputFile& input, bool connect, const RunContext& context) {
  auto picture = decode_fitted(input.bytes);
  if (!picture) return picture.error();
  auto loaded = understand_fitted(std::move(*picture), input.name, connect, context);
  if (!loaded) return in_first_frame(loaded.error(), input.bytes);
  if (std::string warning = first_frame_warning(input.bytes); !warning.empty())
    loaded->warnings.push_back(std::move(warning));
  return loaded;
}

Result<DrawnScene> read_drawing(const std::filesystem::path& path, const RunContext& context) {
  const auto file = read_input(path.string());
  if (!file) return file.error();
  auto input = load_scene(*file, true, context);
  if (!input) return input.error();
  return drawn(std::move(*input));
}

Result<DrawnScene> understand_picture(const std::filesystem::path& path,
                                      const RunContext& context) {
  const auto file = read_input(path.string());
  if (!file) return file.error();
  auto input = read_picture(*file, true, context);
  if (!input) return in_file(input.error(), file->name);
  input->files = {path};
  return drawn(std::move(*input));
}

}  // namespace relievo
