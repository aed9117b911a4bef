#include "relief/drawing/hysteresis.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace relievo {

Image8 connected_above(const Image8& values, int low, int high) {
  Image8 result(values.width, values.height, 1);
  std::vector<std::pair<int, int>> open;
  const auto take = [&](int x, int y) {
    result.at(x, y) = 1;
    open.emplace_back(x, y);
  };
  for (int y = 0; y < values.height; ++y)
    for (int x = 0; x < values.width; ++x)
      if (values.at(x, y) >= high) take(x, y);
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    for (int v = std::max(0, y - 1); v <= std::min(values.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(values.width - 1, x + 1); ++u)
        if (result.at(u, v) == 0 && values.at(u, v) >= low) take(u, v);
  }
  return result;
}

}  // namespace relievo
