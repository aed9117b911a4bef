#pragma once

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <new>

#include "kernel/cholesky/front_layout.h"
#include "kernel/cholesky/frontal_kernels.h"

namespace relievo {

/// Advises the system to use huge pages where they fit: with them it provides fewer pages.
inline void prefer_huge_pages([[maybe_unused]] double* begin, [[maybe_unused]] size_t bytes) {
#ifdef __linux__
  constexpr size_t huge_page = size_t{1} << 21;
  void* first = begin;
  if (std::align(huge_page, huge_page, first, bytes) != nullptr)
    madvise(first, bytes, MADV_HUGEPAGE);
#endif
}

/// An array of doubles that begins at a cache line, from which packs of rows are read fastest.
class AlignedArray {
 public:
  /// Provides room for `size` doubles, uninitialised. Discards the former content.
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
  static void release(double* data) { ::operator delete(data, alignment); }

  std::unique_ptr<double, void (*)(double*)> data_{nullptr, &release};
  Eigen::Index capacity_ = 0;
};

/// A factor: its layout and its numbers.
struct FactorMemory {
  FrontLayout layout;
  AlignedArray panels;
  AlignedArray updates;

  void make_room() {
    panels.make_room(layout.panel_begin.back());
    updates.make_room(layout.updates_size);
  }
  /// Returns front s with its memory.
  Front front(int s) const {
    const Supernodes& fronts = layout.fronts;
    return {fronts.rows(s), fronts.columns(s), panels.data() + layout.panel_begin[s],
            updates.data() + layout.update_begin[s]};
  }
  /// Returns the rows of front s, ascending in the order of elimination.
  const int* rows(int s) const { return layout.fronts.row.data() + layout.fronts.row_begin[s]; }
};

}  // namespace relievo
