#include "relief/joint/bound_stiffness.h"

#include <cstddef>

#include "kernel/base/sparse_matrix.h"
#include "kernel/geometry/nearest_mark.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A mark with where it was in its list.
struct IndexedMark {
  int part = -1;
  Point2 position;
  int index = 0;

  int group() const { return part; }
};

std::vector<IndexedMark> sorted_marks(const std::vector<BoundMark>& marks) {
  std::vector<IndexedMark> sorted;
  for (const BoundMark& mark : marks)
    sorted.push_back({mark.part, mark.position, static_cast<int>(sorted.size())});
  sort_marks(sorted);
  return sorted;
}

/// #marks x #known: interpolates along B; rows of marks in parts without known ones are empty.
SparseMatrix interpolation(const std::vector<BoundMark>& known,
                           const std::vector<BoundMark>& marks) {
  const std::vector<IndexedMark> sorted = sorted_marks(known);
  std::vector<Eigen::Triplet<double>> entries;
  for (size_t i = 0; i < marks.size(); ++i) {
    const IndexedMark place{marks[i].part, marks[i].position, 0};
    const auto beside = marks_beside(sorted, place, [](const IndexedMark&) { return true; });
    if (!beside) continue;
    const int row = static_cast<int>(i);
    entries.emplace_back(row, beside->near->index, 1 - beside->share);
    if (beside->share > 0) entries.emplace_back(row, beside->beyond->index, beside->share);
  }
  SparseMatrix P(static_cast<Index>(marks.size()), static_cast<Index>(known.size()));
  P.setFromTriplets(entries.begin(), entries.end());
  return P;
}

/// #known x #marks: means over the marks that interpolate from each known one; what they do not
/// cover of its length is interpolated between marks.
SparseMatrix averages(const SparseMatrix& P, const std::vector<BoundMark>& known,
                      const std::vector<BoundMark>& marks) {
  VectorXd covered = VectorXd::Zero(P.cols());
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](const SparseMatrix& shares, const auto& place) {
    for (Index j = 0; j < shares.outerSize(); ++j)
      for (SparseMatrix::InnerIterator entry(shares, j); entry; ++entry) place(entry);
  };
  add(P, [&](const auto& entry) {
    const double length = entry.value() * marks[static_cast<size_t>(entry.row())].length;
    entries.emplace_back(entry.col(), entry.row(), length);
    covered[entry.col()] += length;
  });
  VectorXd total = covered;
  add(interpolation(marks, known), [&](const auto& entry) {
    const Index j = entry.row();
    const double rest = known[static_cast<size_t>(j)].length - covered[j];
    if (rest <= 0) return;
    entries.emplace_back(entry.row(), entry.col(), entry.value() * rest);
    total[j] += entry.value() * rest;
  });
  for (Eigen::Triplet<double>& entry : entries)
    entry = {entry.row(), entry.col(), entry.value() / total[entry.row()]};
  SparseMatrix R(P.cols(), P.rows());
  R.setFromTriplets(entries.begin(), entries.end());
  return R;
}

}  // namespace

MatrixXd with_known_waves(const BoundStiffness& known, const std::vector<BoundMark>& marks,
                          const MatrixXd& near) {
  const SparseMatrix P = interpolation(known.marks, marks);
  const SparseMatrix R = averages(P, known.marks, marks);
  SparseMatrix short_waves(P.rows(), P.rows());
  short_waves.setIdentity();
  short_waves -= SparseMatrix(P * R);
  const MatrixXd K_R = known.K * R;
  const MatrixXd near_waves = near * short_waves;
  MatrixXd K = R.transpose() * K_R;
  K += short_waves.transpose() * near_waves;
  return 0.5 * (K + K.transpose());
}

}  // namespace relievo
