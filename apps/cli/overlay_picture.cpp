#include "apps/cli/overlay_picture.h"

#include <algorithm>
#include <cmath>

#include "io/image/png.h"
#include "io/svg/render_svg.h"
#include "kernel/image/compose.h"
#include "kernel/image/image_size.h"

namespace relievo::cli {
namespace {

/// Minimum size of the picture, so that lines of small drawings stay distinct, px.
constexpr double overlay_side = 1200;

/// Enlarges the drawing and lays the overlay on it. The background is white, or grey for a drawing
/// with white lines.
Image8 composed(const Image8& drawing, const Image8& overlay) {
  const int background = is_light_on_nothing(drawing) ? 96 : 255;
  Image8 picture(overlay.width, overlay.height, 3);
  for (int y = 0; y < overlay.height; ++y)
    for (int x = 0; x < overlay.width; ++x) {
      const int sx = std::min(drawing.width - 1, x * drawing.width / overlay.width);
      const int sy = std::min(drawing.height - 1, y * drawing.height / overlay.height);
      for (int c = 0; c < 3; ++c) {
        const uint8_t seen = lay_over(drawing.at(sx, sy, c), background, drawing.at(sx, sy, 3));
        picture.at(x, y, c) = lay_over(overlay.at(x, y, c), seen, overlay.at(x, y, 3));
      }
    }
  return picture;
}

Image8 white_canvas(const Scene& scene) {
  const ImageSize size = fitted_size(scene.width, scene.height, overlay_side);
  return {size.width, size.height, 4, 255};
}

}  // namespace

Result<Bytes> draw_overlay(const Scene& scene, const OverlayMarks& marks, const Image8& drawing) {
  if (drawing.pixels.empty()) return draw_overlay(scene, marks, white_canvas(scene));
  const double scale =
      std::max(1.0, std::round(overlay_side / std::max(drawing.width, drawing.height)));
  const understanding::PaintableSvg lines{overlay_svg(scene, marks), scene.width, scene.height};
  const auto overlay = render_svg(lines, static_cast<int>(drawing.width * scale),
                                  static_cast<int>(drawing.height * scale));
  if (!overlay) return overlay.error();
  return encode_png(composed(drawing, overlay->rgba));
}

}  // namespace relievo::cli
