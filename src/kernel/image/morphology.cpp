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

using Ring8 = std::array<uint8_t, 8>;  ///< neighbours clockwise from the one above, 0 or 1

Ring8 neighbours(const Image8& mask, int x, int y) {
  static constexpr int dx[] = {0, 1, 1, 1, 0, -1, -1, -1};
  static constexpr int dy[] = {-1, -1, 0, 1, 1, 1, 0, -1};
  Ring8 ring = {};
  for (int k = 0; k < 8; ++k) {
    const int nx = x + dx[k];
    const int ny = y + dy[k];
    const bool inside = nx >= 0 && ny >= 0 && nx < mask.width && ny < mask.height;
    ring[k] = inside && mask.at(nx, ny) != 0 ? 1 : 0;
  }
  return ring;
}

/// Whether a pixel with these neighbours can go in the given half of a round.
bool is_removable(const Ring8& p, int half) {
  int count = 0;
  int entries = 0;
  for (int k = 0; k < 8; ++k) {
    count += p[k];
    entries += p[k] == 0 && p[(k + 1) % 8] == 1 ? 1 : 0;
  }
  if (count < 2 || count > 6 || entries != 1) return false;
  const uint8_t up = p[0];
  const uint8_t right = p[2];
  const uint8_t down = p[4];
  const uint8_t left = p[6];
  return half == 0 ? (up & right & down) == 0 && (right & down & left) == 0
                   : (up & right & left) == 0 && (up & down & left) == 0;
}

}  // namespace

Image8 max_filter(const Image8& image, int radius) { return filter_squares<Larger>(image, radius); }

Image8 min_filter(const Image8& image, int radius) {
  return filter_squares<Smaller>(image, radius);
}

Image8 close_gaps(const Image8& image, int radius) {
  return min_filter(max_filter(image, radius), radius);
}

Image8 thin(const Image8& mask) {
  assert(mask.channels == 1);
  Image8 result = mask;
  std::vector<std::pair<int, int>> left;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) == 0) continue;
      result.at(x, y) = 255;
      left.emplace_back(x, y);
    }
  std::vector<std::pair<int, int>> gone;
  for (bool changed = true; changed;) {
    changed = false;
    for (int half = 0; half < 2; ++half) {
      gone.clear();
      for (const auto& [x, y] : left)
        if (is_removable(neighbours(result, x, y), half)) gone.emplace_back(x, y);
      for (const auto& [x, y] : gone) result.at(x, y) = 0;
      changed = changed || !gone.empty();
      left.erase(std::remove_if(left.begin(), left.end(),
                                [&](const auto& p) { return result.at(p.first, p.second) == 0; }),
                 left.end());
    }
  }
  return result;
}

}  // namespace relievo
