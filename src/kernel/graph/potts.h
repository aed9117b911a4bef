#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relievo {

/// Nodes that each take one of a few labels: sum of costs of the labels taken, plus the weights of
/// the edges whose ends differ (the Potts energy).
struct PottsProblem {
  struct Edge {
    int a = 0;
    int b = 0;
    int64_t weight = 0;  ///< >= 0
  };
  int label_count = 0;
  std::vector<int64_t> costs;  ///< [#nodes * label_count], node by node; CutGraph::forbidden bars
  std::vector<Edge> edges;

  int node_count() const { return static_cast<int>(costs.size()) / label_count; }
};

int64_t potts_energy(const PottsProblem& problem, const std::vector<int>& labels);

/// Labels, 0 ... label_count - 1, whose energy no change of any set of nodes to one common label
/// lowers: at most twice the least energy, and exactly it for two labels. Alpha-expansion by exact
/// minimum cuts (Boykov, Veksler, Zabih 2001). Precondition: every node has a label that is not
/// barred.
std::vector<int> minimize_potts(const PottsProblem& problem);

}  // namespace relievo
