#include "kernel/cholesky/symmetric_graph.h"

#include <algorithm>

namespace relievo {
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

}  // namespace relievo
