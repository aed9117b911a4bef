#include "io/image/row_average.h"

#include <algorithm>
#include <cassert>

namespace relievo {
namespace {

/// More px a side would overflow the sums.
constexpr int max_factor = 256;

uint8_t rounded(uint32_t sum, uint32_t count) {
  return static_cast<uint8_t>((sum + count / 2) / count);
}

}  // namespace

int reduction_factor(int64_t width, int64_t height) {
  int64_t factor = 1;
  while (factor < max_factor && (factor + 1) * (factor + 1) * kept_pixels <= width * height)
    ++factor;
  return static_cast<int>(factor);
}

RowAverage::RowAverage(int width, int height, int factor)
    : width_(width),
      height_(height),
      factor_(factor),
      sums_(factor > 1 ? static_cast<size_t>(reduced_side(width, factor)) : 0),
      reduced_(reduced_side(width, factor), reduced_side(height, factor), 4) {
  assert(factor >= 1 && factor <= max_factor);
}

void RowAverage::add(const uint8_t* row) {
  assert(added_ < height_);
  const int y = added_ / factor_;
  ++added_;
  if (factor_ == 1) {
    std::copy_n(row, size_t{4} * static_cast<size_t>(width_), &reduced_.at(0, y));
    return;
  }
  sum_up(row);
  if (added_ % factor_ == 0 || added_ == height_) write_row(y, added_ - y * factor_);
}

void RowAverage::sum_up(const uint8_t* row) {
  const uint8_t* const end = row + size_t{4} * static_cast<size_t>(width_);
  for (Sum& total : sums_) {
    Sum sum = total;
    const uint8_t* const next = std::min(end - row, ptrdiff_t{4} * factor_) + row;
    for (; row != next; row += 4) {
      const uint32_t alpha = row[3];
      sum.red += row[0] * alpha;
      sum.green += row[1] * alpha;
      sum.blue += row[2] * alpha;
      sum.alpha += alpha;
    }
    total = sum;
  }
}

void RowAverage::write_row(int y, int rows) {
  int x = 0;
  for (Sum& sum : sums_) {
    uint8_t* out = &reduced_.at(x, y);
    const int columns = std::min(factor_, width_ - x * factor_);
    if (sum.alpha > 0) {
      out[0] = rounded(sum.red, sum.alpha);
      out[1] = rounded(sum.green, sum.alpha);
      out[2] = rounded(sum.blue, sum.alpha);
      out[3] = rounded(sum.alpha, static_cast<uint32_t>(rows * columns));
    }
    sum = {};
    ++x;
  }
}

Image8 averaged(Image8 rgba, int factor) {
  if (factor == 1) return rgba;
  RowAverage average(rgba.width, rgba.height, factor);
  for (int y = 0; y < rgba.height; ++y) average.add(&rgba.at(0, y));
  return average.take();
}

}  // namespace relievo
