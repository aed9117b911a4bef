#include "relief/finish/spread_colours.h"

#include <array>
#include <cstdint>
#include <limits>

namespace relievo::relief {

void spread_colours(const Image8& known, Image8& colours) {
  constexpr uint16_t far = std::numeric_limits<uint16_t>::max();
  // With a margin of one pixel that is never near.
  Image16 distances(known.width + 2, known.height + 2, 1, far);
  const auto relax = [&](int x, int y, int step) {
    uint16_t& here = distances.at(x + 1, y + 1);
    if (known.at(x, y) != 0) here = 0;
    if (here <= 1) return;
    for (const auto& [dx, dy] :
         std::array<std::array<int, 2>, 4>{{{step, 0}, {-1, step}, {0, step}, {1, step}}}) {
      const int next = distances.at(x + 1 + dx, y + 1 + dy) + 1;
      if (next >= here) continue;
      here = static_cast<uint16_t>(next);
      for (int c = 0; c < 3; ++c) colours.at(x, y, c) = colours.at(x + dx, y + dy, c);
    }
  };
  for (int y = 0; y < known.height; ++y)
    for (int x = 0; x < known.width; ++x) relax(x, y, -1);
  for (int y = known.height - 1; y >= 0; --y)
    for (int x = known.width - 1; x >= 0; --x) relax(x, y, 1);
}

}  // namespace relievo::relief
