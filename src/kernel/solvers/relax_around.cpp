#include "kernel/solvers/relax_around.h"

#include <algorithm>
#include <cstdint>

namespace relievo {
namespace {

/// Steps in the graph from the seeds within which unknowns are relaxed.
constexpr int rings = 4;
/// Sweeps in each direction: as many as look at so many entries of K, within bounds.
constexpr int affordable_entries = 400000;
constexpr int most_sweeps = 100;
constexpr int fewest_sweeps = 5;

/// The unknowns around the seeds, with their rows and columns of K, z and the gradient.
class Patch {
 public:
  Patch(const std::vector<int>& seeds, const BoundQp& problem, const SymmetricGraph& graph,
        const BoundQpSolution& at)
      : unknowns_(rows_around(graph, seeds, rings, problem.fixed)) {
    read_matrix(problem.K, graph);
    for (const int i : unknowns_) {
      bounded_.push_back(problem.bounded[i]);
      z_.push_back(at.z[i]);
      gradient_.push_back(at.mu[i]);
    }
    for (int p = 0; p < size(); ++p)
      if (bounded_[p] != 0 && z_[p] < 0) move_to(p, 0);
  }

  void sweep_in_both_directions() {
    for (int p = 0; p < size(); ++p) relax(p);
    for (int p = size() - 1; p >= 0; --p) relax(p);
  }

  int affordable_sweeps() const {
    const int entries = size() + static_cast<int>(entry_.size());
    return std::clamp(affordable_entries / std::max(1, 2 * entries), fewest_sweeps, most_sweeps);
  }

  /// Makes the bounds with z = 0 active, and no others of the patch.
  void write_active(std::vector<uint8_t>& active) const {
    for (int p = 0; p < size(); ++p)
      if (bounded_[p] != 0) active[unknowns_[p]] = z_[p] == 0;
  }

 private:
  int size() const { return static_cast<int>(unknowns_.size()); }

  void read_matrix(const SparseMatrix& K, const SymmetricGraph& graph) {
    std::vector<int> index(static_cast<size_t>(graph.size()), -1);
    for (int p = 0; p < size(); ++p) index[unknowns_[p]] = p;
    for (const int i : unknowns_) {
      diagonal_.push_back(K.valuePtr()[K.outerIndexPtr()[i]]);
      for (int e = graph.begin[i]; e < graph.begin[i + 1]; ++e) {
        if (index[graph.neighbour[e]] < 0) continue;
        neighbour_.push_back(index[graph.neighbour[e]]);
        entry_.push_back(K.valuePtr()[graph.source[e]]);
      }
      begin_.push_back(static_cast<int>(neighbour_.size()));
    }
  }

  void relax(int p) {
    const double lowest = z_[p] - gradient_[p] / diagonal_[p];
    move_to(p, bounded_[p] != 0 ? std::max(lowest, 0.0) : lowest);
  }

  void move_to(int p, double z) {
    const double step = z - z_[p];
    if (step == 0) return;
    z_[p] = z;
    gradient_[p] += step * diagonal_[p];
    for (int e = begin_[p]; e < begin_[p + 1]; ++e) gradient_[neighbour_[e]] += step * entry_[e];
  }

  std::vector<int> unknowns_;  ///< ascending
  std::vector<double> diagonal_;
  std::vector<int> begin_ = {0};  ///< of the neighbours of each unknown
  std::vector<int> neighbour_;    ///< index in the patch
  std::vector<double> entry_;     ///< of K, for each neighbour
  std::vector<uint8_t> bounded_;
  std::vector<double> z_;
  std::vector<double> gradient_;
};

}  // namespace

void relax_around(const std::vector<int>& seeds, const BoundQp& problem,
                  const SymmetricGraph& graph, BoundQpSolution& at) {
  Patch patch(seeds, problem, graph, at);
  for (int i = patch.affordable_sweeps(); i > 0; --i) patch.sweep_in_both_directions();
  patch.write_active(at.active);
}

}  // namespace relievo
