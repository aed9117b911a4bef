#include "io/svg/svg_drawing.h"

namespace relievo {
namespace {

Region clipped(Region region, const SvgShape& shape, const SvgDrawing& drawing) {
  for (const int clip : shape.clips) region = intersect(region, drawing.clips[clip]);
  return region;
}

}  // namespace

Region fill_of(const SvgShape& shape, const SvgDrawing& drawing) {
  return clipped(fill_region(shape.lines, shape.fill_rule, drawing.canvas()), shape, drawing);
}

Region stroke_of(const SvgShape& shape, const SvgDrawing& drawing) {
  if (!shape.stroke) return {};
  return clipped(stroke_region(shape.lines, shape.pen, drawing.canvas()), shape, drawing);
}

}  // namespace relievo
