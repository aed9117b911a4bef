#include "kernel/image/label_rings.h"

#include <array>

namespace relievo {
namespace {

/// A side of a pixel: 0 top, 1 right, 2 bottom, 3 left, travelled clockwise.
struct Side {
  int x = 0;
  int y = 0;
  int side = 0;
  friend bool operator==(const Side&, const Side&) = default;
};

constexpr std::array<int, 4> normal_x = {0, 1, 0, -1};
constexpr std::array<int, 4> normal_y = {-1, 0, 1, 0};

class RingTracer {
 public:
  explicit RingTracer(const Image16& labels)
      : labels_(labels), visited_(labels.width, labels.height, 1) {}

  std::vector<LabelRing> trace() {
    std::vector<LabelRing> rings;
    for (int y = 0; y < labels_.height; ++y)
      for (int x = 0; x < labels_.width; ++x) {
        if (is_inside(x, y)) continue;
        for (int side = 0; side < 4; ++side)
          if (starts_ring({x, y, side})) rings.push_back(ring({x, y, side}));
      }
    return rings;
  }

 private:
  uint16_t label(int x, int y) const {
    const bool inside = x >= 0 && y >= 0 && x < labels_.width && y < labels_.height;
    return inside ? labels_.at(x, y) : uint16_t{0};
  }
  uint16_t beyond(const Side& s) const {
    return label(s.x + normal_x[s.side], s.y + normal_y[s.side]);
  }
  /// Whether no ring runs along the pixel.
  bool is_inside(int x, int y) const {
    const uint16_t* p = &labels_.at(x, y);
    if (*p == 0) return true;
    if (x == 0 || y == 0 || x + 1 == labels_.width || y + 1 == labels_.height) return false;
    const int w = labels_.width;
    return p[-1] == *p && p[1] == *p && p[-w] == *p && p[w] == *p;
  }
  bool starts_ring(const Side& s) const {
    const uint16_t own = labels_.at(s.x, s.y);
    return own != 0 && beyond(s) != own && (visited_.at(s.x, s.y) & (1U << s.side)) == 0;
  }

  /// The side that follows: around the corner of the same pixel, straight on, or inwards.
  Side next(const Side& s) const {
    const int turn = (s.side + 1) % 4;
    const uint16_t own = labels_.at(s.x, s.y);
    const int ahead_x = s.x + normal_x[turn];
    const int ahead_y = s.y + normal_y[turn];
    if (label(ahead_x, ahead_y) != own) return {s.x, s.y, turn};
    const int across_x = ahead_x + normal_x[s.side];
    const int across_y = ahead_y + normal_y[s.side];
    if (label(across_x, across_y) != own) return {ahead_x, ahead_y, s.side};
    return {across_x, across_y, (s.side + 3) % 4};
  }

  LabelRing ring(const Side& start) {
    LabelRing ring;
    ring.label = labels_.at(start.x, start.y);
    Side s = start;
    double area = 0;
    do {
      visited_.at(s.x, s.y) = static_cast<uint8_t>(visited_.at(s.x, s.y) | (1U << s.side));
      ring.sides.push_back(
          {s.x + 0.5 + 0.5 * normal_x[s.side], s.y + 0.5 + 0.5 * normal_y[s.side]});
      ring.beyond.push_back(beyond(s));
      // The divergence theorem on vertical sides, which are one unit long.
      area += normal_x[s.side] * ring.sides.back().x;
      s = next(s);
    } while (!(s == start));
    ring.hole = area < 0;
    return ring;
  }

  const Image16& labels_;
  Image8 visited_;  ///< per pixel, one bit a side
};

}  // namespace

std::vector<LabelRing> trace_label_rings(const Image16& labels) {
  return RingTracer(labels).trace();
}

}  // namespace relievo
