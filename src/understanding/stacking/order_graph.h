#pragma once

#include <vector>

#include "relievo/result.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// Gives up guessed arrows until no cycle is left: while there is one, the least confident guess
/// that lies on a cycle (of equals, the one with the smallest `weight`, then the first). Arrows of
/// the user are never given up; a cycle of those alone is an error (`contradiction`) that names
/// its parts by `name`. O(arrows * (parts + arrows)).
Status break_cycles(int parts, std::vector<OrderArrow>& arrows);

/// Parts back to front along the kept arrows; among parts that may come next, the one with the
/// largest `area` first. Precondition: no cycles. O(parts^2 + arrows).
std::vector<int> sort_back_to_front(const std::vector<double>& area,
                                    const std::vector<OrderArrow>& arrows);

/// Moves parts, one at a time, as long as that makes the order likelier. `log_odds[p][q]` are those
/// of p being in front of q, and -log_odds[q][p]. O(parts^2) a round of moves, of which few are
/// needed.
std::vector<int> likelier_order(std::vector<int> back_to_front,
                                const std::vector<std::vector<double>>& log_odds);

}  // namespace relievo::understanding
