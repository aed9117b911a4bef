#include "relief/finish/model_texture.h"

#include <cstdint>

#include "kernel/image/compose.h"
#include "kernel/image/morphology.h"
#include "relief/finish/fill_triangle.h"
#include "relief/finish/spread_colours.h"

namespace relievo::relief {
namespace {

/// Chebyshev distance from a pixel that is not covered.
constexpr int silhouette_band = 2;

/// Returns the drawing on white. Pixels that are not known take the colour of the nearest known.
template <class IsKnown>
Image8 spread_texture(const Image8& rgba, IsKnown is_known) {
  Image8 texture(rgba.width, rgba.height, 3, 255);
  Image8 known(rgba.width, rgba.height, 1);
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const int alpha = rgba.at(x, y, 3);
      if (!is_known(x, y, alpha)) continue;
      known.at(x, y) = 1;
      for (int c = 0; c < 3; ++c) texture.at(x, y, c) = on_paper(rgba.at(x, y, c), alpha);
    }
  spread_colours(known, texture);
  return texture;
}

}  // namespace

Image8 model_texture(const Model& model, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  if (rgba.empty()) return {};
  const bool keeps_colours = drawing.pixel_art > 0;
  const Image8 near =
      max_filter(uncovered_pixels(model, {rgba.width, rgba.height}), silhouette_band);
  return spread_texture(rgba, [&](int x, int y, int alpha) {
    return keeps_colours ? alpha >= 128 : alpha == 255 || near.at(x, y) == 0;
  });
}

Image8 outline_texture(const Model& model, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  const Image8 open = uncovered_pixels(model, {rgba.width, rgba.height});
  const Image8 near = max_filter(open, silhouette_band);
  return spread_texture(rgba, [&](int x, int y, int alpha) {
    return open.at(x, y) == 0 && (alpha == 255 || near.at(x, y) == 0);
  });
}

}  // namespace relievo::relief
