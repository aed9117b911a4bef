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

}  // namespace relievo
