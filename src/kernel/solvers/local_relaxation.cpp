#include "kernel/solvers/local_relaxation.h"

#include <algorithm>

namespace relievo {
namespace {

/// How far from the seeds unknowns may move.
constexpr int rings = 4;
/// In each direction.
constexpr int sweeps = 5;

/// Unknowns with the rows and columns of K that are theirs.
struct Patch {
  std::vector<int> unknowns;  ///< ascending
  std::vector<int> begin;     ///< of each one's neighbours, one more at the end
  std::vector<int> neighbour;
  std::vector<double> entry;  ///< of K, for each neighbour
  std::vector<double> diagonal;
};

/// Flags everything that shares an entry with what is flagged.
void add_ring(const SparseMatrix& K, std::vector<uint8_t>& flags) {
  const std::vector<uint8_t> inner = flags;
  for (int j = 0; j < K.outerSize(); ++j)
    for (SparseMatrix::InnerIterator e(K, j); e; ++e) {
      const auto i = static_cast<size_t>(e.row());
      if (inner[j] != 0) flags[i] = 1;
      if (inner[i] != 0) flags[j] = 1;
    }
}

/// Calls visit(i, j, value) for the entries below the diagonal, numbered within the patch.
template <class Visit>
void for_each_entry(const SparseMatrix& K, const std::vector<int>& unknowns,
                    const std::vector<int>& place, const Visit& visit) {
  for (size_t p = 0; p < unknowns.size(); ++p)
    for (SparseMatrix::InnerIterator e(K, unknowns[p]); e; ++e)
      if (place[e.row()] >= 0 && e.row() != unknowns[p])
        visit(place[e.row()], static_cast<int>(p), e.value());
}

Patch patch_around(const std::vector<int>& seeds, const SparseMatrix& K) {
  std::vector<uint8_t> flags(static_cast<size_t>(K.rows()), 0);
  for (const int i : seeds) flags[i] = 1;
  for (int ring = 0; ring < rings; ++ring) add_ring(K, flags);
  Patch patch;
  std::vector<int> place(flags.size(), -1);
  for (size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] == 0) continue;
    place[i] = static_cast<int>(patch.unknowns.size());
    patch.unknowns.push_back(static_cast<int>(i));
    patch.diagonal.push_back(K.valuePtr()[K.outerIndexPtr()[i]]);
  }
  patch.begin.assign(patch.unknowns.size() + 1, 0);
  for_each_entry(K, patch.unknowns, place, [&](int i, int j, double) {
    ++patch.begin[i + 1];
    ++patch.begin[j + 1];
  });
  for (size_t p = 0; p + 1 < patch.begin.size(); ++p) patch.begin[p + 1] += patch.begin[p];
  patch.neighbour.resize(static_cast<size_t>(patch.begin.back()));
  patch.entry.resize(patch.neighbour.size());
  std::vector<int> next(patch.begin.begin(), patch.begin.end() - 1);
  for_each_entry(K, patch.unknowns, place, [&](int i, int j, double value) {
    patch.neighbour[next[i]] = j;
    patch.entry[next[i]++] = value;
    patch.neighbour[next[j]] = i;
    patch.entry[next[j]++] = value;
  });
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
  const Patch patch = patch_around(seeds, point.K);
  Relaxation relaxation(patch, point);
  for (int i = 0; i < sweeps; ++i) relaxation.sweep_to_and_fro();
  return relaxation.guess();
}

}  // namespace relievo
