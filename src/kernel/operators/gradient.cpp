#include "kernel/operators/gradient.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <vector>

namespace relievo {
namespace {

/// Weighted least squares of a linear vector function, from samples around the origin.
class LinearFit {
 public:
  void add(double weight, Point2 offset, Point2 value) {
    const Eigen::Vector3d basis(1, offset.x, offset.y);
    normal_ += weight * basis * basis.transpose();
    moments_ += weight * basis * Eigen::RowVector2d(value.x, value.y);
  }

  /// The fitted value at the origin; the weighted mean where the samples do not span the plane.
  Point2 at_origin() const {
    const double weight = normal_(0, 0);
    if (!(weight > 0)) return {};
    const Eigen::Vector2d mean = normal_.block<2, 1>(1, 0) / weight;
    const Eigen::Matrix2d spread = normal_.block<2, 2>(1, 1) / weight - mean * mean.transpose();
    const Eigen::RowVector2d value = moments_.row(0) / weight;
    const double trace = spread.trace();
    if (!(spread.determinant() > flatness * trace * trace)) return {value.x(), value.y()};
    const Eigen::Matrix2d covariance = moments_.block<2, 2>(1, 0) / weight - mean * value;
    const Eigen::RowVector2d fitted = value - mean.transpose() * spread.ldlt().solve(covariance);
    return {fitted.x(), fitted.y()};
  }

 private:
  static constexpr double flatness = 1e-3;
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> moments_ = Eigen::Matrix<double, 3, 2>::Zero();
};

/// The triangles around a node; those around its neighbours too where its fan is open.
class Patches {
 public:
  explicit Patches(const FlatMesh& mesh)
      : mesh_(mesh),
        corners_(corners_at_nodes(mesh)),
        seen_node_(mesh.positions.size(), -1),
        seen_face_(mesh.triangles.size(), -1) {}

  const std::vector<int>& around(int node) {
    faces_.clear();
    neighbours_.clear();
    add_faces(node, node);
    const size_t ring = faces_.size();
    for (size_t i = 0; i < ring; ++i)
      for (const int other : mesh_.triangles[faces_[i]]) add_neighbour(other, node);
    if (neighbours_.size() > ring)
      for (const int neighbour : neighbours_) add_faces(neighbour, node);
    return faces_;
  }

 private:
  void add_neighbour(int other, int node) {
    if (other == node || seen_node_[other] == node) return;
    seen_node_[other] = node;
    neighbours_.push_back(other);
  }

  void add_faces(int around, int node) {
    for (int i = corners_.begin[around]; i < corners_.begin[around + 1]; ++i) {
      const int face = corners_.corner[i] / 3;
      if (seen_face_[face] == node) continue;
      seen_face_[face] = node;
      faces_.push_back(face);
    }
  }

  const FlatMesh& mesh_;
  NodeCorners corners_;
  std::vector<int> seen_node_;
  std::vector<int> seen_face_;
  std::vector<int> faces_;
  std::vector<int> neighbours_;
};

Point2 centroid(const FlatMesh& mesh, int face) {
  const auto& [a, b, c] = mesh.triangles[face];
  return (1.0 / 3) * (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]);
}

}  // namespace

std::vector<Point2> face_gradients(const FlatMesh& mesh, std::span<const double> values) {
  assert(values.size() == mesh.positions.size());
  std::vector<Point2> gradients;
  gradients.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 e = mesh.positions[b] - mesh.positions[a];
    const Point2 f = mesh.positions[c] - mesh.positions[a];
    const double along_e = values[b] - values[a];
    const double along_f = values[c] - values[a];
    const double twice_area = cross(e, f);
    gradients.push_back({(along_e * f.y - along_f * e.y) / twice_area,
                         (along_f * e.x - along_e * f.x) / twice_area});
  }
  return gradients;
}

std::vector<Point2> node_gradients(const FlatMesh& mesh, std::span<const double> values) {
  const std::vector<Point2> on_faces = face_gradients(mesh, values);
  const std::vector<double> areas = triangle_areas(mesh);
  Patches patches(mesh);
  std::vector<Point2> gradients;
  gradients.reserve(mesh.positions.size());
  for (size_t n = 0; n < mesh.positions.size(); ++n) {
    LinearFit fit;
    for (const int face : patches.around(static_cast<int>(n)))
      fit.add(areas[face], centroid(mesh, face) - mesh.positions[n], on_faces[face]);
    gradients.push_back(fit.at_origin());
  }
  return gradients;
}

}  // namespace relievo
