#include "kernel/geometry/simplify_line.h"

#include <cstdint>
#include <utility>

#include "kernel/geometry/ring_measure.h"

namespace relievo {

std::vector<Point2> simplify_line(const std::vector<Point2>& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<uint8_t> keep(line.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<size_t, size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    size_t farthest = a;
    double largest = tolerance;
    for (size_t i = a + 1; i < b; ++i) {
      const double d = distance_to_segment(line[i], line[a], line[b]);
      if (d <= largest) continue;
      largest = d;
      farthest = i;
    }
    if (farthest == a) continue;
    keep[farthest] = 1;
    open.emplace_back(a, farthest);
    open.emplace_back(farthest, b);
  }
  std::vector<Point2> few;
  for (size_t i = 0; i < line.size(); ++i)
    if (keep[i] != 0) few.push_back(line[i]);
  return few;
}

}  // namespace relievo
