#include "kernel/image/blur.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace relievo {
namespace {

/// Computes the rounded mean of at most 15 bytes from their sum. The error of the reciprocal is at
/// most 15 / 2^16, so that sums below 255.5 * 15 give the exact quotient.
class MeanOfFew {
 public:
  using Sum = uint16_t;
  static constexpr int most = 15;

  explicit MeanOfFew(int count)
      : half_(static_cast<Sum>(count / 2)), reciprocal_(static_cast<Sum>(65536 / count + 1)) {}
  uint8_t operator()(Sum sum) const {
    return static_cast<uint8_t>((uint32_t{static_cast<Sum>(sum + half_)} * reciprocal_) >> 16);
  }

 private:
  Sum half_;
  Sum reciprocal_;
};

/// Computes the rounded mean of at most 4001 bytes from their sum, whose product with the 24-bit
/// reciprocal of their number fits in 32 bits.
class MeanOfMany {
 public:
  using Sum = uint32_t;

  explicit MeanOfMany(int count)
      : reciprocal_(((Sum{1} << 24) + static_cast<Sum>(count) / 2) / static_cast<Sum>(count)) {}
  uint8_t operator()(Sum sum) const {
    return static_cast<uint8_t>((sum * reciprocal_ + (Sum{1} << 23)) >> 24);
  }

 private:
  Sum reciprocal_;
};

/// Computes means of 2 radius + 1 values of a row, `step` apart. Sums over 2^k values come from
/// those over 2^(k-1); the sum over the window is put together by the binary digits of its length.
template <class Mean>
class RowBlur {
 public:
  RowBlur(size_t n, size_t step, int radius)
      : n_(n),
        step_(step),
        radius_(static_cast<size_t>(radius)),
        padded_(n + 2 * radius_ * step),
        wider_(padded_.size()),
        window_(n) {}

  void run(const uint8_t* in, uint8_t* out) {
    pad(in);
    std::fill(window_.begin(), window_.end(), 0);
    const size_t window = 2 * radius_ + 1;
    size_t size = padded_.size();
    for (size_t covered = 1, at = 0; covered <= window; covered *= 2) {
      if ((window & covered) != 0) {
        add_to_window(at * step_);
        at += covered;
      }
      if (2 * covered > window) break;
      size -= covered * step_;
      widen(covered * step_, size);
    }
    const Mean mean(static_cast<int>(window));
    for (size_t i = 0; i < n_; ++i) out[i] = mean(window_[i]);
  }

 private:
  using Sum = typename Mean::Sum;

  /// Copies the row, extended beyond its ends by its first and last pixels.
  void pad(const uint8_t* in) {
    const size_t margin = radius_ * step_;
    for (size_t i = 0; i < n_; ++i) padded_[margin + i] = in[i];
    for (size_t i = 0; i < margin; ++i) {
      padded_[i] = in[i % step_];
      padded_[margin + n_ + i] = in[n_ - step_ + i % step_];
    }
  }
  void add_to_window(size_t offset) {
    for (size_t i = 0; i < n_; ++i) window_[i] = static_cast<Sum>(window_[i] + padded_[offset + i]);
  }
  void widen(size_t offset, size_t size) {
    for (size_t i = 0; i < size; ++i)
      wider_[i] = static_cast<Sum>(padded_[i] + padded_[i + offset]);
    std::swap(padded_, wider_);
  }

  size_t n_;
  size_t step_;
  size_t radius_;
  std::vector<Sum> padded_;
  std::vector<Sum> wider_;
  std::vector<Sum> window_;
};

/// Sums the rows [y0, y1).
void sum_columns(const Image8& image, int y0, int y1, std::vector<uint32_t>& sums) {
  std::fill(sums.begin(), sums.end(), 0);
  for (int y = y0; y < y1; ++y) {
    const uint8_t* row = &image.at(0, y);
    for (size_t i = 0; i < sums.size(); ++i) sums[i] += row[i];
  }
}

/// Blurs along rows, then along columns. Keeps as many blurred rows as a window and the row after
/// it need.
template <class Mean>
Image8 blur(const Image8& image, int radius) {
  using Sum = typename Mean::Sum;
  const Mean mean(2 * radius + 1);
  std::vector<Sum> sums(static_cast<size_t>(image.width) * image.channels, 0);
  RowBlur<Mean> row_blur(sums.size(), image.channels, radius);
  const int kept = std::min(image.height, 2 * radius + 2);
  Image8 blurred(image.width, kept, image.channels);
  int done = 0;
  const auto blurred_row = [&](int y) {
    y = std::clamp(y, 0, image.height - 1);
    for (; done <= y; ++done) row_blur.run(&image.at(0, done), &blurred.at(0, done % kept));
    return static_cast<const uint8_t*>(&blurred.at(0, y % kept));
  };
  for (int y = -radius; y <= radius; ++y) {
    const uint8_t* row = blurred_row(y);
    for (size_t i = 0; i < sums.size(); ++i) sums[i] = static_cast<Sum>(sums[i] + row[i]);
  }
  Image8 result(image.width, image.height, image.channels);
  for (int y = 0; y < image.height; ++y) {
    uint8_t* out = &result.at(0, y);
    const uint8_t* enters = blurred_row(y + radius + 1);
    const uint8_t* leaves = blurred_row(y - radius);
    for (size_t i = 0; i < sums.size(); ++i) {
      out[i] = mean(sums[i]);
      sums[i] = static_cast<Sum>(sums[i] + enters[i] - leaves[i]);
    }
  }
  return result;
}

}  // namespace

Image8 box_blur(const Image8& image, int radius) {
  assert(radius >= 0 && radius <= 2000);
  if (radius == 0 || image.empty()) return image;
  return 2 * radius + 1 <= MeanOfFew::most ? blur<MeanOfFew>(image, radius)
                                           : blur<MeanOfMany>(image, radius);
}

Image8 shrink(const Image8& image, int factor) {
  assert(factor >= 1);
  if (factor == 1 || image.empty()) return image;
  const int w = (image.width + factor - 1) / factor;
  const int h = (image.height + factor - 1) / factor;
  const int channels = image.channels;
  Image8 result(w, h, channels);
  std::vector<uint32_t> sums(static_cast<size_t>(image.width) * channels);
  for (int y = 0; y < h; ++y) {
    const int rows = std::min(factor, image.height - y * factor);
    sum_columns(image, y * factor, y * factor + rows, sums);
    for (int x = 0; x < w; ++x) {
      const int columns = std::min(factor, image.width - x * factor);
      const uint64_t count = static_cast<uint64_t>(rows) * columns;
      for (int c = 0; c < channels; ++c) {
        uint64_t sum = 0;
        for (int u = 0; u < columns; ++u) sum += sums[(x * factor + u) * channels + c];
        result.at(x, y, c) = static_cast<uint8_t>((sum + count / 2) / count);
      }
    }
  }
  return result;
}

}  // namespace relievo
