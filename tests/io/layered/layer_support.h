#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/layered/compose_layers.h"
#include "kernel/geometry/polygon.h"
#include "understanding/marks/make_parts.h"

namespace relievo {

using Rgba = std::vector<uint8_t>;

inline const Rgba red = {200, 40, 40, 255};
inline const Rgba blue = {40, 60, 200, 255};
inline const Rgba black = {0, 0, 0, 255};

inline Image8 transparent(int width, int height) { return {width, height, 4}; }

/// A filled disc with a smooth edge, as a painting program makes it.
inline void paint_disc(Image8& image, Point2 centre, double radius, const Rgba& color) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double inside = radius - distance({x + 0.5, y + 0.5}, centre) + 0.5;
      if (inside <= 0) continue;
      for (int k = 0; k < 3; ++k) image.at(x, y, k) = color[k];
      image.at(x, y, 3) = static_cast<uint8_t>(color[3] * (inside < 1 ? inside : 1) + 0.5);
    }
}

inline Image8 disc(int width, int height, Point2 centre, double radius, const Rgba& color) {
  Image8 image = transparent(width, height);
  paint_disc(image, centre, radius, color);
  return image;
}

inline RasterLayer layer(const std::string& name, Image8 rgba) {
  RasterLayer layer;
  layer.name = name;
  layer.rgba = std::move(rgba);
  return layer;
}

/// The drawing of a stack whose layers have their pixels.
inline Result<understanding::LayeredDrawing> composed(int width, int height,
                                                      const LayerStack& stack) {
  return compose_layers({width, height}, stack,
                        [&](size_t k) -> Result<Image8> { return stack.layers[k].rgba; }, {});
}

/// The drawing of layers that lie on each other, back to front.
inline understanding::LayeredDrawing drawing_of(int width, int height,
                                                const std::vector<RasterLayer>& layers) {
  auto drawing = composed(width, height, {{}, layers});
  return drawing ? std::move(*drawing) : understanding::LayeredDrawing();
}

/// The names of the drawing's parts (see make_parts).
inline std::vector<std::string> part_names(understanding::LayeredDrawing& drawing) {
  std::vector<std::string> names;
  if (!understanding::make_parts(drawing)) return names;
  for (const Part& part : drawing.scene.parts) names.push_back(part.id);
  return names;
}

inline double part_area(const Part& part) {
  double sum = 0;
  for (const Ring& ring : part.outline) sum += signed_area(ring);
  return sum;
}

}  // namespace relievo
