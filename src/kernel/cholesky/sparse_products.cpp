#include "kernel/cholesky/sparse_products.h"

#include <algorithm>
#include <array>

#include "kernel/base/workers.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Blocks of columns of a product, as many with any number of workers, so that sums have the same
/// bits.
constexpr int blocks = 4;
/// Entries below which threads do not pay.
constexpr Index fewest_entries = 50000;

/// Computes the contribution of the entries in the columns [first, end), and of their mirror images
/// across the diagonal, to the rows from `first` on.
VectorXd product_of_columns(const SparseMatrix& lower, int first, int end, const VectorXd& x) {
  const int* begin = lower.outerIndexPtr();
  const int* row = lower.innerIndexPtr();
  const double* entry = lower.valuePtr();
  VectorXd y = VectorXd::Zero(lower.rows() - first);
  for (int j = first; j < end; ++j) {
    double sum = 0;
    for (int e = begin[j]; e < begin[j + 1]; ++e) {
      sum += entry[e] * x[row[e]];
      if (row[e] != j) y[row[e] - first] += entry[e] * x[j];
    }
    y[j - first] += sum;
  }
  return y;
}

}  // namespace

VectorXd multiply_symmetric(const SparseMatrix& lower, const VectorXd& x) {
  const auto columns = static_cast<int>(lower.cols());
  if (lower.nonZeros() < fewest_entries) return product_of_columns(lower, 0, columns, x);
  const int* begin = lower.outerIndexPtr();
  const auto cut = [&](int block) {
    const Index before = lower.nonZeros() * block / blocks;
    return static_cast<int>(std::lower_bound(begin, begin + columns, before) - begin);
  };
  std::array<VectorXd, blocks> products;
  run_tasks(blocks, [&](int block) {
    products[block] = product_of_columns(lower, cut(block), cut(block + 1), x);
  });
  for (int block = 1; block < blocks; ++block)
    products[0].tail(products[block].size()) += products[block];
  return products[0];
}

double multiply_row(const SparseMatrix& lower, const SymmetricGraph& graph, int i,
                    const VectorXd& x) {
  double sum = lower.valuePtr()[lower.outerIndexPtr()[i]] * x[i];
  for (int p = graph.begin[i]; p < graph.begin[i + 1]; ++p)
    sum += lower.valuePtr()[graph.source[p]] * x[graph.neighbour[p]];
  return sum;
}

VectorXd multiply_transposed(const SparseMatrix& A, const VectorXd& x) {
  VectorXd product(A.cols());
  run_ranges(static_cast<int>(A.cols()), [&](int first, int last) {
    for (int j = first; j < last; ++j) product[j] = A.col(j).dot(x);
  });
  return product;
}

}  // namespace relievo
