#include "kernel/solvers/local_relaxation.h"

#include <algorithm>

namespace relievo {
namespace {

/// How far from the seeds unknowns may move.
constexpr int rings = 4;
/// In each direction, as long as they look at no more than so many entries of K; at least some.
constexpr int most_sweeps = 100;
constexpr int fewest_sweeps = 5;
constexpr int affordable_entries = 400000;

/// Unknowns with the rows and columns of K that are theirs.
struct Patch {
  std::vector<int> unknowns;  ///< ascending
  std::vector<int> begin;     ///< of each one's neighbours, one more at the end
  std::vector<int> neighbour;
  std::vector<double> entry;  ///< of K, for each neighbour
  std::vector<double> diagonal;
};

Patch patch_around(const std::vector<int>& seeds, const BoundQpPoint& point) {
  const SparseMatrix& K = point.K;
  const SymmetricGraph& graph = point.graph;
  Patch patch;
  patch.unknowns = rows_around(graph, seeds, rings, point.fixed);
  std::vector<int> place(static_cast<size_t>(graph.size()), -1);
  for (size_t p = 0; p < patch.unknowns.size(); ++p) place[patch.unknowns[p]] = static_cast<int>(p);
  patch.begin = {0};
  for (const int i : patch.unknowns) {
    patch.diagonal.push_back(K.valuePtr()[K.outerIndexPtr()[i]]);
    for (int p = graph.begin[i]; p < graph.begin[i + 1]; ++p) {
      if (place[graph.neighbour[p]] < 0) continue;
      patch.neighbour.push_back(place[graph.neighbour[p]]);
      patch.entry.push_back(K.valuePtr()[graph.source[p]]);
    }
    patch.begin.push_back(static_cast<int>(patch.neighbour.size()));
  }
  return patch;
}

/// z and the gradient on a patch.
class Relaxation {
 public:
  Relaxation(const Patch& patch, const BoundQpPoint& point) : patch_(patch) {
    for (const int i : patch.unknowns) {
      bounded_.push_back(point.bounded[i]);
      z_.push_back(point.z[i]);
      gradient_.push_back(point.gradient[i]);
    }
    for (int p = 0; p < size(); ++p)
      if (bounded_[p] != 0 && z_[p] < 0) move_to(p, 0);
  }

  void sweep_to_and_fro() {
    for (int p = 0; p < size(); ++p) relax(p);
    for (int p = size() - 1; p >= 0; --p) relax(p);
  }

  int affordable_sweeps() const {
    const int entries = size() + static_cast<int>(patch_.entry.size());
    return std::clamp(affordable_entries / std::max(1, 2 * entries), fewest_sweeps, most_sweeps);
  }

  ActiveGuess guess() const {
    ActiveGuess guess;
    for (int p = 0; p < size(); ++p) {
      if (bounded_[p] == 0) continue;
      guess.unknowns.push_back(patch_.unknowns[p]);
      guess.active.push_back(z_[p] == 0);
    }
    return guess;
  }

 private:
  int size() const { return static_cast<int>(z_.size()); }

  void relax(int p) {
    const double lowest = z_[p] - gradient_[p] / patch_.diagonal[p];
    move_to(p, bounded_[p] != 0 ? std::max(lowest, 0.0) : lowest);
  }

  void move_to(int p, double z) {
    const double step = z - z_[p];
    if (step == 0) return;
    z_[p] = z;
    gradient_[p] += step * patch_.diagonal[p];
    for (int e = patch_.begin[p]; e < patch_.begin[p + 1]; ++e)
      gradient_[patch_.neighbour[e]] += step * patch_.entry[e];
  }

  const Patch& patch_;
  std::vector<uint8_t> bounded_;
  std::vector<double> z_;
  std::vector<double> gradient_;
};

}  // namespace

ActiveGuess relax_around(const std::vector<int>& seeds, const BoundQpPoint& point) {
  const Patch patch = patch_around(seeds, point);
  Relaxation relaxation(patch, point);
  for (int i = relaxation.affordable_sweeps(); i > 0; --i) relaxation.sweep_to_and_fro();
  return relaxation.guess();
}

}  // namespace relievo
