#include "kernel/operators/gradient.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

namespace relievo {
namespace {

/// Neighbours a quadratic fit needs at least; five would merely interpolate.
constexpr size_t enough_neighbours = 6;

/// Least squares fit of a x + b y + c x^2 + d x y + e y^2, samples weighted by 1 / distance^2.
class QuadraticFit {
 public:
  /// `reach` is the longest of the offsets.
  explicit QuadraticFit(double reach) : per_reach_(1 / reach) {}

  void add(Point2 offset, double value) {
    const double x = offset.x * per_reach_;
    const double y = offset.y * per_reach_;
    const double weight = 1 / (x * x + y * y);
    const double basis[5] = {x, y, x * x, x * y, y * y};
    for (int j = 0; j < 5; ++j) {
      const double weighted = weight * basis[j];
      for (int i = j; i < 5; ++i) normal_(i, j) += weighted * basis[i];
      moments_[j] += weighted * value;
    }
  }

  /// Gradient at the origin, if the samples determine it.
  std::optional<Point2> gradient() const {
    const Eigen::LDLT<Eigen::Matrix<double, 5, 5>> ldlt(normal_);
    const Vector pivots = ldlt.vectorD();
    if (!(pivots.minCoeff() > flatness * pivots.maxCoeff())) return std::nullopt;
    const Vector solution = ldlt.solve(moments_);
    return Point2{solution[0] * per_reach_, solution[1] * per_reach_};
  }

 private:
  using Vector = Eigen::Matrix<double, 5, 1>;
  static constexpr double flatness = 1e-4;
  double per_reach_;
  Eigen::Matrix<double, 5, 5> normal_ = Eigen::Matrix<double, 5, 5>::Zero();  // lower triangle
  Vector moments_ = Vector::Zero();
};

/// Collects the nodes around one node after the other.
class Neighbourhoods {
 public:
  explicit Neighbourhoods(const FlatMesh& mesh)
      : mesh_(mesh), corners_(corners_at_nodes(mesh)), seen_(mesh.positions.size(), -1) {}

  /// One ring of neighbours inside; two on a boundary and where one has too few.
  const std::vector<int>& around(int node) {
    nodes_.clear();
    seen_[node] = node;
    add_ring(node, node);
    const size_t ring = nodes_.size();
    const size_t faces = static_cast<size_t>(corners_.begin[node + 1] - corners_.begin[node]);
    if (ring != faces || ring < enough_neighbours)
      for (size_t i = 0; i < ring; ++i) add_ring(nodes_[i], node);
    return nodes_;
  }

  const NodeCorners& corners() const { return corners_; }

 private:
  void add_ring(int centre, int node) {
    for (int i = corners_.begin[centre]; i < corners_.begin[centre + 1]; ++i)
      for (const int other : mesh_.triangles[corners_.corner[i] / 3]) {
        if (seen_[other] == node) continue;
        seen_[other] = node;
        nodes_.push_back(other);
      }
  }

  const FlatMesh& mesh_;
  NodeCorners corners_;
  std::vector<int> seen_;
  std::vector<int> nodes_;
};

std::optional<Point2> fitted_gradient(const FlatMesh& mesh, std::span<const double> values,
                                      int node, const std::vector<int>& around) {
  const Point2 origin = mesh.positions[node];
  double squared_reach = 0;
  for (const int other : around) {
    const Point2 offset = mesh.positions[other] - origin;
    squared_reach = std::max(squared_reach, dot(offset, offset));
  }
  QuadraticFit fit(std::sqrt(squared_reach));
  for (const int other : around) {
    const Point2 offset = mesh.positions[other] - origin;
    if (dot(offset, offset) > 0) fit.add(offset, values[other] - values[node]);
  }
  return fit.gradient();
}

Point2 face_gradient(const FlatMesh& mesh, std::span<const double> values, int face) {
  const auto& [a, b, c] = mesh.triangles[face];
  const Point2 e = mesh.positions[b] - mesh.positions[a];
  const Point2 f = mesh.positions[c] - mesh.positions[a];
  const double along_e = values[b] - values[a];
  const double along_f = values[c] - values[a];
  const double twice_area = cross(e, f);
  return {(along_e * f.y - along_f * e.y) / twice_area,
          (along_f * e.x - along_e * f.x) / twice_area};
}

Point2 mean_gradient(const FlatMesh& mesh, std::span<const double> values,
                     const NodeCorners& corners, int node) {
  Point2 sum;
  double weight = 0;
  for (int i = corners.begin[node]; i < corners.begin[node + 1]; ++i) {
    const int face = corners.corner[i] / 3;
    const auto& [a, b, c] = mesh.triangles[face];
    const double area =
        cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    sum = sum + area * face_gradient(mesh, values, face);
    weight += area;
  }
  return weight > 0 ? (1 / weight) * sum : Point2{};
}

}  // namespace

std::vector<Point2> face_gradients(const FlatMesh& mesh, std::span<const double> values) {
  assert(values.size() == mesh.positions.size());
  std::vector<Point2> gradients;
  gradients.reserve(mesh.triangles.size());
  for (size_t f = 0; f < mesh.triangles.size(); ++f)
    gradients.push_back(face_gradient(mesh, values, static_cast<int>(f)));
  return gradients;
}

std::vector<Point2> node_gradients(const FlatMesh& mesh, std::span<const double> values) {
  assert(values.size() == mesh.positions.size());
  Neighbourhoods neighbourhoods(mesh);
  std::vector<Point2> gradients;
  gradients.reserve(mesh.positions.size());
  for (int n = 0; n < static_cast<int>(mesh.positions.size()); ++n) {
    const std::optional<Point2> fitted = fitted_gradient(mesh, values, n, neighbourhoods.around(n));
    gradients.push_back(fitted ? *fitted
                               : mean_gradient(mesh, values, neighbourhoods.corners(), n));
  }
  return gradients;
}

}  // namespace relievo
