#include "kernel/image/morphology.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>
#include <vector>

namespace relievo {
namespace {

struct Larger {
  static constexpr uint8_t identity = 0;
  uint8_t operator()(uint8_t a, uint8_t b) const { return a > b ? a : b; }
};
struct Smaller {
  static constexpr uint8_t identity = 255;
  uint8_t operator()(uint8_t a, uint8_t b) const { return a < b ? a : b; }
};

template <class Pick>
void pick_rows(const uint8_t* a, const uint8_t* b, uint8_t* out, size_t n) {
  for (size_t i = 0; i < n; ++i) out[i] = Pick()(a[i], b[i]);
}

template <class Pick>
void pick_into(uint8_t* row, const uint8_t* other, size_t n) {
  for (size_t i = 0; i < n; ++i) row[i] = Pick()(row[i], other[i]);
}

/// Extremes of `window` values of a row, `step` apart; the window is doubled while it fits.
template <class Pick>
class RowFilter {
 public:
  RowFilter(size_t n, size_t step, size_t window)
      : n_(n),
        step_(step),
        window_(window),
        padded_(n + (window - 1) * step, Pick::identity),
        wide_(padded_.size()),
        wider_(padded_.size()) {}

  /// Where the n values of the row are put; beside them are identities.
  uint8_t* row() { return padded_.data() + window_ / 2 * step_; }

  void run(uint8_t* out) {
    const uint8_t* in = padded_.data();
    size_t size = padded_.size();
    size_t covered = 1;
    for (; 2 * covered <= window_; covered *= 2) {
      size -= covered * step_;
      pick_rows<Pick>(in, in + covered * step_, wider_.data(), size);
      std::swap(wide_, wider_);
      in = wide_.data();
    }
    pick_rows<Pick>(in, in + (window_ - covered) * step_, out, n_);
  }

 private:
  size_t n_;
  size_t step_;
  size_t window_;
  std::vector<uint8_t> padded_;
  std::vector<uint8_t> wide_;
  std::vector<uint8_t> wider_;
};

/// One pass over an image: the extremes of columns from those of blocks of `window` rows, of the
/// block's rows from each one to its end and of the next block's from its begin to each one; then
/// those of rows.
template <class Pick>
class SquareFilter {
 public:
  SquareFilter(const Image8& image, int radius)
      : image_(image),
        radius_(std::min(radius, std::max(image.width, image.height))),
        window_(2 * radius_ + 1),
        n_(static_cast<size_t>(image.width) * image.channels),
        to_end_(n_ * window_),
        outside_(n_, Pick::identity),
        rows_(n_, image.channels, window_) {}

  Image8 run() {
    Image8 result(image_.width, image_.height, image_.channels);
    for (int block = -radius_; block < image_.height - radius_; block += window_) {
      fill_to_end(block);
      std::vector<uint8_t> from_begin = outside_;
      for (int y = block + radius_; y < std::min(image_.height, block + radius_ + window_); ++y) {
        pick_rows<Pick>(&to_end_[n_ * (y - radius_ - block)], from_begin.data(), rows_.row(), n_);
        rows_.run(&result.at(0, y));
        pick_into<Pick>(from_begin.data(), row(y + radius_ + 1), n_);
      }
    }
    return result;
  }

 private:
  const uint8_t* row(int y) const {
    return y < 0 || y >= image_.height ? outside_.data() : &image_.at(0, y);
  }

  void fill_to_end(int block) {
    const uint8_t* after = outside_.data();
    for (int k = window_ - 1; k >= 0; --k) {
      pick_rows<Pick>(row(block + k), after, &to_end_[n_ * k], n_);
      after = &to_end_[n_ * k];
    }
  }

  const Image8& image_;
  int radius_;
  int window_;
  size_t n_;
  std::vector<uint8_t> to_end_;
  std::vector<uint8_t> outside_;  ///< a row beyond the image
  RowFilter<Pick> rows_;
};

template <class Pick>
Image8 filter_squares(const Image8& image, int radius) {
  assert(radius >= 0);
  if (radius == 0 || image.empty()) return image;
  return SquareFilter<Pick>(image, radius).run();
}

/// Whether a pixel with this ring of neighbours can go in the given half of a round.
bool is_removable(uint32_t ring, int half) {
  const RingCount count = count_ring(ring);
  if (count.pixels < 2 || count.pixels > 6 || count.runs != 1) return false;
  const bool up = has_pixel(ring, 0);
  const bool right = has_pixel(ring, 2);
  const bool down = has_pixel(ring, 4);
  const bool left = has_pixel(ring, 6);
  return half == 0 ? !(up && right && down) && !(right && down && left)
                   : !(up && right && left) && !(up && down && left);
}

/// A mask in a frame of pixels that are not in it.
class FramedMask {
 public:
  explicit FramedMask(const Image8& mask)
      : width_(mask.width),
        stride_(mask.width + 2),
        pixels_(static_cast<size_t>(stride_) * (mask.height + 2), 0) {
    for (int y = 0; y < mask.height; ++y)
      for (int x = 0; x < mask.width; ++x)
        if (mask.at(x, y) != 0) {
          members_.push_back((y + 1) * stride_ + x + 1);
          pixels_[members_.back()] = 1;
        }
  }

  /// Removes the members whose neighbours are in the table, all at once. Whether there were any.
  bool remove(const std::array<bool, 256>& table) {
    std::vector<int> gone;
    for (const int i : members_)
      if (table[ring_around(&pixels_[i], stride_)]) gone.push_back(i);
    for (const int i : gone) pixels_[i] = 0;
    members_.erase(
        std::remove_if(members_.begin(), members_.end(), [&](int i) { return pixels_[i] == 0; }),
        members_.end());
    return !gone.empty();
  }

  /// 255 on the members.
  Image8 image(int height) const {
    Image8 result(width_, height, 1);
    for (const int i : members_) result.at(i % stride_ - 1, i / stride_ - 1) = 255;
    return result;
  }

 private:
  int width_;
  int stride_;
  std::vector<uint8_t> pixels_;
  std::vector<int> members_;
};

}  // namespace

Image8 max_filter(const Image8& image, int radius) { return filter_squares<Larger>(image, radius); }

Image8 min_filter(const Image8& image, int radius) {
  return filter_squares<Smaller>(image, radius);
}

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
  FramedMask framed(mask);
  for (bool changed = true; changed;) {
    changed = framed.remove(removable[0]);
    changed = framed.remove(removable[1]) || changed;
  }
  return framed.image(mask.height);
}

}  // namespace relievo
