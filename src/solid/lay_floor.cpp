#include "solid/lay_floor.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/laplacian.h"

namespace relievo {
namespace {

constexpr double least_freedom = 1e-6;  ///< least squared freedom, that of fixed points
constexpr double least_mass = 1e-12;    ///< least diagonal stiffness, that of points without area

struct Neighbour {
  int point = 0;
  double far = 0;  ///< grid steps
};

/// By point; every edge is there in both directions, an edge between two triangles twice.
using Neighbours = std::vector<std::vector<Neighbour>>;

Neighbours neighbours_of(const HeightField& field) {
  Neighbours beside(field.points.size());
  for (const std::array<int, 3>& t : field.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = field.vertex_point[t[k]];
      const int b = field.vertex_point[t[(k + 1) % 3]];
      const GridPoint p = field.points[a];
      const GridPoint q = field.points[b];
      const double far = std::hypot(static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y));
      beside[a].push_back({b, far});
      beside[b].push_back({a, far});
    }
  return beside;
}

/// Raises values that are lower than a neighbour's by more than its distance.
void spread(const Neighbours& beside, std::vector<int64_t>& values) {
  std::priority_queue<std::pair<int64_t, int>> open;
  for (size_t p = 0; p < values.size(); ++p)
    if (values[p] > 0) open.emplace(values[p], static_cast<int>(p));
  while (!open.empty()) {
    const auto [value, p] = open.top();
    open.pop();
    if (value < values[p]) continue;
    for (const Neighbour& next : beside[p]) {
      const int64_t left = value - std::llround(next.far);
      if (left <= values[next.point]) continue;
      values[next.point] = left;
      open.emplace(left, next.point);
    }
  }
}

/// Returns how freely each point moves: 0 at the rim, 1 from `soft` inwards.
std::vector<double> freedom(const HeightField& field, const FieldEdges& edges,
                            const Neighbours& beside, int64_t soft) {
  std::vector<int64_t> fixed(field.points.size(), 0);
  for (size_t t = 0; t < field.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (edges.across[t][k] < 0)
        for (const int end : {k, (k + 1) % 3})
          fixed[field.vertex_point[field.triangles[t][end]]] = soft;
  spread(beside, fixed);
  std::vector<double> free;
  free.reserve(fixed.size());
  for (const int64_t h : fixed)
    free.push_back(1 - static_cast<double>(h) / static_cast<double>(soft));
  return free;
}

/// Smooths the floor: it becomes the z that minimises the integral of
///   (z - floor)^2 / freedom^2 + soft^2 |grad z|^2.
Status soften(const FieldEdges& edges, const Neighbours& beside, int64_t soft, HeightField& field) {
  // In units of `soft`, for numbers near 1.
  const double unit = 1 / static_cast<double>(soft);
  std::vector<Point2> places;
  for (const GridPoint p : field.points) places.push_back(unit * as_point(p));
  std::vector<std::array<int, 3>> triangles;
  for (const std::array<int, 3>& t : field.triangles)
    triangles.push_back(
        {field.vertex_point[t[0]], field.vertex_point[t[1]], field.vertex_point[t[2]]});
  const FlatMesh mesh{places, triangles};
  const std::vector<double> free = freedom(field, edges, beside, soft);
  const Eigen::VectorXd mass = lumped_mass(mesh);
  Eigen::VectorXd floor(mass.size());
  Eigen::VectorXd load(mass.size());
  SparseMatrix matrix = stiffness_matrix(mesh);
  for (int p = 0; p < static_cast<int>(floor.size()); ++p) {
    const double stiffness =
        std::max(mass[p] / std::max(free[p] * free[p], least_freedom), least_mass);
    matrix.coeffRef(p, p) += stiffness;
    load[p] = stiffness * unit * static_cast<double>(field.floor[p].height);
  }
  SparseCholesky factor;
  if (!factor.analyse(matrix) || !factor.factorise(matrix))
    return Error{ErrorCode::internal, "the back of the figure cannot be computed", ""};
  floor = factor.solve(load);
  for (size_t p = 0; p < free.size(); ++p)
    field.floor[p].height = std::llround(floor[static_cast<Eigen::Index>(p)] / unit);
  return Done{};
}

/// Returns the height by which the floor is too high, by point.
std::vector<int64_t> missing_depth(int64_t least, const HeightField& field) {
  std::vector<int64_t> missing(field.points.size(), 0);
  for (const std::array<int, 3>& triangle : field.triangles)
    for (const int v : triangle) {
      const int p = field.vertex_point[v];
      missing[p] = std::max(missing[p], field.floor[p].height - (field.vertex_height[v] - least));
    }
  return missing;
}

}  // namespace

Status lay_floor(int64_t least, int64_t soft, const FieldEdges& edges, HeightField& field) {
  const Neighbours beside = neighbours_of(field);
  if (soft > 0)
    if (Status status = soften(edges, beside, soft, field); !status) return status;
  std::vector<int64_t> missing = missing_depth(least, field);
  spread(beside, missing);
  for (size_t p = 0; p < missing.size(); ++p) field.floor[p].height -= missing[p];
  for (size_t v = 0; v < field.vertex_height.size(); ++v)
    field.vertex_height[v] -= field.floor[field.vertex_point[v]].height;
  return Done{};
}

}  // namespace relievo
