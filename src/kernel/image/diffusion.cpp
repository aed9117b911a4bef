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
  ImageF wanted;  ///< v
  ImageF weight;  ///< w
  ImageF value;   ///< u
};

Level finest(const ImageF& known) {
  const auto [w, h] = std::pair(known.width, known.height);
  Level level{ImageF(w, h, 1), ImageF(w, h, 1), ImageF(w, h, 1)};
  for (size_t i = 0; i < level.wanted.pixels.size(); ++i) {
    level.wanted.pixels[i] = known.pixels[2 * i];
    level.weight.pixels[i] = known.pixels[2 * i + 1];
  }
  return level;
}

/// Makes a grid of half as many cells a side. In two dimensions the term of the pairs is the same
/// on every grid, so weights add up.
Level coarser(const Level& fine) {
  const int width = (fine.wanted.width + 1) / 2;
  const int height = (fine.wanted.height + 1) / 2;
  Level coarse{ImageF(width, height, 1), ImageF(width, height, 1), ImageF(width, height, 1)};
  for (int y = 0; y < fine.wanted.height; ++y)
    for (int x = 0; x < fine.wanted.width; ++x) {
      const float weight = fine.weight.at(x, y);
      coarse.wanted.at(x / 2, y / 2) += weight * fine.wanted.at(x, y);
      coarse.weight.at(x / 2, y / 2) += weight;
    }
  for (size_t i = 0; i < coarse.wanted.pixels.size(); ++i) {
    if (coarse.weight.pixels[i] > 0) coarse.wanted.pixels[i] /= coarse.weight.pixels[i];
    coarse.weight.pixels[i] = std::min(coarse.weight.pixels[i], fixed_weight);
  }
  return coarse;
}

/// Initialises the finer grid: fixed values as they are, all others from the coarser grid.
void refine(const ImageF& coarse, Level& fine) {
  for (int y = 0; y < fine.value.height; ++y)
    for (int x = 0; x < fine.value.width; ++x)
      fine.value.at(x, y) =
          fine.weight.at(x, y) >= fixed_weight ? fine.wanted.at(x, y) : coarse.at(x / 2, y / 2);
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
  const float* weight = &level.weight.at(0, y);
  const float* wanted = &level.wanted.at(0, y);
  for (int x = first; x < w; x += 2) {
    if (weight[x] >= fixed_weight) continue;
    const auto [sum, count] =
        inside && x > 0 && x + 1 < w
            ? std::pair(row[x - 1] + row[x + 1] + row[x - w] + row[x + w], 4.0F)
            : beside(level.value, x, y);
    if (weight[x] + count > 0)
      row[x] += relaxation * ((weight[x] * wanted[x] + sum) / (weight[x] + count) - row[x]);
  }
}

/// Performs `count` sweeps of successive over-relaxation, red cells before black ones.
void relax(Level& level, int count) {
  for (int sweep = 0; sweep < 2 * count; ++sweep)
    for (int y = 0; y < level.value.height; ++y) relax_row(level, y, (y + sweep) % 2);
}

}  // namespace

ImageF diffuse(const ImageF& known) {
  std::vector<Level> levels = {finest(known)};
  while (std::max(levels.back().value.width, levels.back().value.height) > coarsest_side)
    levels.push_back(coarser(levels.back()));
  levels.back().value = levels.back().wanted;
  relax(levels.back(), coarsest_sweeps);
  for (size_t k = levels.size() - 1; k-- > 0;) {
    refine(levels[k + 1].value, levels[k]);
    relax(levels[k], sweeps);
  }
  return std::move(levels.front().value);
}

}  // namespace relievo
