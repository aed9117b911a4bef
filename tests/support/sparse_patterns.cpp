#include "support/sparse_patterns.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace relievo::testing {
namespace {

/// Off-diagonal entries (row, column) of a graph's edges.
using Edges = std::map<std::pair<int, int>, double>;

/// A diagonally dominant matrix with the given entries below the diagonal.
SparseMatrix dominant(int n, const Edges& edges) {
  std::vector<double> diagonal(static_cast<size_t>(n), 0.5);
  std::vector<Eigen::Triplet<double>> triplets;
  for (const auto& [edge, value] : edges) {
    triplets.emplace_back(edge.first, edge.second, value);
    diagonal[edge.first] += std::abs(value);
    diagonal[edge.second] += std::abs(value);
  }
  for (int i = 0; i < n; ++i) triplets.emplace_back(i, i, diagonal[i]);
  SparseMatrix A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

Edges arrow(int n, int tip) {
  Edges edges;
  for (int i = 0; i < n; ++i)
    if (i != tip) edges[{std::max(i, tip), std::min(i, tip)}] = 0.25 * (i % 5) - 0.6;
  return edges;
}

Edges random_edges(int n, int count, uint32_t seed) {
  std::mt19937 random(seed);
  Edges edges;
  for (int k = 0; k < count; ++k) {
    const int i = static_cast<int>(random() % static_cast<uint32_t>(n));
    const int j = static_cast<int>(random() % static_cast<uint32_t>(n));
    const double value = static_cast<double>(random() % 2001) / 1000 - 1;
    if (i != j) edges[{std::max(i, j), std::min(i, j)}] = value;
  }
  return edges;
}

Edges complete(int begin, int end) {
  Edges edges;
  for (int j = begin; j < end; ++j)
    for (int i = j + 1; i < end; ++i) edges[{i, j}] = 0.1 * ((i * 7 + j * 3) % 11) - 0.45;
  return edges;
}

/// Cliques that share the node 0 only.
Edges star_of_cliques(int cliques, int size) {
  Edges edges;
  for (int c = 0; c < cliques; ++c) {
    const int begin = 1 + c * size;
    edges.merge(complete(begin, begin + size));
    for (int i = begin; i < begin + size; ++i) edges[{i, 0}] = 0.3;
  }
  return edges;
}

Edges unconnected_grids() {
  Edges edges;
  int offset = 0;
  for (const int side : {1, 7, 3, 12, 1, 5}) {
    for (int v = 0; v < side * side; ++v) {
      if (v % side > 0) edges[{offset + v, offset + v - 1}] = -1;
      if (v >= side) edges[{offset + v, offset + v - side}] = -0.7;
    }
    offset += side * side;
  }
  return edges;
}

}  // namespace

SparseMatrix grid_laplacian(int width, int height, double shift) {
  std::vector<Eigen::Triplet<double>> triplets;
  const int n = width * height;
  for (int v = 0; v < n; ++v) {
    triplets.emplace_back(v, v, 4 + shift);
    if (v % width > 0) triplets.emplace_back(v, v - 1, -1);
    if (v >= width) triplets.emplace_back(v, v - width, -1);
  }
  SparseMatrix A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

std::vector<NamedMatrix> telling_matrices() {
  Edges chain;
  for (int i = 1; i < 40; ++i) chain[{i, i - 1}] = -0.9;
  return {{"one entry", dominant(1, {})},
          {"diagonal", dominant(17, {})},
          {"tridiagonal", dominant(40, chain)},
          {"dense", dominant(150, complete(0, 150))},
          {"arrow to the first", dominant(60, arrow(60, 0))},
          {"arrow to the last", dominant(60, arrow(60, 59))},
          {"star of cliques", dominant(91, star_of_cliques(9, 10))},
          {"unconnected grids", dominant(229, unconnected_grids())},
          {"strip", grid_laplacian(100, 3, 0.1)},
          {"square grid", grid_laplacian(20, 20, 0.01)},
          {"random, thin", dominant(300, random_edges(300, 250, 1))},
          {"random, medium", dominant(300, random_edges(300, 900, 2))},
          {"random, thick", dominant(120, random_edges(120, 2500, 3))}};
}

Eigen::MatrixXd dense_symmetric(const SparseMatrix& lower) {
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

}  // namespace relievo::testing
