#include "relief/join_proposals/round_inflation.h"

#include <algorithm>
#include <cmath>

namespace relievo {

double round_inflation(const Mask& mask) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for_each_pixel(mask, [&](int px, int py) {
    const double u = px - mask.left;
    const double v = py - mask.top;
    n += 1;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
    yy += v * v;
  });
  if (n == 0) return 4;
  const double a = xx / n - x / n * (x / n);
  const double b = xy / n - x / n * (y / n);
  const double c = yy / n - y / n * (y / n);
  const double root = std::sqrt((a - c) * (a - c) / 4 + b * b);
  const double longer = (a + c) / 2 + root;
  const double shorter = std::max((a + c) / 2 - root, 0.0);
  return longer > 0 ? 2 * (1 + shorter / longer) : 4;
}

}  // namespace relievo
