#include "io/svg/svg_drawing.h"

#include <utility>

namespace relievo {
namespace {

Region clipped(Region region, const SvgShape& shape, const SvgDrawing& drawing) {
  for (const int clip : shape.clips) region = intersect(region, drawing.clips[clip]);
  return region;
}

constexpr double opaque = 0.5;

bool is_visible(const std::optional<Color>& paint, double least) {
  return paint && paint->a >= least;
}

understanding::Mark mark_of(const SvgShape& shape, const SvgDrawing& drawing, double least) {
  understanding::Mark mark;
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
    mark.outlined =
        stroked && color_distance(*shape.fill, *shape.stroke) > understanding::color_contrast;
  } else if (stroked) {
    mark.color = *shape.stroke;
    mark.region = stroke;
  }
  return mark;
}

std::vector<understanding::Mark> visible_marks(const SvgDrawing& drawing,
                                               const std::vector<const SvgShape*>& shapes,
                                               double least) {
  std::vector<understanding::Mark> marks;
  for (const SvgShape* shape : shapes) {
    if (shape->is_note() || inherited_mark(drawing, shape->group) >= SvgMark::texture) continue;
    understanding::Mark mark = mark_of(*shape, drawing, least);
    if (mark.region.empty()) continue;
    marks.push_back(std::move(mark));
  }
  return marks;
}

}  // namespace

Region fill_of(const SvgShape& shape, const SvgDrawing& drawing) {
  return clipped(fill_region(shape.lines, shape.fill_rule, drawing.canvas()), shape, drawing);
}

Region stroke_of(const SvgShape& shape, const SvgDrawing& drawing) {
  if (!shape.stroke) return {};
  return clipped(stroke_region(shape.lines, shape.pen, drawing.canvas()), shape, drawing);
}

Region light_region(const std::vector<SvgShape>& shapes, const SvgDrawing& drawing) {
  Region light;
  const auto paint = [&](const std::optional<Color>& color, const Region& region) {
    if (!color || color->a < 0.5) return;
    light = luminance(*color) * color->a < 0.5 ? subtract(light, region) : unite(light, region);
  };
  for (const SvgShape& shape : shapes) {
    paint(shape.fill, fill_of(shape, drawing));
    paint(shape.stroke, stroke_of(shape, drawing));
  }
  return light;
}

std::vector<understanding::Mark> opaque_marks(const SvgDrawing& drawing,
                                              const std::vector<const SvgShape*>& shapes) {
  std::vector<understanding::Mark> marks = visible_marks(drawing, shapes, opaque);
  return marks.empty() ? visible_marks(drawing, shapes, faint_alpha) : marks;
}

SvgMark inherited_mark(const SvgDrawing& drawing, int group) {
  for (; group >= 0; group = drawing.groups[group].parent) {
    const SvgMark mark = drawing.groups[group].mark;
    if (mark != SvgMark::none) return mark;
  }
  return SvgMark::none;
}

std::string inherited_name(const SvgDrawing& drawing, int group) {
  for (; group >= 0; group = drawing.groups[group].parent) {
    const std::string name = name_of(drawing.groups[group].element);
    if (!name.empty()) return name;
  }
  return "";
}

}  // namespace relievo
