#pragma once

#include <vector>

#include "relief/inflation/inflation.h"
#include "relief/ordering/depth_system.h"
#include "relief/ordering/ordering.h"
#include "relievo/point.h"

namespace relievo::relief {

/// The result of an iteration at one node of a depth pair or of B, independent of the mesh.
struct NonlinearMark {
  int part = -1;
  Point2 position;          ///< px
  bool on_outline = false;  ///< whether the node is on an outline or on B
  double rise = 0;          ///< u minus that of the start, scene units
  double load = 0;          ///< load phi of the depth pairs on u, scene units

  int group() const { return part; }
};

/// The end of an iteration, from which another can start on the same mesh or that of a similar
/// scene.
struct NonlinearMemory {
  std::vector<NonlinearMark> marks;  ///< by group and position
  std::vector<DepthContact> contacts;
};

/// The terms of the non-linear energy [P eq 3-5] with their weights, in scene units.
struct NonlinearEnergy {
  double inflation = 0;  ///< (M^-1 L u - c)' M (M^-1 L u - c), summed over the free nodes I
  double boundary = 0;   ///< lambda_bnd times the line integral of f^2 over B
  double shift = 0;      ///< lambda_shift times twice the cost of g (ShiftMetric)
  double total() const { return inflation + boundary + shift; }
};

/// One step of the iteration.
struct NonlinearStep {
  NonlinearEnergy energy;  ///< its terms belong to one point only in the limit
  double residual = 0;     ///< largest change of u, relative to the largest u
  int factorisations = 0;  ///< of the contact problem; 1 if no gap changed sides
  double milliseconds = 0;
};

struct NonlinearReport {
  SolveStatus status = SolveStatus::solved;  ///< or iteration_limit
  std::vector<NonlinearStep> steps;
  NonlinearEnergy energy;  ///< of the solution
  double residual = 0;     ///< of the last step
};

/// The surface after one step of the iteration: its inflation and the depth order for that.
struct NonlinearSnapshot {
  int step = 0;  ///< number of steps taken, from 1
  Inflation inflation;
  Ordering ordering;
};

/// A minimiser of the non-linear energy under the depth pairs.
struct NonlinearSolution {
  Inflation inflation;
  Ordering ordering;
  NonlinearReport report;
  std::vector<NonlinearSnapshot> snapshots;  ///< at NonlinearOptions::snapshots, in order
  NonlinearMemory memory;                    ///< empty if the iteration did not converge
};

}  // namespace relievo::relief
