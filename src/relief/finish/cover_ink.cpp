#include "relief/finish/cover_ink.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace relievo::relief {
namespace {

/// The way from each pixel to about the nearest pixel of paint of its part, in two sweeps over the
/// picture that pass ways on to neighbours (P.-E. Danielsson, Euclidean distance mapping, 1980).
class NearestPaint {
 public:
  NearestPaint(const Image16& front, const Image8& ink)
      : front_(front), way_(front.width, front.height, 2, far) {
    for (int y = 0; y < way_.height; ++y)
      for (int x = 0; x < way_.width; ++x)
        if (front.at(x, y) != 0 && ink.at(x, y) == 0) set(x, y, 0, 0);
    for (int y = 0; y < way_.height; ++y) sweep(y, 1);
    for (int y = way_.height - 1; y >= 0; --y) sweep(y, -1);
  }

  /// Returns whether there is paint of a pixel's part.
  bool is_known(int x, int y) const { return way_.at(x, y) != far; }

  std::array<int, 2> way(int x, int y) const { return {way_.at(x, y, 0), way_.at(x, y, 1)}; }

 private:
  static constexpr int16_t far = INT16_MAX;

  void set(int x, int y, int dx, int dy) {
    way_.at(x, y, 0) = static_cast<int16_t>(dx);
    way_.at(x, y, 1) = static_cast<int16_t>(dy);
  }

  /// Takes the ways of the row before in this direction and of neighbours in the row.
  void sweep(int y, int down) {
    for (int x = 0; x < way_.width; ++x) {
      for (const int dx : {-1, 0, 1}) relax(x, y, dx, -down);
      relax(x, y, -1, 0);
    }
    for (int x = way_.width - 1; x >= 0; --x) relax(x, y, 1, 0);
  }

  /// Goes by a neighbour if that is nearer.
  void relax(int x, int y, int dx, int dy) {
    const int u = x + dx;
    const int v = y + dy;
    if (u < 0 || v < 0 || u >= way_.width || v >= way_.height || !is_known(u, v)) return;
    if (front_.at(x, y) != 0 && front_.at(u, v) != front_.at(x, y)) return;
    const auto [a, b] = way(u, v);
    const auto [c, d] = way(x, y);
    const auto squared = [](int i, int j) { return i * i + j * j; };
    if (!is_known(x, y) || squared(a + dx, b + dy) < squared(c, d)) set(x, y, a + dx, b + dy);
  }

  const Image16& front_;
  Image<int16_t> way_;  ///< x and y
};

}  // namespace

void cover_ink(const Image16& front, const Image8& ink, const Image8& near, Image8& rgba) {
  const NearestPaint nearest(front, ink);
  const auto is_paint = [&](int x, int y, uint16_t part) {
    return x >= 0 && y >= 0 && x < rgba.width && y < rgba.height && front.at(x, y) == part &&
           ink.at(x, y) == 0;
  };
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      if (ink.at(x, y) == 0 && (front.at(x, y) != 0 || near.at(x, y) == 0)) continue;
      if (!nearest.is_known(x, y)) continue;
      const auto [dx, dy] = nearest.way(x, y);
      const uint16_t part = front.at(x + dx, y + dy);
      const int far = is_paint(x + 2 * dx, y + 2 * dy, part) ? 2 : 1;
      std::copy_n(&rgba.at(x + far * dx, y + far * dy), 4, &rgba.at(x, y));
    }
}

}  // namespace relievo::relief
