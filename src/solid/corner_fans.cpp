#include "solid/corner_fans.h"

namespace relievo {
namespace {

/// Returns the corner of the next triangle counter-clockwise around the same point, or -1 at the
/// rim.
int next_corner(const HeightField& field, const FieldEdges& edges, int corner) {
  const int other = edges.across[corner / 3][(corner % 3 + 2) % 3];
  if (other < 0) return -1;
  const int point = field.vertex_point[field.corner_vertex(corner)];
  for (int k = 0; k < 2; ++k)
    if (field.vertex_point[field.triangles[other][k]] == point) return 3 * other + k;
  return 3 * other + 2;
}

}  // namespace

CornerFans collect_fans(const HeightField& field, const FieldEdges& edges) {
  const int corners = static_cast<int>(3 * field.triangles.size());
  std::vector<char> seen(static_cast<size_t>(corners));
  CornerFans fans;
  fans.begin.push_back(0);
  fans.corners.reserve(seen.size());
  const auto walk = [&](int first) {
    int corner = first;
    for (; corner >= 0 && seen[corner] == 0; corner = next_corner(field, edges, corner)) {
      seen[corner] = 1;
      fans.corners.push_back(corner);
    }
    fans.closed.push_back(corner == first);
    fans.begin.push_back(static_cast<int>(fans.corners.size()));
  };
  for (int c = 0; c < corners; ++c)
    if (edges.across[c / 3][c % 3] < 0) walk(c);
  for (int c = 0; c < corners; ++c)
    if (seen[c] == 0) walk(c);
  return fans;
}

}  // namespace relievo
