#pragma once

#include <atomic>

#include "kernel/solvers/frontal_kernels.h"

namespace relievo {

/// panel := its columns of the Cholesky factor, update -= what they contribute to the rest.
/// False when a pivot is not positive, or as soon as `stop`, which may be null, is set. Cuts large
/// fronts into tasks, which changes no bit: each entry is computed by one of them.
bool eliminate_front(const FrontalKernels& kernels, const Front& front,
                     const std::atomic<bool>* stop);

}  // namespace relievo
