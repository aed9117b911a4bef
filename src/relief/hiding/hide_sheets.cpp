#include "relief/hiding/hide_sheets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/operators/gradient.h"
#include "kernel/operators/laplacian.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/hiding/overlap.h"
#include "relief/layers/layered_mesh.h"

namespace relievo {
namespace {

/// What is hidden stays so far behind, in scene units.
constexpr double margin = 4e-4;
/// What is missing of that counts as round-off below this share.
constexpr double settled = 1e-6;
/// A seen node so many margins in front of a hidden one above it is not due to the mesh.
constexpr double tear = 10;
/// A face that comes out by less than this share of a margin may as well stay.
constexpr double slight = 0.25;
/// Rounds of lowering nodes and then faces: what is lowered may come to lie below the next sheet.
constexpr int rounds = 10;

/// Lowers hidden nodes under those in front of them.
class Lowering {
 public:
  Lowering(const HidingInput& input, HiddenSheets& sheets)
      : mesh_(input.mesh),
        scene_(input.scene),
        sheets_(sheets),
        seen_(seen_nodes(input.mesh)),
        pairs_(stacked_faces(input.mesh, input.scene)),
        margin_(margin / input.discretisation.scale),
        lowered_(mesh_.node_vertex.size(), 0) {
    sheets.ordering.lowered.assign(mesh_.node_vertex.size(), 0);
  }

  void run() {
    for (int round = 1; round <= rounds; ++round) {
      lower_nodes(round);
      lower_faces(round);
    }
    measure();
    find_crossing();
  }

  bool is_lowered(size_t node) const { return lowered_[node] > 0; }

 private:
  void lower(int node, double by, int round) {
    sheets_.ordering.h[node] -= by;
    sheets_.ordering.g[node] -= by;
    sheets_.ordering.lowered[node] += by;
    lowered_[node] = round;
  }

  /// Whether a node of the faces has moved since the last round, or there was none.
  bool is_due(const FacePair& pair, int round) const {
    const auto moved = [&](int node) { return lowered_[node] >= round - 1; };
    return std::any_of(mesh_.faces[pair.lower].begin(), mesh_.faces[pair.lower].end(), moved) ||
           std::any_of(mesh_.faces[pair.upper].begin(), mesh_.faces[pair.upper].end(), moved);
  }

  void lower_nodes(int round) {
    const std::vector<double>& h = sheets_.ordering.h;
    for (const FacePair& pair : pairs_) {
      if (!is_due(pair, round)) continue;
      for (int k = 0; k < 3; ++k) {
        const int node = mesh_.faces[pair.lower][k];
        const int cap = mesh_.faces[pair.upper][k];
        const double excess = h[node] - h[cap] + margin_;
        if (seen_[node] == 0 && node != cap && excess > settled * margin_)
          lower(node, excess, round);
      }
    }
  }

  /// Whether a node that is seen lies in front of the sheet above, which a third one hides there:
  /// no place of the other nodes mends that, and they would be drawn out to spikes.
  bool is_torn(const FacePair& pair) const {
    for (int k = 0; k < 3; ++k) {
      const int node = mesh_.faces[pair.lower][k];
      const int cap = mesh_.faces[pair.upper][k];
      if (seen_[node] != 0 && seen_[cap] == 0 &&
          sheets_.ordering.h[node] > sheets_.ordering.h[cap] + tear * margin_)
        return true;
    }
    return false;
  }

  /// The pair, or the lower face with the next above from which it is not torn, which hides both.
  FacePair whole(FacePair pair) const {
    const int end = mesh_.stack_begin[mesh_.face_triangle[pair.lower] + 1];
    for (int upper = pair.upper; upper < end; ++upper)
      if (!is_torn({pair.lower, upper})) return {pair.lower, upper};
    return pair;
  }

  void lower_faces(int round) {
    for (const FacePair& stacked : pairs_) {
      if (!is_due(stacked, round)) continue;
      const FacePair pair = whole(stacked);
      const Dip dip = worst_dip(mesh_, pair, sheets_.inflation, sheets_.ordering);
      const double excess = dip.depth + margin_;
      if (excess <= settled * margin_) continue;
      const std::array<int, 3>& nodes = mesh_.faces[pair.lower];
      double share = 0;  // of the movable nodes in the height there
      for (int k = 0; k < 3; ++k) share += seen_[nodes[k]] == 0 ? dip.weight[k] : 0;
      for (const int node : nodes)
        if (seen_[node] == 0) lower(node, excess / share, round);
    }
  }

  void measure() {
    for (const FacePair& pair : pairs_) {
      const double dip = worst_dip(mesh_, pair, sheets_.inflation, sheets_.ordering).depth;
      if (dip <= 0.01 * margin_) continue;
      ++sheets_.overlap_samples;
      sheets_.overlap_worst = std::max(sheets_.overlap_worst, dip);
    }
  }

  /// Faces at seen nodes: what falls away from an outline there is as steep as a root, and cuts any
  /// face that hangs on the outline too; slivers between two outlines have no other nodes.
  void find_crossing() {
    sheets_.ordering.crossing.clear();
    for (const FacePair& pair : covered_faces(mesh_, scene_)) {
      const std::array<int, 3>& nodes = mesh_.faces[pair.lower];
      if (std::none_of(nodes.begin(), nodes.end(), [this](int n) { return seen_[n] != 0; }))
        continue;
      const double dip = std::max(worst_dip(mesh_, pair, sheets_.inflation, sheets_.ordering).depth,
                                  rim_dip(mesh_, pair, sheets_.inflation, sheets_.ordering));
      if (dip > slight * margin_) sheets_.ordering.crossing.push_back(pair.lower);
    }
  }

  const LayeredMesh& mesh_;
  const Scene& scene_;
  HiddenSheets& sheets_;
  std::vector<uint8_t> seen_;
  std::vector<FacePair> pairs_;
  double margin_;             ///< px
  std::vector<int> lowered_;  ///< the last round in which the node was, or 0
};

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

HiddenSheets hide_sheets(const HidingInput& input, const RunContext& context) {
  HiddenSheets sheets{input.inflation, input.ordering};
  const Flaps flaps = collect_flaps(input);
  fill_flaps(input, flaps, sheets, context);
  Lowering lowering(input, sheets);
  lowering.run();
  const std::vector<double>& g = sheets.ordering.g;
  const std::vector<Point2> gradients = node_gradients(input.discretisation.gradients, g);
  for (size_t n = 0; n < gradients.size(); ++n)
    if (lowering.is_lowered(n)) sheets.ordering.grad_g[n] = gradients[n];
  if (flaps.nodes.empty()) return sheets;
  const std::vector<Point2> on_flaps = node_gradients(flaps.gradients, g);
  for (const int n : flaps.nodes) sheets.ordering.grad_g[n] = on_flaps[n];
  return sheets;
}

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
