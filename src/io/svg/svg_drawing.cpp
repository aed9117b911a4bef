#include "io/svg/svg_drawing.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace relievo {
namespace {

Region clipped(Region region, const SvgShape& shape, const SvgDrawing& drawing) {
  for (const int clip : shape.clips) region = intersect(region, drawing.clips[clip]);
  return region;
}

constexpr double opaque = 0.5;

/// Least share of a shape over others that makes it paint.
constexpr double least_below = 0.01;
/// Least share of the canvas that paper covers.
constexpr double paper_share = 0.95;

bool is_visible(const std::optional<Color>& paint, double least) {
  return paint && paint->a >= least;
}

/// Returns the area of the canvas that the shape's paint makes opaque.
Region painted_region(const SvgShape& shape, const SvgDrawing& drawing) {
  const Region fill = is_visible(shape.fill, opaque) ? fill_of(shape, drawing) : Region();
  return is_visible(shape.stroke, opaque) ? unite(fill, stroke_of(shape, drawing)) : fill;
}

Box2 box_of(const SvgShape& shape) {
  Box2 box;
  for (const Polyline& line : shape.lines) box.add(bounding_box(line.points));
  const double reach = shape.stroke ? shape.pen.width / 2 : 0;
  return {box.min - Point2{reach, reach}, box.max + Point2{reach, reach}};
}

understanding::Mark mark_of(const SvgShape& shape, const SvgDrawing& drawing, double least) {
  understanding::Mark mark;
  mark.name = shape.name.empty() ? inherited_name(drawing, shape.group) : shape.name;
  mark.group = shape.group;
  mark.blurred = shape.blurred;
  mark.pen_width = shape.pen.width;
  const bool stroked = is_visible(shape.stroke, least);
  // A line around the faintest paint makes a body of it.
  mark.filled = is_visible(shape.fill, stroked ? faint_alpha : least);
  const Region stroke = stroked ? stroke_of(shape, drawing) : Region();
  if (mark.filled) {
    mark.color = *shape.fill;
    mark.region = unite(fill_of(shape, drawing), stroke);
    mark.outlined =
        (shape.picture && shape.picture->outlined) ||
        (stroked && color_distance(*shape.fill, *shape.stroke) > understanding::color_contrast);
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
    mark.blends = is_paint(*shape, drawing);
    marks.push_back(std::move(mark));
  }
  return marks;
}

}  // namespace

Region fill_of(const SvgShape& shape, const SvgDrawing& drawing) {
  Region filled = fill_region(shape.lines, shape.fill_rule, drawing.canvas());
  if (shape.picture) filled = intersect(filled, shape.picture->opaque);
  return clipped(std::move(filled), shape, drawing);
}

Region stroke_of(const SvgShape& shape, const SvgDrawing& drawing) {
  if (!shape.stroke) return {};
  const Box2 canvas = drawing.canvas();
  if (!shape.pen_frame)
    return clipped(stroke_region(shape.lines, shape.pen, canvas), shape, drawing);
  const Affine2 to_frame = inverse(*shape.pen_frame);
  Box2 bounds;
  for (const Point2 p : rectangle_line(canvas, to_frame).points) bounds.add(p);
  const Region round = stroke_region(mapped(shape.lines, to_frame), shape.pen, bounds);
  return clipped(mapped_region(round, *shape.pen_frame, canvas), shape, drawing);
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

Region opaque_region(const std::vector<SvgShape>& shapes, const SvgDrawing& drawing) {
  std::vector<Region> regions;
  for (const SvgShape& shape : shapes) regions.push_back(painted_region(shape, drawing));
  return unite(regions);
}

bool is_paint(const SvgShape& shape, const SvgDrawing& drawing) {
  const bool covers = shape.picture && !shape.picture->has_holes;
  if (!covers && shape.backdrop.begin == shape.backdrop.end) return false;
  const auto begin = drawing.shapes.begin();
  const auto self = begin + (&shape - drawing.shapes.data());
  const auto first = covers ? begin : begin + static_cast<std::ptrdiff_t>(shape.backdrop.begin);
  const auto last = covers ? self : begin + static_cast<std::ptrdiff_t>(shape.backdrop.end);
  const Region region = painted_region(shape, drawing);
  const Box2 box = bounding_box(region);
  const double least = least_below * area(region);
  const double whole = drawing.width * drawing.height;
  return std::any_of(first, last, [&](const SvgShape& below) {
    if (below.is_note() || !boxes_meet(box, box_of(below))) return false;
    const Region other = painted_region(below, drawing);
    return area(other) < paper_share * whole && area(intersect(region, other)) > least;
  });
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
