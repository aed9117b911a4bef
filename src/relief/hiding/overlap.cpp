#include "relief/hiding/overlap.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace relievo::relief {
namespace {

using Face = std::array<int, 3>;

/// Barycentric coordinates.
using Weights = std::array<double, 3>;

constexpr std::array<Weights, 6> inner_points = {{{0.6, 0.2, 0.2},
                                                  {0.2, 0.6, 0.2},
                                                  {0.2, 0.2, 0.6},
                                                  {0.4, 0.4, 0.2},
                                                  {0.4, 0.2, 0.4},
                                                  {0.2, 0.4, 0.4}}};

/// Distances from corners and edges at which rim_dip samples, as shares of the face.
constexpr std::array<double, 2> rim_distances = {0.05, 0.01};

double height_at(const Face& face, const Weights& weight, const std::vector<double>& u,
                 const std::vector<double>& g) {
  double u_here = 0;
  double g_here = 0;
  for (int k = 0; k < 3; ++k) {
    u_here += weight[k] * u[face[k]];
    g_here += weight[k] * g[face[k]];
  }
  return g_here + signed_root(u_here);
}

double dip_at(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
              const Ordering& ordering, const Weights& weight) {
  return height_at(mesh.faces[pair.lower], weight, inflation.u, ordering.g) -
         height_at(mesh.faces[pair.upper], weight, inflation.u, ordering.g);
}

}  // namespace

std::vector<FacePair> stacked_faces(const LayeredMesh& mesh, const Scene& scene) {
  const std::vector<std::pair<int, int>> free = free_parts(scene);
  std::vector<FacePair> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int lower = mesh.stack_begin[t + 1] - 2; lower >= mesh.stack_begin[t]; --lower) {
      int upper = lower + 1;
      while (upper < mesh.stack_begin[t + 1] && may_cross(mesh, free, upper, lower)) ++upper;
      if (upper < mesh.stack_begin[t + 1]) pairs.push_back({lower, upper});
    }
  return pairs;
}

std::vector<FacePair> covered_faces(const LayeredMesh& mesh, const Scene& scene) {
  const std::vector<std::pair<int, int>> free = free_parts(scene);
  std::vector<FacePair> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int front = mesh.stack_begin[t + 1] - 1;
    for (int lower = mesh.stack_begin[t]; lower < front; ++lower)
      if (!may_cross(mesh, free, front, lower)) pairs.push_back({lower, front});
  }
  return pairs;
}

Dip worst_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
              const Ordering& ordering) {
  Dip worst{-std::numeric_limits<double>::infinity(), {}};
  for (const Weights& weight : inner_points) {
    const double depth = dip_at(mesh, pair, inflation, ordering, weight);
    if (depth > worst.depth) worst = {depth, weight};
  }
  return worst;
}

double rim_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
               const Ordering& ordering) {
  double worst = -std::numeric_limits<double>::infinity();
  for (const double near : rim_distances)
    for (int k = 0; k < 3; ++k) {
      Weights corner{near, near, near};
      corner[k] = 1 - 2 * near;
      Weights edge{(1 - near) / 2, (1 - near) / 2, (1 - near) / 2};
      edge[k] = near;
      for (const Weights& weight : {corner, edge})
        worst = std::max(worst, dip_at(mesh, pair, inflation, ordering, weight));
    }
  return worst;
}

}  // namespace relievo::relief
