#pragma once

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <Eigen/Core>
#include <memory>
#include <new>

#include "kernel/solvers/front_layout.h"
#include "kernel/solvers/frontal_kernels.h"

namespace relievo {

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
