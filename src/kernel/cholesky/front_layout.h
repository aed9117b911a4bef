#pragma once

#include <sys/mman.h>

#include <Eigen/Core>
#include <memory>
#include <new>
#include <vector>

#include "kernel/cholesky/frontal_kernels.h"
#include "kernel/cholesky/supernodes.h"

#ifdef __linux__
#endif

namespace relievo {

/// Consecutive fronts [first, last), whole subtrees, that depend on no others.
struct FrontTask {
  int first = 0;
  int last = 0;
};

/// Independent pieces of a factorisation and the fronts that wait for all of them.
struct FrontTasks {
  std::vector<FrontTask> tasks;  ///< ascending
  std::vector<int> top;          ///< fronts in no task, ascending
  /// The same, each after those of its children that are among them: all of a level are
  /// independent.
  std::vector<std::vector<int>> top_levels;
  std::vector<int> top_place;  ///< #n: number of a top front's column among those, or -1
  int top_columns = 0;
};

/// An entry of the matrix and where it goes in the panel of its front.
struct PanelEntry {
  int source = -1;          ///< index into the values of the matrix
  Eigen::Index target = 0;  ///< index into the panel
};

enum class Updates {
  stacked,  ///< they make room for others once their parent has them
  kept,     ///< each has its place, so that single fronts can be computed again
};

/// Where everything lies during a factorisation, so that nothing is searched for. Every task has
/// two stacks for the updates of its fronts at even and at odd depth in the tree: those of the
/// children of a front are then the last ones of their stack, and its own goes on the other one.
/// Updates that leave a task, and those of the top fronts, have places of their own.
struct FrontLayout {
  Supernodes fronts;
  FrontTasks tasks;
  std::vector<int> front_of;               ///< #n: front that eliminates each row of the matrix
  std::vector<Eigen::Index> panel_begin;   ///< #S + 1, in doubles
  std::vector<Eigen::Index> update_begin;  ///< #S, in doubles
  Eigen::Index updates_size = 0;           ///< of all updates that live at once, in doubles
  std::vector<int> first_child;            ///< #S, -1 if there is none
  std::vector<int> next_sibling;           ///< #S, ascending, -1 at the last
  std::vector<int> row_in_parent;  ///< as long as fronts.row: position of the row in the parent
  std::vector<Eigen::Index> entry_begin;  ///< #S + 1
  std::vector<PanelEntry> entries;
  int most_rows = 0;  ///< of a front
};

/// Lays out the factorisation of matrices with the pattern of A, of which `graph` and of that the
/// fronts were made. Near-linear in the entries and the rows of the fronts.
FrontLayout lay_out(const SparseMatrix& A, const SymmetricGraph& graph, Supernodes fronts,
                    Updates updates);

/// Asks for huge pages where they fit, of which there are few to provide.
inline void prefer_huge_pages([[maybe_unused]] double* begin, [[maybe_unused]] size_t bytes) {
#ifdef __linux__
  constexpr size_t huge_page = size_t{1} << 21;
  void* first = begin;
  if (std::align(huge_page, huge_page, first, bytes) != nullptr)
    madvise(first, bytes, MADV_HUGEPAGE);
#endif
}

/// Doubles at the start of a cache line, where packs of rows are read fastest.
class AlignedArray {
 public:
  /// Makes room for `size` doubles, uninitialised; what was there before is lost.
  void make_room(Eigen::Index size) {
    if (data_ != nullptr && size <= capacity_) return;
    data_.reset();
    const size_t bytes = static_cast<size_t>(size) * sizeof(double);
    data_.reset(static_cast<double*>(::operator new(bytes, alignment)));
    prefer_huge_pages(data(), bytes);
    capacity_ = size;
  }
  double* data() const { return data_.get(); }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Free {
    void operator()(double* data) const { ::operator delete(data, alignment); }
  };
  std::unique_ptr<double, Free> data_;
  Eigen::Index capacity_ = 0;
};

/// The factor, laid out, and its numbers.
struct FactorMemory {
  FrontLayout layout;
  AlignedArray panels;
  AlignedArray updates;

  void make_room() {
    panels.make_room(layout.panel_begin.back());
    updates.make_room(layout.updates_size);
  }
  Front front(int s) const {
    const Supernodes& fronts = layout.fronts;
    return {fronts.rows(s), fronts.columns(s), panels.data() + layout.panel_begin[s],
            updates.data() + layout.update_begin[s]};
  }
  const int* rows(int s) const { return layout.fronts.row.data() + layout.fronts.row_begin[s]; }
};

}  // namespace relievo
