#include "io/svg/svg_marks.h"

#include <utility>

namespace relievo {
namespace {

constexpr double opaque = 0.5;

bool is_visible(const std::optional<Color>& paint, double least) {
  return paint && paint->a >= least;
}

Mark mark_of(const SvgShape& shape, const SvgDrawing& drawing, double least) {
  Mark mark;
  mark.name = shape.name.empty() ? inherited_name(drawing, shape.group) : shape.name;
  mark.group = shape.group;
  mark.blurred = shape.blurred;
  mark.pen_width = shape.pen.width;
  mark.filled = is_visible(shape.fill, least);
  const bool stroked = is_visible(shape.stroke, least);
  const Region stroke = stroked ? stroke_of(shape, drawing) : Region();
  if (mark.filled) {
    mark.color = *shape.fill;
    mark.region = unite(fill_of(shape, drawing), stroke);
    mark.outlined = stroked && color_distance(*shape.fill, *shape.stroke) > color_contrast;
  } else if (stroked) {
    mark.color = *shape.stroke;
    mark.region = stroke;
  }
  return mark;
}

std::vector<Mark> visible_marks(const SvgDrawing& drawing, double least) {
  std::vector<Mark> marks;
  for (const SvgShape& shape : drawing.shapes) {
    if (shape.is_note() || inherited_mark(drawing, shape.group) >= SvgMark::texture) continue;
    Mark mark = mark_of(shape, drawing, least);
    if (mark.region.empty()) continue;
    marks.push_back(std::move(mark));
  }
  return marks;
}

}  // namespace

std::vector<Mark> opaque_marks(const SvgDrawing& drawing) {
  std::vector<Mark> marks = visible_marks(drawing, opaque);
  return marks.empty() ? visible_marks(drawing, faint_alpha) : marks;
}

SvgMark inherited_mark(const SvgDrawing& drawing, int group) {
  for (; group >= 0; group = drawing.groups[group].parent) {
    const SvgMark mark = drawing.groups[group].annotation.mark;
    if (mark != SvgMark::none) return mark;
  }
  return SvgMark::none;
}

std::string inherited_name(const SvgDrawing& drawing, int group) {
  for (; group >= 0; group = drawing.groups[group].parent) {
    const SvgGroup& g = drawing.groups[group];
    if (!g.label.empty() || !g.id.empty()) return g.label.empty() ? g.id : g.label;
  }
  return "";
}

}  // namespace relievo
