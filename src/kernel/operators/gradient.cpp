#include "kernel/operators/gradient.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "kernel/base/workers.h"

namespace relievo {
namespace {

/// Least number of neighbours of a quadratic fit; five would merely interpolate.
constexpr size_t enough_neighbours = 6;
/// Neighbours of a node on average, with room to spare.
constexpr size_t usual_neighbours = 9;
/// Stencils are made in up to so many pieces, as each needs a look-up table as large as the mesh.
constexpr int most_pieces = 16;
/// Nodes per piece at least.
constexpr int least_nodes = 4096;

/// The least squares fit of a x + b y + c x^2 + d x y + e y^2 with weights 1 / distance^2. Solves
/// the normal equations for the gradient (a, b) by eliminating c, d and e.
class QuadraticFit {
 public:
  /// `reach`: length of the longest offset.
  explicit QuadraticFit(double reach) : per_reach_(1 / reach) {}

  /// Adds a sample at `offset` from the node.
  void add(Point2 offset) {
    const Sample s = sample_at(offset);
    const double xx = s.weight * s.xx;
    const double yy = s.weight * s.yy;
    linear_ += Eigen::Vector3d(xx, s.weight * s.xy, yy);
    cubic_ += Eigen::Vector4d(xx * s.x, xx * s.y, yy * s.x, yy * s.y);
    quartic_[0] += xx * s.xx;
    quartic_[1] += xx * s.xy;
    quartic_[2] += xx * s.yy;
    quartic_[3] += yy * s.xy;
    quartic_[4] += yy * s.yy;
  }

  /// Prepares weight_of(). Returns false where the samples do not determine the gradient.
  bool solve() {
    Eigen::Matrix3d quadratic;        // lower triangle
    quadratic << quartic_[0], 0, 0,   //
        quartic_[1], quartic_[2], 0,  //
        quartic_[2], quartic_[3], quartic_[4];
    Eigen::Matrix<double, 3, 2> mixed;
    mixed << cubic_[0], cubic_[1],  //
        cubic_[1], cubic_[2],       //
        cubic_[2], cubic_[3];
    const Eigen::LLT<Eigen::Matrix3d> llt(quadratic);
    if (llt.info() != Eigen::Success) return false;
    eliminated_ = llt.solve(mixed);
    const Eigen::Matrix2d rest = mixed.transpose() * eliminated_;
    const double xx = linear_[0] - rest(0, 0);
    const double xy = linear_[1] - rest(1, 0);
    const double yy = linear_[2] - rest(1, 1);
    const double determinant = xx * yy - xy * xy;
    const double trace = xx + yy;
    const Eigen::Vector3d roots = llt.matrixLLT().diagonal();
    const double most = std::max(trace, roots.cwiseAbs2().maxCoeff());
    const double least = std::min(determinant / trace, roots.cwiseAbs2().minCoeff());
    if (!(trace > 0 && least > flatness * most)) return false;
    inverse_ = {yy / determinant, -xy / determinant, xx / determinant};
    return true;
  }

  /// Returns the derivative of the gradient by the value at a sample. Precondition: solve()
  /// returned true.
  Point2 weight_of(Point2 offset) const {
    const Sample s = sample_at(offset);
    const Eigen::Vector2d rest =
        Eigen::Vector2d(s.x, s.y) - eliminated_.transpose() * Eigen::Vector3d(s.xx, s.xy, s.yy);
    const double scale = s.weight * per_reach_;
    return {scale * (inverse_[0] * rest[0] + inverse_[1] * rest[1]),
            scale * (inverse_[1] * rest[0] + inverse_[2] * rest[1])};
  }

 private:
  struct Sample {
    double weight;
    double x, y, xx, xy, yy;
  };

  Sample sample_at(Point2 offset) const {
    const double x = offset.x * per_reach_;
    const double y = offset.y * per_reach_;
    return {1 / (x * x + y * y), x, y, x * x, x * y, y * y};
  }

