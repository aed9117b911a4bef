#include "kernel/image/morphology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <utility>
#include <vector>

namespace relievo {
namespace {

/// Filters take the larger of two values, or the smaller. The identity never changes the other one.
template <bool larger>
constexpr uint8_t identity = larger ? 0 : 255;

template <bool larger>
uint8_t pick(uint8_t a, uint8_t b) {
  return (larger ? a > b : a < b) ? a : b;
}

template <bool larger>
void pick_rows(const uint8_t* a, const uint8_t* b, uint8_t* out, size_t n) {
  for (size_t i = 0; i < n; ++i) out[i] = pick<larger>(a[i], b[i]);
}

/// Computes extremes of `window` values of a row, `step` apart, by doubling a window while it fits.
template <bool larger>
class RowFilter {
 public:
  RowFilter(size_t n, size_t step, size_t window)
      : n_(n),
        step_(step),
        window_(window),
        padded_(n + (window - 1) * step, identity<larger>),
        wide_(padded_.size()),
        wider_(padded_.size()) {}

  /// Returns the place for the n values of a row; beside them are identities.
  uint8_t* row() { return padded_.data() + window_ / 2 * step_; }

  void run(uint8_t* out) {
    const uint8_t* in = padded_.data();
    size_t size = padded_.size();
    size_t covered = 1;
    for (; 2 * covered <= window_; covered *= 2) {
      size -= covered * step_;
      pick_rows<larger>(in, in + covered * step_, wider_.data(), size);
      std::swap(wide_, wider_);
      in = wide_.data();
    }
    pick_rows<larger>(in, in + (window_ - covered) * step_, out, n_);
  }

 private:
  size_t n_;
  size_t step_;
  size_t window_;
  std::vector<uint8_t> padded_;
  std::vector<uint8_t> wide_;
  std::vector<uint8_t> wider_;
};

/// Filters in one pass over the image. The extremes of `window` rows come from those of blocks of
/// as many rows: from a row to the end of its block, and from the beginning of the next block to a
/// row. Those along rows follow.
template <bool larger>
Image8 filter_squares(const Image8& image, int radius) {
  assert(radius >= 0);
  if (radius == 0 || image.empty()) return image;
  radius = std::min(radius, std::max(image.width, image.height));
  const int window = 2 * radius + 1;
  const size_t n = static_cast<size_t>(image.width) * image.channels;
  const std::vector<uint8_t> outside(n, identity<larger>);
  const auto row = [&](int y) {
    return y < 0 || y >= image.height ? outside.data() : &image.at(0, y);
  };
  std::vector<uint8_t> to_end(n * window);
  RowFilter<larger> rows(n, image.channels, window);
  Image8 result(image.width, image.height, image.channels);
  for (int block = -radius; block < image.height - radius; block += window) {
    const uint8_t* after = outside.data();
    for (int k = window - 1; k >= 0; --k) {
      pick_rows<larger>(row(block + k), after, &to_end[n * k], n);
      after = &to_end[n * k];
    }
    std::vector<uint8_t> from_begin = outside;
    for (int y = block + radius; y < std::min(image.height, block + radius + window); ++y) {
      pick_rows<larger>(&to_end[n * (y - radius - block)], from_begin.data(), rows.row(), n);
      rows.run(&result.at(0, y));
      pick_rows<larger>(from_begin.data(), row(y + radius + 1), from_begin.data(), n);
    }
  }
  return result;
}

/// Returns whether a pixel with this ring of neighbours is removed in the given half of a round.
bool is_removable(uint32_t ring, int half) {
  const int pixels = std::popcount(ring);
  if (pixels < 2 || pixels > 6 || runs_in_ring(ring) != 1) return false;
  const bool up = has_pixel(ring, 0);
  const bool right = has_pixel(ring, 2);
  const bool down = has_pixel(ring, 4);
  const bool left = has_pixel(ring, 6);
  return half == 0 ? !(up && right && down) && !(right && down && left)
                   : !(up && right && left) && !(up && down && left);
}

}  // namespace

Image8 max_filter(const Image8& image, int radius) { return filter_squares<true>(image, radius); }

Image8 min_filter(const Image8& image, int radius) { return filter_squares<false>(image, radius); }

Image8 close_gaps(const Image8& image, int radius) {
  return min_filter(max_filter(image, radius), radius);
}

Image8 remove_specks(const Image8& image, int radius) {
  return max_filter(min_filter(image, radius), radius);
}

Image8 complement(const Image8& mask) {
  Image8 result = mask;
  for (uint8_t& value : result.pixels) value = 1 - value;
  return result;
}

Image8 thin(const Image8& mask) {
  assert(mask.channels == 1);
  std::array<std::array<bool, 256>, 2> removable = {};
  for (uint32_t bits = 0; bits < 256; ++bits)
    for (int half = 0; half < 2; ++half) removable[half][bits] = is_removable(bits, half);
  // The mask inside a frame of zeros, and the indices of its ones.
  const int stride = mask.width + 2;
  std::vector<uint8_t> framed(static_cast<size_t>(stride) * (mask.height + 2), 0);
  std::vector<int> ones;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (mask.at(x, y) != 0) {
        ones.push_back((y + 1) * stride + x + 1);
        framed[ones.back()] = 1;
      }
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::array<bool, 256>& table : removable) {
      std::vector<int> gone;
      for (const int i : ones)
        if (table[ring_around(&framed[i], stride)]) gone.push_back(i);
      for (const int i : gone) framed[i] = 0;
      std::erase_if(ones, [&](int i) { return framed[i] == 0; });
      changed = changed || !gone.empty();
    }
  }
  Image8 result(mask.width, mask.height, 1);
  for (const int i : ones) result.at(i % stride - 1, i / stride - 1) = 255;
  return result;
}

}  // namespace relievo
