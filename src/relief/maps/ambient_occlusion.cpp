#include "relief/maps/ambient_occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "kernel/base/workers.h"
#include "relievo/point.h"

namespace relievo::relief {
namespace {

constexpr int band_rows = 16;          ///< rows that a thread takes at once
constexpr double horizon_reach = 0.2;  ///< of the view's longer side
constexpr double step_growth = 1.35;   ///< ratio of successive steps along a line

/// A direction on the pixel grid, and the share of all directions that it stands for.
struct Line {
  int x;
  int y;
  double share;
};

/// Returns lines through pixel centres, so that a slope has no steps. Each of the lines 1:0, 2:1,
/// 1:1, ... stands for the directions up to halfway to its neighbours.
std::array<Line, 8> lines_of() {
  const double knight = std::atan2(1, 2) / std::numbers::pi;
  const double diagonal = 0.25 - knight;
  return {{{1, 0, knight},
           {2, 1, 0.125},
           {1, 1, diagonal},
           {1, 2, 0.125},
           {0, 1, knight},
           {-1, 2, 0.125},
           {-1, 1, diagonal},
           {-2, 1, 0.125}}};
}

/// Returns the multiples of a line's step at which heights are sampled: the first few, then
/// sparser.
std::vector<int> steps_of(int longest) {
  std::vector<int> steps;
  for (int at = 1; at <= std::max(1.0, horizon_reach * longest);
       at = std::max(at + 1, static_cast<int>(step_growth * at)))
    steps.push_back(at);
  return steps;
}

/// The occlusion of pixels by the heights around them [Jimenez et al. 2016, eq. 7].
struct Sky {
  const ReliefMaps& maps;
  double pixel;
  std::vector<int> steps;
  std::array<Line, 8> lines = lines_of();

  /// Returns the cosine of the angle between the viewer's direction and the horizon along (dx, dy).
  double horizon(int x, int y, int dx, int dy) const {
    const ImageF& height = maps.height;
    const auto here = static_cast<double>(height.at(x, y));
    const double stride = pixel * std::hypot(dx, dy);
    double highest = -1;
    for (const int step : steps) {
      const int u = x + step * dx;
      const int v = y + step * dy;
      if (u < 0 || v < 0 || u >= height.width || v >= height.height) break;
      const double rise = static_cast<double>(height.at(u, v)) - here;
      if (!std::isfinite(rise)) continue;
      // Far heights fade, so that no edge shows at the end of the reach.
      const double weight = std::min(1.0, 2 - 2.0 * step / (steps.back() + 1));
      highest = std::max(
          highest,
          weight * (1 + rise / std::sqrt(step * stride * step * stride + rise * rise)) - 1);
    }
    return highest;
  }

  /// Returns the open share of the sky in the plane of the viewer and a line, times the length l of
  /// the normal's projection to that plane. With t the angle of the projection and h the horizons
  /// h1 < t < h2, it is l (a(h2) + a(h1)), a(h) = (cos t - cos(2 h - t) + 2 h sin t) / 4.
  double slice(int x, int y, const Line& line) const {
    const Point3 n = {maps.normal.at(x, y, 0), maps.normal.at(x, y, 1), maps.normal.at(x, y, 2)};
    // Rows run downwards, the normal's Y upwards.
    const double across = (n.x * line.x - n.y * line.y) / std::hypot(line.x, line.y);
    const double tilt = std::atan2(across, n.z);
    const auto arc = [&](double angle) {
      return 0.25 * (-std::cos(2 * angle - tilt) + std::cos(tilt) + 2 * angle * std::sin(tilt));
    };
    const double quarter = std::numbers::pi / 2;
    const double ahead = std::min(std::acos(horizon(x, y, line.x, line.y)), tilt + quarter);
    const double behind = std::max(-std::acos(horizon(x, y, -line.x, -line.y)), tilt - quarter);
    return std::hypot(across, n.z) * (arc(ahead) + arc(behind));
  }

  float at(int x, int y) const {
    if (std::isnan(maps.height.at(x, y))) return 1;
    double open = 0;
    for (const Line& line : lines) open += line.share * slice(x, y, line);
    return static_cast<float>(std::clamp(open, 0.0, 1.0));
  }
};

}  // namespace

ImageF ambient_occlusion(const ReliefMaps& maps, double pixel) {
  const int width = maps.height.width;
  const int height = maps.height.height;
  const Sky sky{maps, pixel, steps_of(std::max(width, height))};
  ImageF open(width, height, 1);
  run_tasks((height + band_rows - 1) / band_rows, [&](int band) {
    for (int y = band * band_rows; y < std::min(height, (band + 1) * band_rows); ++y)
      for (int x = 0; x < width; ++x) open.at(x, y) = sky.at(x, y);
  });
  return open;
}

}  // namespace relievo::relief
