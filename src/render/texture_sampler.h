#pragma once

#include <array>

#include "relievo/image.h"
#include "relievo/point.h"
#include "render/rgb.h"

namespace relievo {

/// Colours of an opaque RGB image between its pixels, in linear light.
class TextureSampler {
 public:
  /// Halves the image while it has more than `max_width` columns by a factor of 2 or more, so that
  /// a picture smaller than the texture does not flicker between its pixels.
  TextureSampler(Image8 rgb, double max_width);

  /// The colour at `uv` in [0, 1]^2, origin top-left; outside, that of the border.
  Rgb at(Point2 uv) const;

 private:
  Rgb pixel(int x, int y) const;

  Image8 rgb_;
  std::array<double, 256> linear_;
};

}  // namespace relievo
