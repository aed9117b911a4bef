#include "kernel/image/pull_push.h"

#include <algorithm>
#include <vector>

namespace relievo {
namespace {

/// Halves the size: weighted means of squares of four pixels, with the sum of their weights up
/// to 1.
ImageF pulled(const ImageF& fine) {
  const int last = fine.channels - 1;
  ImageF coarse((fine.width + 1) / 2, (fine.height + 1) / 2, fine.channels);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x) {
      const float weight = fine.at(x, y, last);
      for (int c = 0; c < last; ++c) coarse.at(x / 2, y / 2, c) += weight * fine.at(x, y, c);
      coarse.at(x / 2, y / 2, last) += weight;
    }
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      float& weight = coarse.at(x, y, last);
      for (int c = 0; c < last && weight > 0; ++c) coarse.at(x, y, c) /= weight;
      weight = std::min(1.0F, weight);
    }
  return coarse;
}

/// Interpolates a coarser level bilinearly at a fine pixel.
float between(const ImageF& coarse, int x, int y, int c) {
  const int x0 = x / 2;
  const int y0 = y / 2;
  const int x1 = std::clamp(x0 + (x % 2 == 0 ? -1 : 1), 0, coarse.width - 1);
  const int y1 = std::clamp(y0 + (y % 2 == 0 ? -1 : 1), 0, coarse.height - 1);
  const float near = 0.75F * coarse.at(x0, y0, c) + 0.25F * coarse.at(x1, y0, c);
  const float far = 0.75F * coarse.at(x0, y1, c) + 0.25F * coarse.at(x1, y1, c);
  return 0.75F * near + 0.25F * far;
}

/// Fills the unknown pixels of `fine` from a coarser level that is known everywhere.
void push(const ImageF& coarse, ImageF& fine) {
  const int last = fine.channels - 1;
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x) {
      const float weight = fine.at(x, y, last);
      if (weight >= 1) continue;
      for (int c = 0; c < last; ++c)
        fine.at(x, y, c) = weight * fine.at(x, y, c) + (1 - weight) * between(coarse, x, y, c);
    }
}

}  // namespace

ImageF pull_push(const ImageF& colours) {
  std::vector<ImageF> levels = {colours};
  while (levels.back().width > 1 || levels.back().height > 1)
    levels.push_back(pulled(levels.back()));
  for (size_t k = levels.size() - 1; k > 0; --k) push(levels[k], levels[k - 1]);
  const ImageF& filled = levels.front();
  ImageF result(filled.width, filled.height, filled.channels - 1);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      for (int c = 0; c < result.channels; ++c) result.at(x, y, c) = filled.at(x, y, c);
  return result;
}

}  // namespace relievo
