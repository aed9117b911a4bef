#include "relief/hiding/hide_sheets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/gradient.h"
#include "kernel/operators/laplacian.h"
#include "relief/hiding/overlap.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
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

}  // namespace

HiddenSheets hide_sheets(const HidingInput& input, std::optional<FlapSystem>& flaps,
                         const RunContext& context) {
  HiddenSheets sheets{input.inflation, input.ordering};
  if (!flaps) flaps.emplace(input.mesh, input.discretisation, context);
  if (context.cancelled()) {
    flaps.reset();
    return sheets;
  }
  flaps->fill(input, context, sheets);
  Lowering lowering(input, sheets);
  lowering.run();
  const std::vector<Point2> gradients =
      node_gradients(input.discretisation.gradients, sheets.ordering.g);
  for (size_t n = 0; n < gradients.size(); ++n)
    if (lowering.is_lowered(n)) sheets.ordering.grad_g[n] = gradients[n];
  flaps->set_slopes(sheets.ordering);
  return sheets;
}

FlapSystem::FlapSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                       const RunContext& context) {
  std::vector<int> place(mesh.node_vertex.size(), -1);  // in nodes_
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!mesh.is_flap(f)) continue;
    flaps_.push_back(static_cast<int>(f));
    faces_.push_back(mesh.faces[f]);
    for (const int n : mesh.faces[f])
      if (discretisation.mass[n] == 0) place[n] = 0;
  }
  if (faces_.empty()) return;
  for (size_t n = 0; n < place.size(); ++n) {
    if (place[n] < 0) continue;
    place[n] = static_cast<int>(nodes_.size());
    nodes_.push_back(static_cast<int>(n));
  }
  positions_ = node_positions(mesh);
  const FlatMesh flat{positions_, faces_};
  gradients_ = gradient_stencils(flat);
  const double scale = discretisation.scale;
  L_ = stiffness_matrix(flat);
  L_.diagonal() += weakest * scale * scale * lumped_mass(flat);
  std::vector<Eigen::Triplet<double>> entries;
  for (const int j : nodes_)
    for (SparseMatrix::InnerIterator entry(L_, j); entry; ++entry)
      if (const int row = place[entry.row()]; row >= place[j])
        entries.emplace_back(row, place[j], entry.value());
  K_ = SparseMatrix(static_cast<Index>(nodes_.size()), static_cast<Index>(nodes_.size()));
  K_.setFromTriplets(entries.begin(), entries.end());
  std::vector<int> order;
  for (const int n : discretisation.elimination)
    if (place[n] >= 0) order.push_back(place[n]);
  factor_.analyse(K_, Refactorisation::complete, order, context);
}

void FlapSystem::fill(const HidingInput& input, const RunContext& context, HiddenSheets& sheets) {
  if (nodes_.empty()) return;
  std::vector<double> density;
  for (const int f : flaps_) {
    const Part& part = input.scene.parts[input.mesh.source(f)];
    density.push_back(part.c * part.d * std::abs(part.d));
  }
  const VectorXd load = load_vector({positions_, faces_}, density);
  std::vector<uint8_t> outline;
  for (const int n : nodes_) outline.push_back(input.mesh.node_role[n] == NodeRole::outline);
  const std::vector<uint8_t> none(outline.size(), 0);
  auto& [u, grad_u] = sheets.inflation;
  if (!solve(load, outline, context, u)) return;
  if (!solve(VectorXd::Zero(load.size()), none, context, sheets.ordering.g)) return;
  const std::vector<Point2> gradients = node_gradients(gradients_, u);
  for (const int n : nodes_) grad_u[n] = gradients[n];
  for (const int n : nodes_) sheets.ordering.h[n] = sheets.ordering.g[n] + signed_root(u[n]);
}

/// Solves for the values inside, 0 where fixed, and puts them into `values`.
bool FlapSystem::solve(const VectorXd& load, const std::vector<uint8_t>& fixed,
                       const RunContext& context, std::vector<double>& values) {
  VectorXd known = VectorXd::Map(values.data(), static_cast<Index>(values.size()));
  for (const int n : nodes_) known[n] = 0;
  const VectorXd pull = load - L_ * known;
  VectorXd b(K_.rows());
  for (Index i = 0; i < b.size(); ++i) b[i] = fixed[i] != 0 ? 0 : pull[nodes_[i]];
  if (!factor_.factorise(K_, fixed, context)) return false;
  const VectorXd x = factor_.solve(b);
  for (Index i = 0; i < b.size(); ++i) values[nodes_[i]] = x[i];
  return true;
}

void FlapSystem::set_slopes(Ordering& ordering) const {
  if (nodes_.empty()) return;
  const std::vector<Point2> gradients = node_gradients(gradients_, ordering.g);
  for (const int n : nodes_) ordering.grad_g[n] = gradients[n];
}

}  // namespace relievo::relief
