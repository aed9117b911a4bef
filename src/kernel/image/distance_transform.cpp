#include "kernel/image/distance_transform.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace relievo {
namespace {

/// Larger than any side, small enough that the sum of two squares of sides fits.
constexpr int far_away = 1 << 15;

/// Computes the distance of each pixel to the nearest pixel of the mask in the same column.
Image<int32_t> column_distances(const Image8& mask) {
  const int w = mask.width;
  Image<int32_t> distance(w, mask.height, 1, far_away);
  for (int y = 0; y < mask.height; ++y) {
    const uint8_t* seed = &mask.at(0, y);
    int32_t* row = &distance.at(0, y);
    const int32_t* above = y > 0 ? row - w : row;
    for (int x = 0; x < w; ++x) row[x] = seed[x] != 0 ? 0 : std::min(far_away, above[x] + 1);
  }
  for (int y = mask.height - 2; y >= 0; --y) {
    int32_t* row = &distance.at(0, y);
    for (int x = 0; x < w; ++x) row[x] = std::min(row[x], row[x + w] + 1);
  }
  return distance;
}

/// The lower envelope of the parabolas (x - i)^2 + g[i]^2 along a row, where g is the distance in
/// the column.
class RowEnvelope {
 public:
  explicit RowEnvelope(int width) : apex_(width), start_(width), squares_(width) {}

  /// Replaces g by the squared distances in the plane.
  void replace_by_distances(int32_t* row, int width) {
    for (int i = 0; i < width; ++i) squares_[i] = row[i] < far_away ? row[i] * row[i] : 0;
    collect(row, width);
    if (last_ < 0) return std::fill(row, row + width, no_distance);
    for (int x = width - 1, q = last_; x >= 0; --x) {
      row[x] = height(x, apex_[q]);
      if (x == start_[q]) --q;
    }
  }

 private:
  void collect(const int32_t* row, int width) {
    last_ = -1;
    for (int x = 0; x < width; ++x) {
      if (row[x] >= far_away) continue;
      while (last_ >= 0 && height(start_[last_], apex_[last_]) > height(start_[last_], x)) --last_;
      const int start = last_ < 0 ? 0 : 1 + crossing(apex_[last_], x);
      if (start >= width) continue;
      ++last_;
      apex_[last_] = x;
      start_[last_] = start;
    }
  }

  int32_t height(int32_t x, int32_t apex) const { return (x - apex) * (x - apex) + squares_[apex]; }

  /// Returns the last x at which the parabola of i is not above that of j > i.
  int32_t crossing(int32_t i, int32_t j) const {
    const int64_t numerator = int64_t{j} * j - int64_t{i} * i + squares_[j] - squares_[i];
    if (numerator < 0) return -1;
    // Less than two squares of sides; a division of 32 bits is several times faster.
    return static_cast<int32_t>(static_cast<uint32_t>(numerator) /
                                static_cast<uint32_t>(2 * (j - i)));
  }

  std::vector<int> apex_;
  std::vector<int> start_;
  std::vector<int32_t> squares_;
  int last_ = -1;
};

}  // namespace

Image<int32_t> squared_distance_to(const Image8& mask) {
  assert(mask.channels == 1 && mask.width < far_away && mask.height < far_away);
  if (mask.empty()) return {};
  Image<int32_t> distance = column_distances(mask);
  RowEnvelope envelope(mask.width);
  for (int y = 0; y < mask.height; ++y)
    envelope.replace_by_distances(&distance.at(0, y), mask.width);
  return distance;
}

Image8 pixels_within(const Image8& mask, int distance) {
  const Image<int32_t> away = squared_distance_to(mask);
  Image8 near(mask.width, mask.height, 1);
  for (size_t i = 0; i < near.pixels.size(); ++i)
    near.pixels[i] = away.pixels[i] <= distance * distance ? 1 : 0;
  return near;
}

}  // namespace relievo
