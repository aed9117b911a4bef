#include "io/svg/coverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {
namespace {

/// Crossings of every row's centre line with an outline: x in pixels and the winding step.
using Crossings = std::vector<std::vector<std::pair<double, int>>>;

void add_edge(Crossings& rows, Point2 a, Point2 b) {
  const int step = a.y < b.y ? 1 : -1;
  if (a.y > b.y) std::swap(a, b);
  const double last = static_cast<double>(rows.size()) - 1;
  const int from = static_cast<int>(std::clamp(std::ceil(a.y - 0.5), 0.0, last + 1));
  const int to = static_cast<int>(std::clamp(std::ceil(b.y - 0.5), 0.0, last + 1));
  for (int y = from; y < to; ++y) {
    const double t = (y + 0.5 - a.y) / (b.y - a.y);
    rows[y].emplace_back(a.x + t * (b.x - a.x), step);
  }
}

void fill_row(std::vector<std::pair<double, int>>& crossings, Image8& mask, int y) {
  std::sort(crossings.begin(), crossings.end());
  int winding = 0;
  for (size_t i = 0; i + 1 < crossings.size(); ++i) {
    winding += crossings[i].second;
    if (winding == 0) continue;
    const double width = mask.width;
    const int from = static_cast<int>(std::clamp(std::ceil(crossings[i].first - 0.5), 0.0, width));
    const int to =
        static_cast<int>(std::clamp(std::ceil(crossings[i + 1].first - 0.5), 0.0, width));
    for (int x = from; x < to; ++x) mask.at(x, y) = 255;
  }
}

}  // namespace

Image8 silhouette_mask(const Scene& scene, int width, int height) {
  Image8 mask(width, height, 1);
  const double sx = width / scene.width;
  const double sy = height / scene.height;
  for (const Part& part : scene.parts) {
    Crossings rows(height);
    for (const Ring& ring : part.outline) {
      for (size_t i = 0; i < ring.size(); ++i) {
        const Point2 a = ring[i];
        const Point2 b = ring[(i + 1) % ring.size()];
        add_edge(rows, {sx * a.x, sy * a.y}, {sx * b.x, sy * b.y});
      }
    }
    for (int y = 0; y < height; ++y) fill_row(rows[y], mask, y);
  }
  return mask;
}

double silhouette_agreement(const Scene& scene, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  const Image8 mask = silhouette_mask(scene, rgba.width, rgba.height);
  int64_t both = 0;
  int64_t either = 0;
  for (int y = 0; y < rgba.height; ++y) {
    for (int x = 0; x < rgba.width; ++x) {
      const bool drawn = rgba.at(x, y, 3) >= 128;
      const bool covered = mask.at(x, y) != 0;
      both += drawn && covered ? 1 : 0;
      either += drawn || covered ? 1 : 0;
    }
  }
  return either == 0 ? 1 : static_cast<double>(both) / static_cast<double>(either);
}

}  // namespace relievo
