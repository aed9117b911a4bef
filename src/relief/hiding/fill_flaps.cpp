#include "relief/hiding/fill_flaps.h"

#include <cmath>

#include "kernel/base/sparse_matrix.h"
#include "kernel/operators/laplacian.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/layers/joined_surface.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Pull to 0, in scene units: for flaps that hang on nothing.
constexpr double weakest = 1e-4;

/// The flaps' matrix: nodes inside are unknown, the others have values.
class FlapSystem {
 public:
  FlapSystem(const Flaps& flaps, const Discretisation& discretisation, const RunContext& context)
      : flaps_(flaps) {
    const double scale = discretisation.scale;
    const FlatMesh flat{flaps.positions, flaps.faces};
    L_ = stiffness_matrix(flat);
    L_.diagonal() += weakest * scale * scale * lumped_mass(flat);
    const auto size = static_cast<Index>(flaps.nodes.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (const int j : flaps.nodes)
      for (SparseMatrix::InnerIterator entry(L_, j); entry; ++entry) {
        const int row = flaps.place[entry.row()];
        if (row >= flaps.place[j]) entries.emplace_back(row, flaps.place[j], entry.value());
      }
    K_ = SparseMatrix(size, size);
    K_.setFromTriplets(entries.begin(), entries.end());
    std::vector<int> order;
    for (const int n : discretisation.elimination)
      if (flaps.place[n] >= 0) order.push_back(flaps.place[n]);
    analysed_ = factor_.analyse(K_, Refactorisation::complete, order, context);
  }

  /// Solves for the values inside, 0 where fixed, and puts them into `values`.
  bool solve(const VectorXd& load, const std::vector<uint8_t>& fixed, const RunContext& context,
             std::vector<double>& values) {
    VectorXd known = VectorXd::Map(values.data(), static_cast<Index>(values.size()));
    for (const int n : flaps_.nodes) known[n] = 0;
    const VectorXd pull = load - L_ * known;
    VectorXd b(K_.rows());
    for (Index i = 0; i < b.size(); ++i) b[i] = fixed[i] != 0 ? 0 : pull[flaps_.nodes[i]];
    if (!analysed_ || !factor_.factorise(K_, fixed, context)) return false;
    const VectorXd x = factor_.solve(b);
    for (Index i = 0; i < b.size(); ++i) values[flaps_.nodes[i]] = x[i];
    return true;
  }

 private:
  const Flaps& flaps_;
  SparseMatrix L_;
  SparseMatrix K_;
  SparseCholesky factor_;
  bool analysed_ = false;
};

}  // namespace

Flaps collect_flaps(const HidingInput& input) {
  const LayeredMesh& mesh = input.mesh;
  Flaps flaps;
  flaps.place.assign(mesh.node_vertex.size(), -1);
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!mesh.is_flap(f)) continue;
    const Part& part = input.scene.parts[mesh.source(f)];
    flaps.faces.push_back(mesh.faces[f]);
    flaps.density.push_back(part.c * part.d * std::abs(part.d));
    for (const int n : mesh.faces[f])
      if (input.discretisation.mass[n] == 0) flaps.place[n] = 0;
  }
  if (flaps.faces.empty()) return flaps;
  for (size_t n = 0; n < flaps.place.size(); ++n) {
    if (flaps.place[n] < 0) continue;
    flaps.place[n] = static_cast<int>(flaps.nodes.size());
    flaps.nodes.push_back(static_cast<int>(n));
  }
  flaps.positions = node_positions(mesh);
  flaps.gradients = gradient_stencils({flaps.positions, flaps.faces});
  return flaps;
}

void fill_flaps(const HidingInput& input, const Flaps& flaps, HiddenSheets& sheets,
                const RunContext& context) {
  if (flaps.nodes.empty()) return;
  FlapSystem system(flaps, input.discretisation, context);
  const FlatMesh flat{flaps.positions, flaps.faces};
  const VectorXd load = load_vector(flat, flaps.density);
  std::vector<uint8_t> outline;
  for (const int n : flaps.nodes) outline.push_back(input.mesh.node_role[n] == NodeRole::outline);
  const std::vector<uint8_t> none(outline.size(), 0);
  auto& [u, grad_u] = sheets.inflation;
  if (!system.solve(load, outline, context, u)) return;
  if (!system.solve(VectorXd::Zero(load.size()), none, context, sheets.ordering.g)) return;
  const std::vector<Point2> gradients = node_gradients(flaps.gradients, u);
  for (const int n : flaps.nodes) grad_u[n] = gradients[n];
  for (const int n : flaps.nodes) sheets.ordering.h[n] = sheets.ordering.g[n] + signed_root(u[n]);
}

}  // namespace relievo
