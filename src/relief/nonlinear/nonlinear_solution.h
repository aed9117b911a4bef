#pragma once

#include <vector>

#include "relief/inflation/inflation.h"
#include "relief/ordering/depth_contacts.h"
#include "relief/ordering/ordering.h"
#include "relievo/point.h"

namespace relievo::relief {

/// What an iteration knew of one node where parts press on each other, or on B.
struct NonlinearMark {
  int part = -1;
  Point2 position;          ///< px
  bool on_outline = false;  ///< or on B
  double rise = 0;          ///< u beyond that of the start, scene units
  double load = 0;          ///< with which the pairs change u, scene units

  int group() const { return part; }
};

/// Where an iteration ended, for another to begin from, on the same mesh or one of a similar
/// scene.
struct NonlinearMemory {
  std::vector<NonlinearMark> marks;  ///< by group and position
  std::vector<DepthContact> contacts;
};

/// The energy of the non-linear formulation [P eq 3-5] in scene units, by its terms with their
/// weights.
struct NonlinearEnergy {
  double inflation = 0;  ///< (M^-1 L u - c)' M (M^-1 L u - c) over all nodes that are not held
  double boundary = 0;   ///< lambda_bnd times the line integral of f^2 over B
  double shift = 0;      ///< lambda_shift times twice the cost of g, which is g'(L + epsilon M) g
                         ///< where no part leans
  double total() const { return inflation + boundary + shift; }
};

/// One step of the iteration.
struct NonlinearStep {
  NonlinearEnergy energy;  ///< of the step; belongs to one point only in the limit
  double residual = 0;     ///< largest change of u, relative to the largest u
  int factorisations = 0;  ///< of the contact problem; 1 where its closed gaps stayed so
  double milliseconds = 0;
};

enum class NonlinearStatus { solved, iteration_limit };

struct NonlinearReport {
  NonlinearStatus status = NonlinearStatus::solved;
  std::vector<NonlinearStep> steps;
  NonlinearEnergy energy;  ///< of the solution
  double residual = 0;
};

/// The surface where the iteration would end after one of its steps: the inflation of the step
/// and the depth order for it.
struct NonlinearSnapshot {
  int step = 0;  ///< steps taken, from 1
  Inflation inflation;
  Ordering ordering;
};

/// A minimiser of the non-linear energy under the depth pairs.
struct NonlinearSolution {
  Inflation inflation;
  Ordering ordering;
  NonlinearReport report;
  std::vector<NonlinearSnapshot> snapshots;  ///< as the options ask, in order
  NonlinearMemory memory;                    ///< empty where the iteration did not converge
};

}  // namespace relievo::relief
