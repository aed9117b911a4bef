#include "understanding/marks/make_parts.h"

#include <algorithm>
#include <string>
#include <utility>

#include "scene/part_ids.h"
#include "understanding/marks/propose_parts.h"
#include "understanding/marks/silhouettes.h"

namespace relievo::understanding {
namespace {

/// Least number of parts, some over others, that make a layer a drawing of several parts.
constexpr size_t parts_of_drawing = 4;
/// Least common area of two parts of which one lies over the other / area of the smaller one.
constexpr double least_overlap = 0.05;
/// Least area of traced ink with its holes filled / its own area.
constexpr double enclosing = 2;

Box2 canvas_of(const Scene& scene) { return {{0, 0}, {scene.width, scene.height}}; }

bool some_overlap(const std::vector<Part>& parts) {
  for (size_t i = 0; i < parts.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const double smaller = std::min(area(parts[i].outline), area(parts[j].outline));
      if (area(intersect(parts[i].outline, parts[j].outline)) > least_overlap * smaller)
        return true;
    }
  }
  return false;
}

bool holds_several_parts(std::vector<Mark> layer, const Box2& canvas) {
  std::vector<Palette> colors;
  const std::vector<Part> parts =
      propose_parts(group_silhouettes(std::move(layer), canvas), colors);
  return parts.size() >= parts_of_drawing && some_overlap(parts);
}

/// Returns whether some pixel is at least half opaque.
bool shows_something(const Image8& rgba) {
  for (size_t i = 3; i < rgba.pixels.size(); i += 4)
    if (rgba.pixels[i] >= 128) return true;
  return false;
}

/// Returns whether lines of one colour enclose more than they cover, as those of traced ink do.
bool is_traced_ink(const SilhouetteList& list) {
  for (const Silhouette& silhouette : list.silhouettes)
    if (color_distance(silhouette.color, list.silhouettes[0].color) > color_contrast) return false;
  return area(without_holes(list.covered)) > enclosing * area(list.covered);
}

Status propose(LayeredDrawing& drawing, size_t max_marks) {
  if (drawing.marks.size() > max_marks)
    return Error{ErrorCode::limit,
                 "has more than " + std::to_string(max_marks) +
                     " shapes, too many to propose parts from; group the shapes of each part and "
                     "mark the group with data-relievo=\"part\"",
                 ""};
  drawing.line_art =
      !drawing.marks.empty() && std::none_of(drawing.marks.begin(), drawing.marks.end(),
                                             [](const Mark& mark) { return mark.filled; });
  SilhouetteList silhouettes =
      group_silhouettes(std::exchange(drawing.marks, {}), canvas_of(drawing.scene));
  drawing.line_art |= is_traced_ink(silhouettes);
  drawing.scene.parts = propose_parts(silhouettes, drawing.colors);
  drawing.left_out = std::move(silhouettes.left_out);
  drawing.proposed = true;
  drawing.flat = silhouettes.silhouettes.size() < 2 && shows_something(drawing.picture.rgba);
  drawing.warnings.insert(drawing.warnings.end(), silhouettes.notes.begin(),
                          silhouettes.notes.end());
  return Done{};
}

}  // namespace

void settle_layers(LayeredDrawing& drawing) {
  if (drawing.layers.empty()) return;
  const Box2 canvas = canvas_of(drawing.scene);
  const bool several =
      std::any_of(drawing.layers.begin(), drawing.layers.end(),
                  [&](const auto& layer) { return holds_several_parts(layer, canvas); });
  drawing.layers.clear();
  if (!several) return drawing.marks.clear();
  drawing.scene.parts.clear();
  drawing.scene.joins.clear();
  drawing.colors.clear();
  if (!drawing.text_with_lines.empty()) drawing.paintable.text = std::move(drawing.text_with_lines);
}

Status make_parts(LayeredDrawing& drawing, size_t max_marks) {
  settle_layers(drawing);
  if (drawing.scene.parts.empty())
    if (Status status = propose(drawing, max_marks); !status) return status;
  if (drawing.scene.parts.empty() && !drawing.flat)
    return Error{ErrorCode::bad_input,
                 "shows nothing opaque on its canvas to make parts of" +
                     (drawing.warnings.empty() ? "" : ": " + drawing.warnings.front()),
                 ""};
  make_ids_unique(drawing.scene.parts);
  return Done{};
}

}  // namespace relievo::understanding
