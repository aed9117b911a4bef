#include "kernel/cholesky/symmetric_graph.h"

#include <algorithm>
#include <array>

#include "kernel/base/workers.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Of columns, as many with any number of workers, so that sums are the same.
constexpr int blocks = 4;
/// Fewer entries are not worth a thread.
constexpr Index fewest_entries = 50000;

/// What the entries of columns [first, end) and those across the diagonal from them contribute to
/// the rows from `first` on.
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

SymmetricGraph make_symmetric_graph(const SparseMatrix& lower) {
  SymmetricGraph graph;
  graph.begin.assign(static_cast<size_t>(lower.rows()) + 1, 0);
  for (int j = 0; j < lower.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry)
      if (entry.row() > j) {
        ++graph.begin[entry.row() + 1];
        ++graph.begin[j + 1];
      }
  for (Eigen::Index i = 0; i < lower.rows(); ++i) graph.begin[i + 1] += graph.begin[i];
  graph.neighbour.resize(static_cast<size_t>(graph.begin.back()));
  graph.source.resize(graph.neighbour.size());
  std::vector<int> next(graph.begin.begin(), graph.begin.end() - 1);
  const auto link = [&](int from, int to, int source) {
    graph.neighbour[next[from]] = to;
    graph.source[next[from]++] = source;
  };
  for (int j = 0; j < lower.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      const int i = static_cast<int>(entry.row());
      const int source = static_cast<int>(&entry.value() - lower.valuePtr());
      if (i <= j) continue;
      link(i, j, source);
      link(j, i, source);
    }
  return graph;
}

std::vector<int> rows_around(const SymmetricGraph& graph, std::span<const int> seeds, int steps,
                             std::span<const uint8_t> left_out) {
  std::vector<uint8_t> passed(left_out.begin(), left_out.end());
  passed.resize(static_cast<size_t>(graph.size()), 0);
  std::vector<int> rows;
  const auto add = [&](int i) {
    if (passed[i] != 0) return;
    rows.push_back(i);
    passed[i] = 1;
  };
  for (const int i : seeds) add(i);
  size_t first = 0;
  for (int step = 0; step < steps && first < rows.size(); ++step) {
    const size_t last = rows.size();
    for (; first < last; ++first)
      for (int p = graph.begin[rows[first]]; p < graph.begin[rows[first] + 1]; ++p)
        add(graph.neighbour[p]);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<int> positions_in(const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (size_t i = 0; i < order.size(); ++i) position[order[i]] = static_cast<int>(i);
  return position;
}

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
