#include "relief/hiding/hide_sheets.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "kernel/operators/gradient.h"
#include "relief/hiding/fill_flaps.h"
#include "relief/hiding/overlap.h"
#include "relief/layers/joined_surface.h"

namespace relievo {
namespace {

/// What is hidden stays so far behind, in scene units.
constexpr double margin = 4e-4;
/// What is missing of that counts as round-off below this share.
constexpr double settled = 1e-6;
/// Rounds of lowering nodes and then faces: what is lowered may come to lie below the next sheet.
constexpr int rounds = 6;

/// Lowers hidden nodes under those in front of them.
class Lowering {
 public:
  Lowering(const HidingInput& input, HiddenSheets& sheets)
      : mesh_(input.mesh),
        sheets_(sheets),
        seen_(seen_nodes(input.mesh)),
        pairs_(stacked_faces(input.mesh, input.scene)),
        margin_(margin / input.discretisation.scale),
        lowered_(mesh_.node_vertex.size(), 0) {}

  /// Whether anything was lowered.
  bool run() {
    bool any = false;
    for (int round = 0; round < rounds; ++round) {
      const bool nodes = lower_nodes();
      const bool faces = lower_faces();
      if (!nodes && !faces) break;
      any = true;
    }
    measure();
    return any;
  }

  bool is_lowered(size_t node) const { return lowered_[node] != 0; }

 private:
  void lower(int node, double by) {
    sheets_.ordering.h[node] -= by;
    sheets_.ordering.g[node] -= by;
    lowered_[node] = 1;
  }

  bool lower_nodes() {
    bool any = false;
    const std::vector<double>& h = sheets_.ordering.h;
    for (const FacePair& pair : pairs_)
      for (int k = 0; k < 3; ++k) {
        const int node = mesh_.faces[pair.lower][k];
        const int cap = mesh_.faces[pair.upper][k];
        const double excess = h[node] - h[cap] + margin_;
        if (seen_[node] != 0 || node == cap || excess <= settled * margin_) continue;
        lower(node, excess);
        any = true;
      }
    return any;
  }

  bool lower_faces() {
    bool any = false;
    for (const FacePair& pair : pairs_) {
      const Dip dip = worst_dip(mesh_, pair, sheets_.inflation, sheets_.ordering);
      const double excess = dip.depth + margin_;
      if (excess <= settled * margin_) continue;
      const std::array<int, 3>& nodes = mesh_.faces[pair.lower];
      double share = 0;  // of the movable nodes in the height there
      for (int k = 0; k < 3; ++k) share += seen_[nodes[k]] == 0 ? dip.weight[k] : 0;
      for (const int node : nodes) {
        if (seen_[node] != 0) continue;
        lower(node, excess / share);
        any = true;
      }
    }
    return any;
  }

  void measure() {
    for (const FacePair& pair : pairs_) {
      const double dip = worst_dip(mesh_, pair, sheets_.inflation, sheets_.ordering).depth;
      if (dip <= 0.01 * margin_) continue;
      ++sheets_.overlap_samples;
      sheets_.overlap_worst = std::max(sheets_.overlap_worst, dip);
    }
  }

  const LayeredMesh& mesh_;
  HiddenSheets& sheets_;
  std::vector<uint8_t> seen_;
  std::vector<FacePair> pairs_;
  double margin_;  ///< px
  std::vector<uint8_t> lowered_;
};

}  // namespace

HiddenSheets hide_sheets(const HidingInput& input, const RunContext& context) {
  HiddenSheets sheets{input.inflation, input.ordering};
  fill_flaps(input, sheets, context);
  Lowering lowering(input, sheets);
  if (!lowering.run()) return sheets;
  const std::vector<Point2> gradients =
      node_gradients({node_positions(input.mesh), input.mesh.faces}, sheets.ordering.g);
  for (size_t n = 0; n < gradients.size(); ++n)
    if (lowering.is_lowered(n)) sheets.ordering.grad_g[n] = gradients[n];
  return sheets;
}

}  // namespace relievo
