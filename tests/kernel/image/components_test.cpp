#include "kernel/image/components.h"

#include <gtest/gtest.h>

#include <deque>

#include "support/random_image.h"

namespace relievo {
namespace {

/// Labels components by one search after the other, in the order of first pixels.
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

TEST(Components, ConnectedToASeedAreThePiecesThatItTouches) {
  Mask mask{-3, 4, Image8(60, 20, 1)};
  for (int x = 2; x < 20; ++x)
    for (int y = 2; y < 18; ++y) mask.inside.at(x, y) = 1;
  const int64_t piece = pixel_count(mask);
  for (int x = 20; x < 50; ++x) mask.inside.at(x, 18) = 1;  // meets the piece at a corner only
  const Mask connected = connected_to(mask, {5, 9, Image8(1, 1, 1, 1)});
  EXPECT_EQ(pixel_count(connected), piece);
  EXPECT_TRUE(connected.has(-1, 6));
  EXPECT_FALSE(connected.has(30, 22));
  EXPECT_EQ(pixel_count(connected_to(mask, {-40, 9, Image8(9, 9, 1, 1)})), 0);
}

}  // namespace
}  // namespace relievo
