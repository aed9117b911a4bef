#include "kernel/image/components.h"

#include <gtest/gtest.h>

#include <deque>

#include "support/random_image.h"

namespace relievo {
namespace {

/// Labels by one search after the other, in the order of first pixels.
Image<int32_t> searched(const Image8& mask, bool corners) {
  Image<int32_t> label(mask.width, mask.height, 1);
  int32_t count = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) == 0 || label.at(x, y) != 0) continue;
      std::deque<std::pair<int, int>> open = {{x, y}};
      label.at(x, y) = ++count;
      while (!open.empty()) {
        const auto [u, v] = open.front();
        open.pop_front();
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            if (!corners && dx != 0 && dy != 0) continue;
            const int a = u + dx;
            const int b = v + dy;
            if (a < 0 || b < 0 || a >= mask.width || b >= mask.height) continue;
            if (mask.at(a, b) == 0 || label.at(a, b) != 0) continue;
            label.at(a, b) = count;
            open.emplace_back(a, b);
          }
      }
    }
  return label;
}

TEST(Components, EqualThoseOfASearch) {
  for (uint32_t seed = 0; seed < 40; ++seed) {
    const Image8 mask = random_image(37, 29, 0.3 + 0.01 * seed, seed);
    for (const bool corners : {false, true}) {
      const Components found =
          connected_components(mask, corners ? Connectivity::corners : Connectivity::sides);
      EXPECT_EQ(found.label.pixels, searched(mask, corners).pixels) << seed;
      std::vector<int64_t> areas(found.areas.size(), 0);
      for (const int32_t label : found.label.pixels) ++areas[label];
      EXPECT_EQ(areas, found.areas);
    }
  }
}

}  // namespace
}  // namespace relievo
