#include "kernel/image/diffusion.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace relievo {
namespace {

constexpr int coarsest_side = 16;
constexpr int coarsest_sweeps = 200;
constexpr int sweeps = 16;
constexpr float relaxation = 1.6F;

/// A grid of the hierarchy.
struct Level {
  ImageF known;  ///< v and w
  ImageF value;  ///< u
};

/// Halves the size: weighted means of squares of four pixels, with the sum of their weights, which
/// are the last channel, up to `most`.
ImageF halved(const ImageF& fine, float most) {
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
      weight = std::min(most, weight);
    }
  return coarse;
}

/// Returns the first channels of an image.
ImageF first_channels(const ImageF& image, int channels) {
  ImageF result(image.width, image.height, channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(&image.at(x, y), channels, &result.at(x, y));
  return result;
}

/// Initialises the finer grid: fixed values as they are, all others from the coarser grid.
void refine(const ImageF& coarse, Level& fine) {
  for (int y = 0; y < fine.value.height; ++y)
    for (int x = 0; x < fine.value.width; ++x)
      fine.value.at(x, y) =
          fine.known.at(x, y, 1) >= fixed_weight ? fine.known.at(x, y) : coarse.at(x / 2, y / 2);
}

/// Returns the sum of the values of the cells beside one, and their number.
std::pair<float, float> beside(const ImageF& value, int x, int y) {
  float sum = 0;
  float count = 0;
  const auto add = [&](int nx, int ny) {
    if (nx < 0 || ny < 0 || nx >= value.width || ny >= value.height) return;
    sum += value.at(nx, ny);
    ++count;
  };
  add(x - 1, y);
  add(x + 1, y);
  add(x, y - 1);
  add(x, y + 1);
  return {sum, count};
}

/// Relaxes every second cell of a row from x = first on.
void relax_row(Level& level, int y, int first) {
  const int w = level.value.width;
  const bool inside = y > 0 && y + 1 < level.value.height;
  float* row = &level.value.at(0, y);
  for (int x = first; x < w; x += 2) {
    const float* known = &level.known.at(x, y);
    const float weight = known[1];
    if (weight >= fixed_weight) continue;
    const auto [sum, count] =
        inside && x > 0 && x + 1 < w
            ? std::pair(row[x - 1] + row[x + 1] + row[x - w] + row[x + w], 4.0F)
            : beside(level.value, x, y);
    if (weight + count > 0)
      row[x] += relaxation * ((weight * known[0] + sum) / (weight + count) - row[x]);
  }
}

/// Performs `count` sweeps of successive over-relaxation, red cells before black ones.
void relax(Level& level, int count) {
  for (int sweep = 0; sweep < 2 * count; ++sweep)
    for (int y = 0; y < level.value.height; ++y) relax_row(level, y, (y + sweep) % 2);
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

ImageF diffuse(const ImageF& known) {
  std::vector<Level> levels = {{known, first_channels(known, 1)}};
  while (std::max(levels.back().value.width, levels.back().value.height) > coarsest_side) {
    ImageF coarse = halved(levels.back().known, fixed_weight);
    ImageF value = first_channels(coarse, 1);
    levels.push_back({std::move(coarse), std::move(value)});
  }
  relax(levels.back(), coarsest_sweeps);
  for (size_t k = levels.size() - 1; k-- > 0;) {
    refine(levels[k + 1].value, levels[k]);
    relax(levels[k], sweeps);
  }
  return std::move(levels.front().value);
}

ImageF pull_push(const ImageF& colours) {
  std::vector<ImageF> levels = {colours};
  while (levels.back().width > 1 || levels.back().height > 1)
    levels.push_back(halved(levels.back(), 1));
  for (size_t k = levels.size() - 1; k > 0; --k) push(levels[k], levels[k - 1]);
  return first_channels(levels.front(), colours.channels - 1);
}

}  // namespace relievo
