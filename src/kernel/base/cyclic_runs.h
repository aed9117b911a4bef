#pragma once

#include <cstddef>

namespace relievo {

/// Divides the circle 0 .. n-1 into its longest runs along which same(i, i + 1) holds, and calls
/// visit(first, count) for each run, in the order of their first elements. A run may continue past
/// n-1 at 0. Where the whole circle is one run, calls visit(0, n). O(n).
template <class Same, class Visit>
void for_each_run(size_t n, Same same, Visit visit) {
  size_t start = 0;
  while (start < n && same((start + n - 1) % n, start)) ++start;
  if (start == n) {
    if (n > 0) visit(size_t{0}, n);
    return;
  }
  for (size_t i = start; i < start + n;) {
    size_t count = 1;
    while (same((i + count - 1) % n, (i + count) % n)) ++count;
    visit(i % n, count);
    i += count;
  }
}

}  // namespace relievo
