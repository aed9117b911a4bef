#include <algorithm>
#include <vector>

#include "relief/drawing/line_map.h"

namespace relievo {

Image8 connected_above(const Image8& values, int low, int high) {
  const int w = values.width;
  Image8 result(w, values.height, 1);
  std::vector<int> open;
  const auto take = [&](int i) {
    result.pixels[i] = 1;
    open.push_back(i);
  };
  const auto count = static_cast<int>(values.pixels.size());
  for (int i = 0; i < count; ++i)
    if (values.pixels[i] >= high) take(i);
  while (!open.empty()) {
    const int i = open.back();
    open.pop_back();
    const int x = i % w;
    const int y = i / w;
    for (int v = std::max(0, y - 1); v <= std::min(values.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(w - 1, x + 1); ++u)
        if (result.at(u, v) == 0 && values.at(u, v) >= low) take(v * w + u);
  }
  return result;
}

}  // namespace relievo
