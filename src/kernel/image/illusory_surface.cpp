#include "kernel/image/illusory_surface.h"

#include <algorithm>

namespace relievo {
namespace {

constexpr int coarsest_side = 16;
constexpr int coarsest_sweeps = 200;
constexpr int sweeps = 16;
constexpr float relaxation = 1.6F;

/// Values of a grid and which of them are fixed.
struct Level {
  ImageF value;
  Image8 fixed;
};

Level finest(const Image<Cell>& cells) {
  Level level{ImageF(cells.width, cells.height, 1, 0.5F), Image8(cells.width, cells.height, 1)};
  for (size_t i = 0; i < cells.pixels.size(); ++i) {
    if (cells.pixels[i] == Cell::open) continue;
    level.fixed.pixels[i] = 1;
    level.value.pixels[i] = cells.pixels[i] == Cell::one ? 1.0F : 0.0F;
  }
  return level;
}

/// Half as many cells a side; one is fixed where any of the cells that it replaces is, at the
/// mean of those.
Level coarser(const Level& fine) {
  const int width = (fine.value.width + 1) / 2;
  const int height = (fine.value.height + 1) / 2;
  Level coarse{ImageF(width, height, 1, 0.5F), Image8(width, height, 1)};
  ImageF sum(width, height, 1);
  ImageF count(width, height, 1);
  for (int y = 0; y < fine.value.height; ++y)
    for (int x = 0; x < fine.value.width; ++x) {
      if (fine.fixed.at(x, y) == 0) continue;
      sum.at(x / 2, y / 2) += fine.value.at(x, y);
      count.at(x / 2, y / 2) += 1;
    }
  for (size_t i = 0; i < sum.pixels.size(); ++i) {
    if (count.pixels[i] == 0) continue;
    coarse.fixed.pixels[i] = 1;
    coarse.value.pixels[i] = sum.pixels[i] / count.pixels[i];
  }
  return coarse;
}

/// The open cells of `fine` begin with the values of the coarser grid.
void refine(const Level& coarse, Level& fine) {
  for (int y = 0; y < fine.value.height; ++y)
    for (int x = 0; x < fine.value.width; ++x)
      if (fine.fixed.at(x, y) == 0) fine.value.at(x, y) = coarse.value.at(x / 2, y / 2);
}

/// The mean of the cells beside one that may lie at the rim of the grid.
float mean_at_rim(const ImageF& value, int x, int y) {
  float sum = 0;
  int count = 0;
  const auto add = [&](int nx, int ny) {
    if (nx < 0 || ny < 0 || nx >= value.width || ny >= value.height) return;
    sum += value.at(nx, ny);
    ++count;
  };
  add(x - 1, y);
  add(x + 1, y);
  add(x, y - 1);
  add(x, y + 1);
  return count > 0 ? sum / static_cast<float>(count) : value.at(x, y);
}

/// Every second open cell of a row from x = first on.
void relax_row(Level& level, int y, int first) {
  const int w = level.value.width;
  const bool inside = y > 0 && y + 1 < level.value.height;
  float* row = &level.value.at(0, y);
  const uint8_t* fixed = &level.fixed.at(0, y);
  for (int x = first; x < w; x += 2) {
    if (fixed[x] != 0) continue;
    const float mean = inside && x > 0 && x + 1 < w
                           ? (row[x - 1] + row[x + 1] + row[x - w] + row[x + w]) / 4
                           : mean_at_rim(level.value, x, y);
    row[x] += relaxation * (mean - row[x]);
  }
}

/// Successive over-relaxation, red cells before black ones.
void relax(Level& level, int count) {
  for (int sweep = 0; sweep < 2 * count; ++sweep)
    for (int y = 0; y < level.value.height; ++y) relax_row(level, y, (y + sweep) % 2);
}

}  // namespace

ImageF diffuse_contour(const Image<Cell>& cells) {
  std::vector<Level> levels = {finest(cells)};
  while (std::max(levels.back().value.width, levels.back().value.height) > coarsest_side)
    levels.push_back(coarser(levels.back()));
  relax(levels.back(), coarsest_sweeps);
  for (size_t k = levels.size() - 1; k-- > 0;) {
    refine(levels[k + 1], levels[k]);
    relax(levels[k], sweeps);
  }
  return std::move(levels.front().value);
}

}  // namespace relievo
