#pragma once

#include <vector>

#include "relievo/result.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// Drops guessed arrows until no cycle is left: while there is one, the least confident guess that
/// lies on a cycle (the first of equals). `parts` are all labels in ascending order. The user's
/// arrows are never dropped; a cycle of those alone is an error (`contradiction`) that names the
/// labels of one of them. O(arrows * (parts + arrows)).
Status break_cycles(const std::vector<PartLabel>& parts, std::vector<OrderArrow>& arrows);

/// Sorts parts back to front along the kept arrows, as indices into `labels`, which are in
/// ascending order; among parts that may come next, the one with the largest `area` comes first.
/// Precondition: no cycles. O(parts^2 + arrows).
std::vector<int> sort_back_to_front(const std::vector<PartLabel>& labels,
                                    const std::vector<double>& area,
                                    const std::vector<OrderArrow>& arrows);

/// Moves one part at a time as long as that makes the order likelier. `log_odds[p][q]` are the
/// log-odds of p being in front of q, and equal -log_odds[q][p]. O(parts^2) per round of moves;
/// few rounds are needed.
std::vector<int> likelier_order(std::vector<int> back_to_front,
                                const std::vector<std::vector<double>>& log_odds);

}  // namespace relievo::understanding
