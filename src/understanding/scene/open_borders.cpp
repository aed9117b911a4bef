#include "understanding/scene/open_borders.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "kernel/image/compose.h"

namespace relievo::understanding {
namespace {

constexpr int across = 3;             ///< px looked at on either side of a border
constexpr double plain_share = 0.12;  ///< of its largest value, that a channel may vary there
constexpr double grain = 6;           ///< of 255, besides
constexpr int darkest_paint = 60;     ///< beside which ink would not be seen
constexpr double open_share = 0.7;    ///< of a border where it does not vary by more
constexpr int least_pairs = 8;

struct BorderCount {
  int pairs = 0;
  int open = 0;
};

class BorderCounter {
 public:
  BorderCounter(const Image8& rgba, const Image16& labels) : rgba_(rgba), labels_(labels) {}

  /// Along `count` pixels from `first`, `step` apart.
  void scan(ptrdiff_t first, ptrdiff_t step, int count) {
    for (int k = 1; k < count; ++k) {
      const ptrdiff_t i = first + k * step;
      const uint16_t a = labels_.pixels[i - step];
      const uint16_t b = labels_.pixels[i];
      if (a == b || a == 0 || b == 0) continue;
      BorderCount& border = borders_[std::minmax(a, b)];
      ++border.pairs;
      const int begin = std::max(0, k - across);
      const int end = std::min(count, k + across);
      border.open += is_plain(first + begin * step, step, end - begin) ? 1 : 0;
    }
  }

  std::vector<std::pair<uint16_t, uint16_t>> open() const {
    std::vector<std::pair<uint16_t, uint16_t>> pairs;
    for (const auto& [pair, border] : borders_)
      if (border.pairs >= least_pairs && border.open >= open_share * border.pairs)
        pairs.push_back(pair);
    return pairs;
  }

 private:
  bool is_plain(ptrdiff_t first, ptrdiff_t step, int count) const {
    int brightest = 0;
    for (int c = 0; c < 3; ++c) {
      int low = 255;
      int high = 0;
      for (int k = 0; k < count; ++k) {
        const uint8_t* rgba = &rgba_.pixels[4 * (first + k * step)];
        const int value = on_paper(rgba[c], rgba[3]);
        low = std::min(low, value);
        high = std::max(high, value);
      }
      brightest = std::max(brightest, high);
      if (high - low > grain + plain_share * high) return false;
    }
    return brightest > darkest_paint;
  }

  const Image8& rgba_;
  const Image16& labels_;
  std::map<std::pair<uint16_t, uint16_t>, BorderCount> borders_;
};

}  // namespace

std::vector<std::pair<uint16_t, uint16_t>> open_borders(const Image8& rgba, const Image16& labels) {
  assert(rgba.width == labels.width && rgba.height == labels.height);
  BorderCounter counter(rgba, labels);
  const ptrdiff_t w = labels.width;
  for (ptrdiff_t y = 0; y < labels.height; ++y) counter.scan(y * w, 1, labels.width);
  for (ptrdiff_t x = 0; x < w; ++x) counter.scan(x, w, labels.height);
  return counter.open();
}

}  // namespace relievo::understanding
