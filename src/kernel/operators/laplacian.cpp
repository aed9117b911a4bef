#include "kernel/operators/laplacian.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace relievo {
namespace {

/// Computes half the cotangent of the angle at each corner, #F.
std::vector<std::array<double, 3>> half_cotangents(const FlatMesh& mesh) {
  std::vector<std::array<double, 3>> weights(mesh.triangles.size());
  for (size_t t = 0; t < weights.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const Point2 origin = mesh.positions[triangle[k]];
      const Point2 e = mesh.positions[triangle[next_place(k)]] - origin;
      const Point2 f = mesh.positions[triangle[last_place(k)]] - origin;
      weights[t][k] = 0.5 * dot(e, f) / cross(e, f);
    }
  }
  return weights;
}

/// Builds a compressed matrix column by column from unordered contributions.
class ColumnBuilder {
 public:
  /// `entries`: estimated number of entries of the matrix.
  ColumnBuilder(int rows, int columns, Eigen::Index entries)
      : matrix_(rows, columns), slots_(static_cast<size_t>(rows)) {
    matrix_.resizeNonZeros(entries);
  }

  /// Adds to an entry of the current column.
  void add(int row, double value) {
    Slot& slot = slots_[row];
    if (slot.column != column_) {
      slot = {column_, 0};
      rows_.push_back(row);
    }
    slot.value += value;
  }

  /// Writes the current column and begins the next one.
  void finish_column() {
    if (!std::is_sorted(rows_.begin(), rows_.end())) std::sort(rows_.begin(), rows_.end());
    const int begin = matrix_.outerIndexPtr()[column_];
    const int end = begin + static_cast<int>(rows_.size());
    if (end > matrix_.data().size()) matrix_.resizeNonZeros(2 * Eigen::Index{end});
    std::copy(rows_.begin(), rows_.end(), matrix_.innerIndexPtr() + begin);
    double* value = matrix_.valuePtr() + begin;
    for (const int row : rows_) *value++ = slots_[row].value;
    matrix_.outerIndexPtr()[++column_] = end;
    rows_.clear();
  }

  /// Returns the matrix. Precondition: all columns are finished.
  SparseMatrix take() {
    matrix_.resizeNonZeros(matrix_.outerIndexPtr()[column_]);
    SparseMatrix taken;
    taken.swap(matrix_);
    return taken;
  }

 private:
  /// The sum in a row of the last column that has an entry there.
  struct Slot {
    int column = -1;
    double value = 0;
  };

  SparseMatrix matrix_;
  std::vector<Slot> slots_;
  std::vector<int> rows_;
  int column_ = 0;
};

}  // namespace

SparseMatrix stiffness_matrix(const FlatMesh& mesh) {
  const std::vector<std::array<double, 3>> weights = half_cotangents(mesh);
  const NodeCorners corners = corners_at_nodes(mesh.triangles, mesh.positions.size());
  const int n = static_cast<int>(mesh.positions.size());
  ColumnBuilder builder(n, n, n + 4 * static_cast<Eigen::Index>(mesh.triangles.size()));
  for (int node = 0; node < n; ++node) {
    builder.add(node, 0);
    for (const Corner corner : corners.at(node)) {
      const int t = triangle_of(corner);
      const int next = next_place(place_of(corner));
      const int last = last_place(place_of(corner));
      builder.add(node, weights[t][next] + weights[t][last]);
      builder.add(mesh.triangles[t][next], -weights[t][last]);
      builder.add(mesh.triangles[t][last], -weights[t][next]);
    }
    builder.finish_column();
  }
  return builder.take();
}

Eigen::VectorXd lumped_mass(const FlatMesh& mesh) {
  return load_vector(mesh, std::vector<double>(mesh.triangles.size(), 1));
}

Eigen::VectorXd load_vector(const FlatMesh& mesh, std::span<const double> density) {
  assert(density.size() == mesh.triangles.size());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.positions.size()));
  const std::vector<double> areas = triangle_areas(mesh);
  for (size_t t = 0; t < areas.size(); ++t)
    for (const int node : mesh.triangles[t]) load[node] += density[t] * areas[t] / 3;
  return load;
}

Eigen::VectorXd divergence_load(const FlatMesh& mesh, std::span<const Point2> field) {
  assert(field.size() == mesh.triangles.size());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.positions.size()));
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Point2 next = mesh.positions[mesh.triangles[t][next_place(k)]];
      const Point2 last = mesh.positions[mesh.triangles[t][last_place(k)]];
      load[mesh.triangles[t][k]] += 0.5 * cross(last - next, field[t]);
    }
  return load;
}

SparseMatrix galerkin_lower(const SparseMatrix& A, const SparseMatrix& T) {
  assert(A.rows() == T.rows());
  const Eigen::SparseMatrix<double, Eigen::RowMajor, int> T_by_rows = T;
  ColumnBuilder builder(static_cast<int>(T.cols()), static_cast<int>(T.cols()), A.nonZeros());
  for (int j = 0; j < T.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator node(T, j); node; ++node)
      for (SparseMatrix::InnerIterator a(A, node.index()); a; ++a)
        for (decltype(T_by_rows)::InnerIterator t(T_by_rows, a.index()); t; ++t)
          if (t.index() >= j)
            builder.add(static_cast<int>(t.index()), t.value() * a.value() * node.value());
    builder.finish_column();
  }
  return builder.take();
}

}  // namespace relievo
