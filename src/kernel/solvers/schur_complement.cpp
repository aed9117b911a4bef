#include "kernel/solvers/schur_complement.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <vector>

#include "kernel/solvers/symmetric_graph.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The lower triangle of S += x x'.
void add_outer_product(const VectorXd& x, MatrixXd& S) {
  for (Index j = 0; j < x.size(); ++j) {
    const double factor = x[j];
    if (factor == 0) continue;
    double* column = S.col(j).data();
    for (Index i = j; i < x.size(); ++i) column[i] += factor * x[i];
  }
}

/// One per column of the factor: its place among those of `rows`, by elimination, or -1.
std::vector<int> places_of(const FactorMemory& factor, std::span<const int> rows) {
  const std::vector<int>& order = factor.layout.fronts.order;
  std::vector<uint8_t> wanted(order.size(), 0);
  for (const int row : rows) wanted[row] = 1;
  std::vector<int> places(order.size(), -1);
  int next = 0;
  for (size_t c = 0; c < order.size(); ++c)
    if (wanted[order[c]] != 0) places[c] = next++;
  return places;
}

/// L L' of the wanted rows and columns of the factor L, by elimination.
MatrixXd product_of(const FactorMemory& factor, const std::vector<int>& places, Index size) {
  const Supernodes& fronts = factor.layout.fronts;
  MatrixXd S = MatrixXd::Zero(size, size);
  VectorXd column(size);
  for (int s = 0; s < fronts.size(); ++s) {
    const Front front = factor.front(s);
    const int* row = factor.rows(s);
    for (int c = 0; c < front.columns; ++c) {
      if (places[row[c]] < 0) continue;
      column.setZero();
      for (int i = c; i < front.rows; ++i) {
        assert(places[row[i]] >= 0 || front.column(c)[i] == 0);
        if (places[row[i]] >= 0) column[places[row[i]]] = front.column(c)[i];
      }
      add_outer_product(column, S);
    }
  }
  return S;
}

}  // namespace

MatrixXd schur_complement(const FactorMemory& factor, std::span<const int> rows) {
  const std::vector<int> places = places_of(factor, rows);
  const auto size = static_cast<Index>(rows.size());
  const MatrixXd S = product_of(factor, places, size);
  const std::vector<int> position = positions_in(factor.layout.fronts.order);
  MatrixXd result(size, size);
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i) {
      const auto [low, high] = std::minmax(places[position[rows[i]]], places[position[rows[j]]]);
      result(i, j) = S(high, low);
    }
  return result;
}

}  // namespace relievo
