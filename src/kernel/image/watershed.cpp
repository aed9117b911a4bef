#include "kernel/image/watershed.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace relievo {
namespace {

/// Calls visit(index) for the up to four pixels that share a side with pixel i.
template <class Visit>
void for_sides(int32_t i, int width, int height, const Visit& visit) {
  const int y = static_cast<int>(static_cast<uint32_t>(i) / static_cast<uint32_t>(width));
  const int x = i - y * width;
  if (y > 0) visit(i - width);
  if (x > 0) visit(i - 1);
  if (x + 1 < width) visit(i + 1);
  if (y + 1 < height) visit(i + width);
}

/// First-in-first-out queues of pixels, one a height; the lowest is served first. A pixel that
/// comes in below the level being served joins that level.
class HeightQueues {
 public:
  void push(uint8_t height, int32_t pixel) {
    queues_[std::max<size_t>(height, level_)].push_back(pixel);
  }

  /// The next pixel, or -1 when there is none.
  int32_t pop() {
    while (next_ == queues_[level_].size()) {
      queues_[level_] = {};
      next_ = 0;
      if (++level_ == queues_.size()) return -1;
    }
    return queues_[level_][next_++];
  }

 private:
  std::array<std::vector<int32_t>, 256> queues_;
  size_t level_ = 0;
  size_t next_ = 0;
};

/// Pixels of seeds with one beside them that can be reached.
std::vector<int32_t> seeds_beside_open(const Image<int32_t>& label) {
  const int w = label.width;
  std::vector<int32_t> rim;
  for (int y = 0; y < label.height; ++y) {
    const int32_t* row = &label.at(0, y);
    const int32_t* above = y > 0 ? row - w : nullptr;
    const int32_t* below = y + 1 < label.height ? row + w : nullptr;
    for (int x = 0; x < w; ++x) {
      if (row[x] <= 0) continue;
      if ((above && above[x] == 0) || (x > 0 && row[x - 1] == 0) ||
          (x + 1 < w && row[x + 1] == 0) || (below && below[x] == 0))
        rim.push_back(y * w + x);
    }
  }
  return rim;
}

}  // namespace

void flood_from_seeds(const Image8& height, Image<int32_t>& label) {
  assert(height.pixels.size() == label.pixels.size() && label.channels == 1);
  HeightQueues queues;
  const auto claim_around = [&](int32_t i) {
    for_sides(i, label.width, label.height, [&](int32_t j) {
      if (label.pixels[j] != 0) return;
      label.pixels[j] = label.pixels[i];
      queues.push(height.pixels[j], j);
    });
  };
  const std::vector<int32_t> rim = seeds_beside_open(label);
  for (const int32_t i : rim) claim_around(i);
  for (int32_t i = queues.pop(); i >= 0; i = queues.pop()) claim_around(i);
}

}  // namespace relievo
