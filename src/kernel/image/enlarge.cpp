#include "kernel/image/enlarge.h"

#include <cstring>
#include <numeric>

namespace relievo {

bool is_same_colour(const uint8_t* a, const uint8_t* b) {
  return (a[3] == 0 && b[3] == 0) || std::memcmp(a, b, 4) == 0;
}

int square_side(const Image8& rgba) {
  int side = std::gcd(rgba.width, rgba.height);
  for (int y = 0; y < rgba.height && side > 1; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const uint8_t* here = &rgba.at(x, y);
      if (x > 0 && !is_same_colour(here, &rgba.at(x - 1, y))) side = std::gcd(side, x);
      if (y > 0 && !is_same_colour(here, &rgba.at(x, y - 1))) side = std::gcd(side, y);
    }
  return side;
}

}  // namespace relievo
