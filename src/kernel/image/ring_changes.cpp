#include "kernel/image/ring_changes.h"

namespace relievo {
namespace {

/// Counts the sides from `at` on, in steps of 1 or n - 1, with the same label beyond; up to `most`.
size_t run_length(const LabelRing& ring, size_t at, size_t step, size_t most) {
  size_t count = 0;
  for (size_t i = at; count < most && ring.beyond[i] == ring.beyond[at];
       i = (i + step) % ring.size())
    ++count;
  return count;
}

}  // namespace

std::vector<RingChange> ring_changes(const LabelRing& ring, size_t near, size_t far) {
  std::vector<RingChange> changes;
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i) {
    const size_t previous = (i + n - 1) % n;
    if (ring.beyond[i] == ring.beyond[previous]) continue;
    RingChange change{i, ring.beyond[previous], ring.beyond[i], 0, 0, {}, {}};
    change.run_before = run_length(ring, previous, n - 1, far);
    change.run_after = run_length(ring, i, 1, far);
    if (change.run_before > near + 1)
      change.in = ring.sides[(i + n - near) % n] - ring.sides[(i + n - change.run_before) % n];
    if (change.run_after > near + 1)
      change.out = ring.sides[(i + change.run_after - 1) % n] - ring.sides[(i + near) % n];
    changes.push_back(change);
  }
  return changes;
}

}  // namespace relievo