  static constexpr double flatness = 1e-4;  ///< least ratio of the pivots
  double per_reach_;
  // The blocks of the normal matrix: weighted sums of products of two linear terms, of a linear and
  // a quadratic one, and of two quadratic ones.
  Eigen::Vector3d linear_ = Eigen::Vector3d::Zero();  ///< xx xy yy
  Eigen::Vector4d cubic_ = Eigen::Vector4d::Zero();   ///< xxx xxy xyy yyy
  std::array<double, 5> quartic_{};                   ///< xxxx xxxy xxyy xyyy yyyy
  Eigen::Matrix<double, 3, 2> eliminated_;            ///< quadratic block^-1 times the mixed block
  std::array<double, 3> inverse_{};                   ///< of the Schur complement: xx xy yy
};

/// Collects in `nodes` the neighbours that the fit at `node` takes: one ring inside; two on a
/// boundary and where one has too few. `seen`, #N: the last node for which each was collected.
void collect_neighbours(const FlatMesh& mesh, const NodeCorners& corners, int node,
                        std::vector<int>& seen, std::vector<int>& nodes) {
  const auto add_ring = [&](int centre) {
    for (const Corner corner : corners.at(centre))
      for (const int other : mesh.triangles[triangle_of(corner)]) {
        if (seen[other] == node) continue;
        seen[other] = node;
        nodes.push_back(other);
      }
  };
  nodes.clear();
  seen[node] = node;
  add_ring(node);
  const size_t ring = nodes.size();
  if (ring != corners.at(node).size() || ring < enough_neighbours)
    for (size_t i = 0; i < ring; ++i) add_ring(nodes[i]);
}

/// Appends the stencil of a quadratic fit. Returns false where the fit is not determined.
bool append_fit(const FlatMesh& mesh, int node, const std::vector<int>& around,
                GradientStencils& stencils) {
  const Point2 origin = mesh.positions[node];
  double squared_reach = 0;
  for (const int other : around) {
    const Point2 offset = mesh.positions[other] - origin;
    squared_reach = std::max(squared_reach, dot(offset, offset));
  }
  QuadraticFit fit(std::sqrt(squared_reach));
  const auto apart = [&](int other) { return !(mesh.positions[other] == origin); };
  for (const int other : around)
    if (apart(other)) fit.add(mesh.positions[other] - origin);
  if (!fit.solve()) return false;
  for (const int other : around) {
    if (!apart(other)) continue;
    stencils.neighbour.push_back(other);
    stencils.weight.push_back(fit.weight_of(mesh.positions[other] - origin));
  }
  return true;
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

/// Appends the stencil of the area-weighted mean of the gradients on the faces around the node.
void append_mean(const FlatMesh& mesh, int node, const NodeCorners& corners,
                 GradientStencils& stencils) {
  double twice_area = 0;
  for (const Corner corner : corners.at(node)) {
    const auto& [a, b, c] = mesh.triangles[triangle_of(corner)];
    twice_area +=
        cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
  }
  if (!(twice_area > 0)) return;
  for (const Corner corner : corners.at(node)) {
    const Triangle& triangle = mesh.triangles[triangle_of(corner)];
    for (int k = 0; k < 3; ++k) {
      if (triangle[k] == node) continue;
      const Point2 across =
          mesh.positions[triangle[last_place(k)]] - mesh.positions[triangle[next_place(k)]];
      stencils.neighbour.push_back(triangle[k]);
      stencils.weight.push_back((1 / twice_area) * Point2{-across.y, across.x});
    }
  }
}

/// Computes the stencils of the nodes [first, last), with `begin` counted from 0.
GradientStencils stencils_of_range(const FlatMesh& mesh, const NodeCorners& corners, int first,
                                   int last) {
  std::vector<int> seen(mesh.positions.size(), -1);
  std::vector<int> around;
  GradientStencils stencils;
  stencils.begin.reserve(static_cast<size_t>(last - first) + 1);
  stencils.neighbour.reserve(usual_neighbours * static_cast<size_t>(last - first));
  stencils.weight.reserve(stencils.neighbour.capacity());
  stencils.begin.push_back(0);
  for (int n = first; n < last; ++n) {
    collect_neighbours(mesh, corners, n, seen, around);
    if (!append_fit(mesh, n, around, stencils)) append_mean(mesh, n, corners, stencils);
    stencils.begin.push_back(stencils.neighbour.size());
  }
  return stencils;
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

GradientStencils gradient_stencils(const FlatMesh& mesh) {
  const NodeCorners corners = corners_at_nodes(mesh.triangles, mesh.positions.size());
  const int nodes = static_cast<int>(mesh.positions.size());
  const int pieces = std::clamp(nodes / least_nodes, 1, most_pieces);
  std::vector<GradientStencils> parts(static_cast<size_t>(pieces));
  const auto at = [&](int p) { return static_cast<int>(int64_t{nodes} * p / pieces); };
  run_tasks(pieces, [&](int p) { parts[p] = stencils_of_range(mesh, corners, at(p), at(p + 1)); });
  size_t entries = 0;
  for (const GradientStencils& part : parts) entries += part.neighbour.size();
  GradientStencils all;
  all.begin.reserve(mesh.positions.size() + 1);
  all.neighbour.reserve(entries);
  all.weight.reserve(entries);
  all.begin.push_back(0);
  for (const GradientStencils& part : parts) {
    const size_t before = all.neighbour.size();
    for (size_t i = 1; i < part.begin.size(); ++i) all.begin.push_back(before + part.begin[i]);
    all.neighbour.insert(all.neighbour.end(), part.neighbour.begin(), part.neighbour.end());
    all.weight.insert(all.weight.end(), part.weight.begin(), part.weight.end());
  }
  return all;
}

std::vector<Point2> node_gradients(const GradientStencils& stencils,
                                   std::span<const double> values) {
  assert(values.size() + 1 == stencils.begin.size());
  std::vector<Point2> gradients(values.size());
  run_ranges(static_cast<int>(values.size()), [&](int first, int last) {
    for (int n = first; n < last; ++n) {
      Point2 gradient{0, 0};
      for (size_t i = stencils.begin[n]; i < stencils.begin[n + 1]; ++i)
        gradient = gradient + (values[stencils.neighbour[i]] - values[n]) * stencils.weight[i];
      gradients[n] = gradient;
    }
  });
  return gradients;
}

std::vector<Point2> node_gradients(const FlatMesh& mesh, std::span<const double> values) {
  return node_gradients(gradient_stencils(mesh), values);
}

}  // namespace relievo
