#pragma once

#include "relief/ordering/order_depth.h"
#include "relief/ordering/ordering.h"
#include "relievo/result.h"

namespace relievo {

Status check_options(const OrderingOptions& options);

/// The error, if any, that a status of the solver stands for.
Status check_solved(SolveStatus status);

/// Fills in g = h - f, its gradients and the worst violation of the mesh's pairs. O(N + pairs).
void finish_ordering(const OrderingInput& input, Ordering& ordering);

}  // namespace relievo
