#pragma once

#include <atomic>

#include "kernel/cholesky/frontal_kernels.h"

namespace relievo {

/// Eliminates the columns of a front, in place:
///   panel := its columns L of the Cholesky factor,   update := update - L2 L2',
/// where L2 are the rows of L below its own columns. Returns false where a pivot is not positive,
/// or once `stop`, which may be null, is set. Works on blocks of columns, and divides large fronts
/// into tasks; each entry is computed by one of them, so that threads change no bit. O(columns *
/// rows^2).
bool eliminate_front(const FrontalKernels& kernels, const Front& front,
                     const std::atomic<bool>* stop);

}  // namespace relievo
