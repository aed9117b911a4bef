#include "solid/level_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace relievo {
namespace {

struct PlaceHash {
  size_t operator()(const std::array<float, 3>& p) const {
    uint64_t hash = 0;
    for (const float v : p)
      hash =
          (hash ^ static_cast<uint64_t>(static_cast<int64_t>(v * cut_steps))) * 0x9E3779B97F4A7C15U;
    return static_cast<size_t>(hash ^ (hash >> 29));
  }
};

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

LevelCutter::LevelCutter(const Model& model) : model_(model) {
  std::unordered_map<std::array<float, 3>, int, PlaceHash> first;
  first.reserve(model.positions.size());
  for (const Point3 p : model.positions) {
    const std::array<float, 3> key = {static_cast<float>(p.x), static_cast<float>(p.y),
                                      static_cast<float>(p.z)};
    place_.push_back(first.try_emplace(key, static_cast<int>(place_.size())).first->second);
  }
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
