#pragma once

#include <Eigen/Core>
#include <deque>

namespace relievo::testing {

/// Minimises `function(x, slope)` by the limited-memory BFGS method (Nocedal 1980) with a
/// backtracking line search, at most `steps` steps.
template <class Function>
Eigen::VectorXd minimise_by_lbfgs(const Function& function, Eigen::VectorXd x, int steps) {
  using Eigen::VectorXd;
  struct Pair {
    VectorXd s, y;
  };
  std::deque<Pair> memory;
  VectorXd slope, next_slope;
  double value = function(x, slope);
  for (int k = 0; k < steps && slope.norm() > 1e-12; ++k) {
    VectorXd way = -slope;
    std::deque<double> weights;
    for (auto pair = memory.rbegin(); pair != memory.rend(); ++pair) {
      weights.push_front(pair->s.dot(way) / pair->s.dot(pair->y));
      way -= weights.front() * pair->y;
    }
    if (!memory.empty())
      way *= memory.back().s.dot(memory.back().y) / memory.back().y.squaredNorm();
    for (size_t i = 0; i < memory.size(); ++i)
      way += (weights[i] - memory[i].y.dot(way) / memory[i].s.dot(memory[i].y)) * memory[i].s;
    double length = memory.empty() ? 1e-4 / slope.norm() : 1;
    const double descent = slope.dot(way);
    double next = function(x + length * way, next_slope);
    while (!(next <= value + 1e-4 * length * descent) && length > 1e-14) {
      length /= 2;
      next = function(x + length * way, next_slope);
    }
    if (!(next < value)) {
      if (memory.empty()) break;
      memory.clear();
      continue;
    }
    const Pair pair{length * way, next_slope - slope};
    x += pair.s;
    value = next;
    slope = next_slope;
    if (pair.s.dot(pair.y) > 1e-16 * pair.y.squaredNorm()) memory.push_back(pair);
    if (memory.size() > 20) memory.pop_front();
  }
  return x;
}

}  // namespace relievo::testing
