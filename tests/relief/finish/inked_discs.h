#pragma once

#include <algorithm>
#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"
#include "support/analytic_discs.h"

namespace relievo::relief {

constexpr int ink_canvas_width = 320;
constexpr int ink_canvas_height = 240;

/// A drawing of discs, back to front, in light paint, with a line of the given widths inside and
/// outside each outline, on transparent paper. `scale`: px of the drawing per px of the canvas.
inline Drawing draw_inked(const std::vector<Disc>& discs, double inside, double outside,
                          int scale = 1) {
  Drawing drawing{Image8(scale * ink_canvas_width, scale * ink_canvas_height, 4)};
  for (int y = 0; y < drawing.rgba.height; ++y)
    for (int x = 0; x < drawing.rgba.width; ++x)
      for (const Disc& disc : discs) {
        uint8_t* rgba = &drawing.rgba.at(x, y);
        const double r = distance({(x + 0.5) / scale, (y + 0.5) / scale}, disc.centre);
        if (r > disc.radius + (rgba[3] == 0 ? 0 : outside)) continue;
        std::fill_n(rgba, 3, r > disc.radius - inside ? 20 : 200);
        rgba[3] = 255;
      }
  return drawing;
}

inline Model disc_model(const std::vector<Disc>& discs) {
  return assemble(make_discs(discs, ink_canvas_width, ink_canvas_height, 4), Visibility::orbit);
}

}  // namespace relievo::relief
