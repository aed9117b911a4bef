#include "understanding/paper/pure_white.h"

#include <algorithm>

#include "kernel/image/components.h"
#include "kernel/image/image_size.h"
#include "kernel/image/outlines.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

/// Minimum share of the picture's border that is pure white for a figure, such as a bust, that the
/// border cuts off.
constexpr double bust_share = 0.6;
/// Share of its box that a figure fills at most; a picture in a frame fills more.
constexpr double framed_share = 0.9;

constexpr int pure_white = 254;  ///< least darkest channel of pure white, of 255

}  // namespace

bool is_on_pure_white(const Image8& rgba) {
  const auto is_white = [&](int x, int y) {
    return rgba.at(x, y, 3) == 0 || darkest_channel(rgba, x, y) >= pure_white;
  };
  return share_of_edge(rgba.width, rgba.height, is_white) >= bust_share &&
         share_of_box(tinted_pixels(rgba)) < framed_share;
}

Image8 tinted_pixels(const Image8& image) {
  Image8 mask(image.width, image.height, 1);
  const bool has_alpha = image.channels == 4;
  const uint8_t* p = image.pixels.data();
  for (uint8_t& tinted : mask.pixels) {
    const bool transparent = has_alpha && p[3] == 0;
    tinted = !transparent && std::min({p[0], p[1], p[2]}) < palest_paint ? 1 : 0;
    p += image.channels;
  }
  return mask;
}

}  // namespace relievo::understanding
