#include "io/mesh/filament_colours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>

namespace relievo {
namespace {

using Rgb = std::array<uint8_t, 3>;

constexpr int rounds = 24;

double linear(uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// Converts to OKLab (B. Ottosson, 2020), whose distances match perceived ones.
Point3 oklab(const Rgb& rgb) {
  const double r = linear(rgb[0]);
  const double g = linear(rgb[1]);
  const double b = linear(rgb[2]);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double square(Point3 p) { return dot(p, p); }

/// Triangles of nearly the same colour.
struct Swatch {
  double area = 0;
  std::array<double, 3> sum{};  ///< of sRGB values times area
  Rgb rgb{};
  Point3 lab;
  int cluster = 0;
};

Rgb colour_at(const Model& model, const Image8& texture, const std::array<int, 3>& t) {
  const Point2 uv = (1.0 / 3) * (model.uvs[t[0]] + model.uvs[t[1]] + model.uvs[t[2]]);
  const auto pixel = [](double v, int count) {
    return std::clamp(static_cast<int>(v * count), 0, count - 1);
  };
  const int x = pixel(uv.x, texture.width);
  const int y = pixel(uv.y, texture.height);
  return {texture.at(x, y, 0), texture.at(x, y, 1), texture.at(x, y, 2)};
}

double area_of(const Model& model, const std::array<int, 3>& t) {
  const Point3 a = model.positions[t[0]];
  return 0.5 * norm(cross(model.positions[t[1]] - a, model.positions[t[2]] - a));
}

Rgb mean(const std::array<double, 3>& sum, double area) {
  Rgb rgb{};
  for (size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<uint8_t>(std::clamp(std::lround(sum[c] / area), 0L, 255L));
  return rgb;
}

/// Collects a swatch for every colour of 5 bits a channel; `of_triangle` gets its index by
/// triangle.
std::vector<Swatch> collect_swatches(const Model& model, const Image8& texture,
                                     std::vector<int>& of_triangle) {
  std::map<int, int> numbers;
  std::vector<Swatch> swatches;
  for (const std::array<int, 3>& t : model.triangles) {
    const Rgb rgb = colour_at(model, texture, t);
    const int key = (rgb[0] >> 3) << 10 | (rgb[1] >> 3) << 5 | rgb[2] >> 3;
    const auto [at, fresh] = numbers.try_emplace(key, static_cast<int>(swatches.size()));
    if (fresh) swatches.emplace_back();
    Swatch& swatch = swatches[at->second];
    // A triangle without area needs a colour too.
    const double area = area_of(model, t) + 1e-12;
    swatch.area += area;
    for (size_t c = 0; c < 3; ++c) swatch.sum[c] += area * rgb[c];
    of_triangle.push_back(at->second);
  }
  for (Swatch& swatch : swatches) {
    swatch.rgb = mean(swatch.sum, swatch.area);
    swatch.lab = oklab(swatch.rgb);
  }
  return swatches;
}

std::vector<Point3> first_centres(const std::vector<Swatch>& swatches, int count) {
  std::vector<double> distance(swatches.size(), 1);
  std::vector<Point3> centres;
  while (static_cast<int>(centres.size()) < count) {
    size_t best = 0;
    for (size_t i = 1; i < swatches.size(); ++i)
      if (swatches[i].area * distance[i] > swatches[best].area * distance[best]) best = i;
    if (!centres.empty() && distance[best] == 0) break;
    centres.push_back(swatches[best].lab);
    for (size_t i = 0; i < swatches.size(); ++i) {
      const double away = square(swatches[i].lab - centres.back());
      distance[i] = centres.size() == 1 ? away : std::min(distance[i], away);
    }
  }
  return centres;
}

void cluster(std::vector<Swatch>& swatches, std::vector<Point3>& centres) {
  for (int round = 0; round < rounds; ++round) {
    for (Swatch& swatch : swatches) {
      swatch.cluster = 0;
      for (int k = 1; k < static_cast<int>(centres.size()); ++k)
        if (square(swatch.lab - centres[k]) < square(swatch.lab - centres[swatch.cluster]))
          swatch.cluster = k;
    }
    std::vector<Point3> sums(centres.size());
    std::vector<double> areas(centres.size());
    for (const Swatch& swatch : swatches) {
      sums[swatch.cluster] = sums[swatch.cluster] + swatch.area * swatch.lab;
      areas[swatch.cluster] += swatch.area;
    }
    for (size_t k = 0; k < centres.size(); ++k)
      if (areas[k] > 0) centres[k] = 1 / areas[k] * sums[k];
  }
}

}  // namespace

FilamentColours reduce_colours(const Model& model, const Image8& texture, int count) {
  std::vector<int> of_triangle;
  std::vector<Swatch> swatches = collect_swatches(model, texture, of_triangle);
  if (swatches.empty()) return {};
  std::vector<Point3> centres = first_centres(swatches, count);
  cluster(swatches, centres);
  std::vector<Swatch> colours(centres.size());
  for (const Swatch& swatch : swatches) {
    Swatch& colour = colours[swatch.cluster];
    colour.area += swatch.area;
    for (size_t c = 0; c < 3; ++c) colour.sum[c] += swatch.sum[c];
  }
  std::vector<int> order(colours.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return colours[a].area > colours[b].area; });
  FilamentColours result;
  std::vector<uint8_t> number(colours.size());
  for (const int k : order) {
    if (colours[k].area == 0) break;
    number[k] = static_cast<uint8_t>(result.colours.size());
    result.colours.push_back(mean(colours[k].sum, colours[k].area));
  }
  for (const int swatch : of_triangle) result.triangle.push_back(number[swatches[swatch].cluster]);
  return result;
}

}  // namespace relievo
