#include "understanding/lines/colour_edges.h"

#include <algorithm>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/morphology.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr int sure_step = 44;      ///< change of a channel over two pixels that is an edge
constexpr int possible_step = 22;  ///< where it continues one
constexpr int flank_margin = 4;    ///< px around lines, whose own flanks are no edges

/// The strongest change of any channel at every pixel of the inside, and whether it is along x.
struct Steps {
  Image8 size;
  Image8 along_x;
};

/// The largest difference of a channel between the pixels of two rows of `width`, by pixel.
class RowDifference {
 public:
  explicit RowDifference(int width) : all_(3 * static_cast<size_t>(width) + 2), largest_(width) {}

  const std::vector<uint8_t>& between(const uint8_t* a, const uint8_t* b) {
    const size_t n = 3 * largest_.size();
    for (size_t i = 0; i < n; ++i) {
      const uint8_t high = a[i] > b[i] ? a[i] : b[i];
      const uint8_t low = a[i] > b[i] ? b[i] : a[i];
      all_[i] = static_cast<uint8_t>(high - low);
    }
    for (size_t x = 0; x < largest_.size(); ++x)
      largest_[x] = std::max({all_[3 * x], all_[3 * x + 1], all_[3 * x + 2]});
    return largest_;
  }

 private:
  std::vector<uint8_t> all_;
  std::vector<uint8_t> largest_;
};

/// Steps where `excluded` is 0.
Steps measure_steps(const Image8& rgb, const Image8& excluded) {
  Steps steps{Image8(rgb.width, rgb.height, 1), Image8(rgb.width, rgb.height, 1)};
  const int inside = rgb.width - 2;
  if (inside <= 0) return steps;
  RowDifference differences_x(inside);
  RowDifference differences_y(inside);
  for (int y = 1; y + 1 < rgb.height; ++y) {
    const std::vector<uint8_t>& along_x = differences_x.between(&rgb.at(2, y), &rgb.at(0, y));
    const std::vector<uint8_t>& along_y =
        differences_y.between(&rgb.at(1, y + 1), &rgb.at(1, y - 1));
    const uint8_t* skip = &excluded.at(1, y);
    uint8_t* size = &steps.size.at(1, y);
    uint8_t* is_x = &steps.along_x.at(1, y);
    for (int x = 0; x < inside; ++x) {
      const int dx = along_x[x];
      const int dy = along_y[x];
      const int sum = dx > dy ? dx + dy / 2 : dy + dx / 2;
      size[x] = static_cast<uint8_t>(skip[x] != 0 ? 0 : std::min(255, sum));
      is_x[x] = dx >= dy ? 1 : 0;
    }
  }
  return steps;
}

/// Steps that are the largest across their edge; 0 elsewhere.
Image8 crests(const Image8& size, const Image8& along_x) {
  Image8 result(size.width, size.height, 1);
  for (int y = 1; y + 1 < size.height; ++y)
    for (int x = 1; x + 1 < size.width; ++x) {
      const uint8_t value = size.at(x, y);
      if (value < possible_step) continue;
      const bool across_x = along_x.at(x, y) != 0;
      const uint8_t before = across_x ? size.at(x - 1, y) : size.at(x, y - 1);
      const uint8_t after = across_x ? size.at(x + 1, y) : size.at(x, y + 1);
      if (value > before && value >= after) result.at(x, y) = value;
    }
  return result;
}

}  // namespace

void add_colour_edges(const Image8& rgb, LineMap& map) {
  const Image8 smooth = box_blur(rgb, map.painted ? 2 : 1);
  const Image8 near_line = max_filter(map.barrier, flank_margin);
  const Steps steps = measure_steps(smooth, near_line);
  const Image8 edges = connected_above(crests(steps.size, steps.along_x), possible_step, sure_step);
  for (size_t i = 0; i < edges.pixels.size(); ++i) {
    if (edges.pixels[i] == 0) continue;
    map.barrier.pixels[i] = LineMap::edge;
    map.ink.pixels[i] = std::max(map.ink.pixels[i], steps.size.pixels[i]);
  }
}

}  // namespace relievo::understanding
