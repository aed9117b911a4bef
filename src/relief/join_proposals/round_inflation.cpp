#include "relief/join_proposals/round_inflation.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/moments.h"

namespace relievo {
namespace {

constexpr double least_feature = 0.02;

}  // namespace

double feature_inflation(double share) {
  return std::max(0.4 * (1 - 1.5 * std::sqrt(share)), least_feature);
}

double round_inflation(const Mask& mask) {
  Moments moments;
  for_each_pixel(mask, [&](int x, int y) {
    moments.add({static_cast<double>(x - mask.left), static_cast<double>(y - mask.top)});
  });
  const MainAxes axes = moments.axes();
  return axes.longer > 0 ? 2 * (1 + axes.shorter / axes.longer) : 4;
}

}  // namespace relievo
