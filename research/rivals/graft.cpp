#include "research/rivals/graft.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "kernel/cholesky/sparse_cholesky.h"
#include "relief/layers/layered_mesh.h"
#include "seams/seam_chains.h"

namespace relievo::research {
namespace {

using Eigen::VectorXd;

std::vector<std::vector<int>> node_neighbours(const relief::LayeredMesh& mesh) {
  std::vector<std::vector<int>> next(mesh.node_vertex.size());
  for (const auto& face : mesh.faces)
    for (int k = 0; k < 3; ++k) {
      next[face[k]].push_back(face[(k + 1) % 3]);
      next[face[k]].push_back(face[(k + 2) % 3]);
    }
  return next;
}

/// Flags the nodes within `reach` of the chain.
void flood(const relief::LayeredMesh& mesh, const std::vector<std::vector<int>>& next,
           const testing::SeamChain& chain, double reach, std::vector<uint8_t>& band) {
  using Front = std::tuple<double, int, int>;  // distance, node, source
  std::priority_queue<Front, std::vector<Front>, std::greater<>> queue;
  for (const int n : chain.nodes) queue.push({0, n, n});
  std::vector<uint8_t> done(next.size(), 0);
  const auto place = [&](int n) { return mesh.vertices[mesh.node_vertex[n]]; };
  while (!queue.empty()) {
    const auto [away, n, source] = queue.top();
    queue.pop();
    if (std::exchange(done[n], 1) != 0) continue;
    band[n] = 1;
    for (const int other : next[n]) {
      const double farther = distance(place(other), place(source));
      if (done[other] == 0 && farther <= reach) queue.push({farther, other, source});
    }
  }
}

/// Clears the flags within two edges of the rest of a bump's outline, where one node belongs to two
/// parts of different heights.
void keep_off_rims(const relief::LayeredMesh& mesh, const std::vector<std::vector<int>>& next,
                   std::vector<uint8_t>& band) {
  std::set<int> near = testing::loose_rims(mesh);
  for (int ring = 0; ring < 2; ++ring)
    for (const int n : std::vector<int>(near.begin(), near.end()))
      near.insert(next[n].begin(), next[n].end());
  for (const int n : near) band[n] = 0;
}

/// The rows and columns of A with place >= 0, both triangles.
SparseMatrix block(const SparseMatrix& A, const std::vector<int>& row_place, int rows,
                   const std::vector<int>& column_place, int columns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < A.outerSize(); ++j) {
    if (column_place[j] < 0) continue;
    for (SparseMatrix::InnerIterator it(A, j); it; ++it)
      if (row_place[it.row()] >= 0)
        entries.emplace_back(row_place[it.row()], column_place[j], it.value());
  }
  SparseMatrix result(rows, columns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

struct Numbering {
  std::vector<int> place;  ///< #N, -1 where a node has none
  int count = 0;
};

template <class Wanted>
Numbering number(size_t nodes, Wanted wanted) {
  Numbering result{std::vector<int>(nodes, -1), 0};
  for (size_t n = 0; n < nodes; ++n)
    if (wanted(n)) result.place[n] = result.count++;
  return result;
}

}  // namespace

std::vector<uint8_t> band_around_joins(const relief::LayeredMesh& mesh, double width) {
  std::vector<uint8_t> band(mesh.node_vertex.size(), 0);
  const std::vector<std::vector<int>> next = node_neighbours(mesh);
  for (const testing::SeamChain& chain : testing::seam_chains(mesh))
    flood(mesh, next, chain, width * chain.length.back(), band);
  keep_off_rims(mesh, next, band);
  return band;
}

Result<Graft> graft(const relief::LayeredMesh& mesh, const relief::Discretisation& discretisation,
                    const std::vector<double>& h, const std::vector<uint8_t>& grafted,
                    const RunContext& context) {
  Graft result{h, 0};
  const auto inside = [&](size_t n) {
    return relief::is_inside(mesh.node_role[n]) &&
           discretisation.mass[static_cast<Eigen::Index>(n)] > 0;
  };
  // Only the inside has bending energy: outlines are fixed, but their slopes are free.
  const Numbering rows = number(h.size(), inside);
  const Numbering free = number(h.size(), [&](size_t n) { return grafted[n] != 0 && inside(n); });
  const Numbering held = number(h.size(), [&](size_t n) { return free.place[n] < 0; });
  if (free.count == 0) return result;
  const SparseMatrix& L = discretisation.L;
  const SparseMatrix L_free = block(L, rows.place, rows.count, free.place, free.count);
  const SparseMatrix L_held = block(L, rows.place, rows.count, held.place, held.count);
  VectorXd lightness(rows.count);
  VectorXd h_held(held.count);
  for (size_t n = 0; n < h.size(); ++n) {
    const auto i = static_cast<Eigen::Index>(n);
    if (rows.place[n] >= 0) lightness[rows.place[n]] = 1 / discretisation.mass[i];
    if (held.place[n] >= 0) h_held[held.place[n]] = h[n];
  }
  const VectorXd bending = lightness.cwiseProduct(L_held * h_held);
  SparseMatrix K = SparseMatrix(L_free.transpose()) * lightness.asDiagonal() * L_free;
  K.makeCompressed();
  const VectorXd load = -(L_free.transpose() * bending);
  SparseCholesky factor;
  const bool solved =
      factor.analyse(K, Refactorisation::complete, {}, context) && factor.factorise(K, {}, context);
  if (context.cancelled()) return interrupted_error();
  if (!solved) return Error{ErrorCode::internal, "the graft has no finite solution", ""};
  VectorXd x = factor.solve(load);
  x += factor.solve(load - K * x);
  const VectorXd rest = K * x - load;
  const VectorXd scale = K.cwiseAbs() * x.cwiseAbs() + load.cwiseAbs();
  for (Eigen::Index i = 0; i < rest.size(); ++i)
    result.residual = std::max(result.residual, std::abs(rest[i]) / std::max(scale[i], 1e-300));
  for (size_t n = 0; n < h.size(); ++n)
    if (free.place[n] >= 0) result.h[n] = x[free.place[n]];
  return result;
}

}  // namespace relievo::research
