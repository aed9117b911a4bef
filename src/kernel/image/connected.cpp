#include "kernel/image/connected.h"

#include <utility>
#include <vector>

namespace relievo {

Mask connected_to(const Mask& mask, const Mask& seed) {
  Mask result{mask.left, mask.top, Image8(mask.inside.width, mask.inside.height, 1)};
  std::vector<std::pair<int, int>> front;
  const auto reach = [&](int x, int y) {
    if (!mask.has(x, y)) return;
    uint8_t& reached = result.inside.at(x - mask.left, y - mask.top);
    if (reached != 0) return;
    reached = 1;
    front.emplace_back(x, y);
  };
  for_each_pixel(seed, reach);
  while (!front.empty()) {
    const auto [x, y] = front.back();
    front.pop_back();
    reach(x - 1, y);
    reach(x + 1, y);
    reach(x, y - 1);
    reach(x, y + 1);
  }
  return result;
}

}  // namespace relievo
