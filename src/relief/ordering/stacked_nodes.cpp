#include "relief/ordering/stacked_nodes.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace relievo {
namespace {

using Face = std::array<int, 3>;

bool may_cross(const LayeredMesh& mesh, int lower, int upper) {
  const auto on_outline = [&](int node) {
    const NodeRole role = mesh.node_role[node];
    return role == NodeRole::outline || role == NodeRole::ramp;
  };
  return lower != upper && !on_outline(lower) && !on_outline(upper);
}

/// Calls visit(lower, upper, face pair, corner) where nodes may cross.
template <class Visit>
void for_each_corner(const LayeredMesh& mesh, const std::vector<FacePair>& faces,
                     const Visit& visit) {
  for (size_t i = 0; i < faces.size(); ++i) {
    const Face& lower = mesh.faces[faces[i].lower];
    const Face& upper = mesh.faces[faces[i].upper];
    for (int k = 0; k < 3; ++k)
      if (may_cross(mesh, lower[k], upper[k])) visit(lower[k], upper[k], i, k);
  }
}

/// A corner of two stacked faces, by its upper node.
struct Corner {
  int upper = -1;
  int face = -1;
  int k = -1;
  auto key() const { return std::tie(upper, face, k); }
};

}  // namespace

StackedNodes stacked_nodes(const LayeredMesh& mesh, std::vector<FacePair> faces) {
  const size_t nodes = mesh.node_vertex.size();
  std::vector<int> begin(nodes + 1, 0);
  for_each_corner(mesh, faces, [&](int lower, int, size_t, int) { ++begin[lower + 1]; });
  for (size_t n = 0; n < nodes; ++n) begin[n + 1] += begin[n];
  std::vector<Corner> corners(static_cast<size_t>(begin[nodes]));
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for_each_corner(mesh, faces, [&](int lower, int upper, size_t face, int k) {
    corners[next[lower]++] = {upper, static_cast<int>(face), k};
  });
  StackedNodes result{std::move(faces), {}, {}};
  result.of_faces.assign(result.faces.size(), {-1, -1, -1});
  for (int n = 0; n < static_cast<int>(nodes); ++n) {
    std::sort(corners.begin() + begin[n], corners.begin() + begin[n + 1],
              [](const Corner& a, const Corner& b) { return a.key() < b.key(); });
    for (int i = begin[n]; i < begin[n + 1]; ++i) {
      if (i == begin[n] || corners[i].upper != corners[i - 1].upper)
        result.pairs.push_back({n, corners[i].upper, false});
      result.of_faces[corners[i].face][corners[i].k] = static_cast<int>(result.pairs.size()) - 1;
    }
  }
  return result;
}

std::vector<uint8_t> crossed(const StackedNodes& stacked, const std::vector<double>& h,
                             double tolerance) {
  std::vector<uint8_t> flags;
  flags.reserve(stacked.pairs.size());
  for (const DepthPair& pair : stacked.pairs)
    flags.push_back(h[pair.lower] - h[pair.upper] > tolerance);
  return flags;
}

std::vector<uint8_t> grown(const StackedNodes& stacked, std::vector<uint8_t> chosen, int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<uint8_t> inner = chosen;
    for (const std::array<int, 3>& corners : stacked.of_faces)
      for (const int pair : corners) {
        if (pair < 0 || inner[pair] == 0) continue;
        for (const int other : corners)
          if (other >= 0) chosen[other] = 1;
      }
  }
  return chosen;
}

std::vector<uint8_t> flags_of(const StackedNodes& stacked, const std::vector<DepthPair>& pairs) {
  const auto key = [](const DepthPair& pair) { return std::tie(pair.lower, pair.upper); };
  std::vector<uint8_t> flags;
  flags.reserve(stacked.pairs.size());
  auto next = pairs.begin();
  for (const DepthPair& pair : stacked.pairs) {
    while (next != pairs.end() && key(*next) < key(pair)) ++next;
    flags.push_back(next != pairs.end() && *next == pair);
  }
  return flags;
}

std::vector<DepthPair> flagged(const StackedNodes& stacked, const std::vector<uint8_t>& chosen) {
  std::vector<DepthPair> pairs;
  for (size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i] != 0) pairs.push_back(stacked.pairs[i]);
  return pairs;
}

}  // namespace relievo
