#include "understanding/areas/divide_at_cut.h"

#include <vector>

namespace relievo::understanding {
namespace {

bool is_opaque(const Image8& rgba, size_t i) { return rgba.pixels[4 * i + 3] >= 128; }

/// Returns by basin whether most of its pixels are opaque.
std::vector<bool> opaque_basins(const Image8& rgba, int count, const Image<int32_t>& basin) {
  std::vector<int64_t> excess(count, 0);
  for (size_t i = 0; i < basin.pixels.size(); ++i)
    excess[basin.pixels[i]] += is_opaque(rgba, i) ? 1 : -1;
  std::vector<bool> opaque(count);
  for (int b = 0; b < count; ++b) opaque[b] = excess[b] > 0;
  return opaque;
}

}  // namespace

bool is_cut_out(const Image8& rgba, const Image8& figure) {
  int64_t opaque = 0;
  int64_t in_figure = 0;
  int64_t both = 0;
  for (size_t i = 0; i < figure.pixels.size(); ++i) {
    in_figure += figure.pixels[i];
    if (!is_opaque(rgba, i)) continue;
    opaque += 255;
    both += figure.pixels[i];
  }
  const bool has_transparency = opaque < 255 * static_cast<int64_t>(figure.pixels.size());
  return has_transparency && 2 * both > in_figure && 2 * both > opaque;
}

void divide_at_cut(const Image8& rgba, int count, Image<int32_t>& basin) {
  const std::vector<bool> opaque = opaque_basins(rgba, count, basin);
  const auto w = static_cast<size_t>(basin.width);
  std::vector<bool> is_placed(basin.pixels.size());
  std::vector<size_t> queue;
  for (size_t i = 0; i < basin.pixels.size(); ++i) {
    is_placed[i] = opaque[basin.pixels[i]] == is_opaque(rgba, i);
    if (is_placed[i]) queue.push_back(i);
  }
  const auto reach = [&](size_t from, size_t to) {
    if (is_placed[to] || is_opaque(rgba, to) != is_opaque(rgba, from)) return;
    is_placed[to] = true;
    basin.pixels[to] = basin.pixels[from];
    queue.push_back(to);
  };
  for (size_t next = 0; next < queue.size(); ++next) {
    const size_t i = queue[next];
    if (i % w > 0) reach(i, i - 1);
    if (i % w + 1 < w) reach(i, i + 1);
    if (i >= w) reach(i, i - w);
    if (i + w < basin.pixels.size()) reach(i, i + w);
  }
}

}  // namespace relievo::understanding
