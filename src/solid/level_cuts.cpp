#include "solid/level_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace relievo {
namespace {

/// Returns for each position the index of the first equal one, in single precision.
std::vector<int> first_at_position(const std::vector<Point3>& positions) {
  std::vector<std::array<float, 3>> keys;
  for (const Point3 p : positions)
    keys.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  std::vector<int> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] < keys[b]; });
  std::vector<int> first = order;
  for (size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && keys[order[i]] == keys[order[i - 1]];
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// A piece of a ring across one triangle, from the edge that falls to the edge that rises.
struct Crossing {
  uint64_t from = 0;  ///< edge, by its two vertices
  uint64_t to = 0;
  int triangle = 0;
};

uint64_t edge_key(int a, int b) {
  return (static_cast<uint64_t>(std::min(a, b)) << 32) | static_cast<uint32_t>(std::max(a, b));
}

}  // namespace

LevelCutter::LevelCutter(const Model& model)
    : model_(model), place_(first_at_position(model.positions)) {
  triangle_part_.resize(model.triangles.size());
  for (size_t p = 0; p < model.parts.size(); ++p)
    std::fill_n(triangle_part_.begin() + model.parts[p].first_triangle,
                model.parts[p].triangle_count, static_cast<int>(p));
}

LevelCut LevelCutter::cut(double height) const {
  std::vector<Crossing> crossings;
  for (size_t t = 0; t < model_.triangles.size(); ++t) {
    const std::array<int, 3>& corners = model_.triangles[t];
    std::array<bool, 3> above{};
    for (int k = 0; k < 3; ++k) above[k] = model_.positions[corners[k]].z >= height;
    if (above[0] == above[1] && above[1] == above[2]) continue;
    Crossing& crossing = crossings.emplace_back();
    crossing.triangle = static_cast<int>(t);
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (above[k] == above[next]) continue;
      (above[k] ? crossing.from : crossing.to) =
          edge_key(place_[corners[k]], place_[corners[next]]);
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::pair(a.from, a.triangle) < std::pair(b.from, b.triangle);
  });
  const auto starting_at = [&crossings](uint64_t edge) {
    const auto at = std::lower_bound(crossings.begin(), crossings.end(), edge,
                                     [](const Crossing& c, uint64_t key) { return c.from < key; });
    return static_cast<size_t>(at - crossings.begin());
  };
  const auto place_on = [&](uint64_t edge) {
    const Point3 a = model_.positions[static_cast<size_t>(edge >> 32)];
    const Point3 b = model_.positions[static_cast<size_t>(edge & 0xffffffffU)];
    const double s = (height - a.z) / (b.z - a.z);
    return ClipperLib::IntPoint(std::llround(cut_steps * (a.x + s * (b.x - a.x))),
                                std::llround(cut_steps * (a.y + s * (b.y - a.y))));
  };
  LevelCut result;
  std::vector<char> done(crossings.size());
  for (size_t first = 0; first < crossings.size(); ++first) {
    if (done[first] != 0) continue;
    ClipperLib::Path& ring = result.rings.emplace_back();
    for (size_t c = first; c < crossings.size() && done[c] == 0; c = starting_at(crossings[c].to)) {
      done[c] = 1;
      ring.push_back(place_on(crossings[c].from));
      result.corners.push_back(ring.back());
      result.corner_parts.push_back(triangle_part_[crossings[c].triangle]);
    }
  }
  return result;
}

}  // namespace relievo
