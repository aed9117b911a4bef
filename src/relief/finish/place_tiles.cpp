#include "relief/finish/place_tiles.h"

#include <algorithm>
#include <numeric>

namespace relievo::relief {

std::vector<std::array<int, 2>> place_tiles(const std::vector<ImageSize>& tiles, int width,
                                            int& height) {
  constexpr int gap = 8;  // px
  std::vector<int> order(tiles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&tiles](int a, int b) { return tiles[a].height > tiles[b].height; });
  std::vector<std::array<int, 2>> places(tiles.size());
  int x = width;
  int top = height;
  for (const int k : order) {
    if (x + tiles[k].width > width) {
      x = 0;
      top = height + gap;
      height = top + tiles[k].height;
    }
    places[k] = {x, top};
    x += tiles[k].width + gap;
  }
  return places;
}

}  // namespace relievo::relief
