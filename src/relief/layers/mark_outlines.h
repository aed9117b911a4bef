#pragma once

#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A ring of a part, and the places on it that must become samples.
struct MarkedRing {
  int part = -1;
  Ring ring;  ///< without repeated points; empty if it is too small to keep
  RingMeasure measure;
  std::vector<double> marks;  ///< arc lengths, px
};

/// A stretch of a ring, forward from one mark to another.
struct CurveRun {
  int curve = -1;         ///< the ring, or -1 if there is none
  double from = 0;        ///< arc lengths of its ends, px; `to` may be less than `from`
  double to = 0;          ///< (the run then passes the ring's first point)
  bool reversed = false;  ///< the user's first point is at `to`
  double length = 0;      ///< px
  int first = 0;          ///< the samples at its ends, once there are samples
  int last = 0;
};

/// The outlines of a scene before sampling.
struct MarkedOutlines {
  std::vector<MarkedRing> rings;          ///< one per ring of every part
  std::vector<CurveRun> joins;            ///< per join of the scene
  std::vector<double> join_spacing;       ///< per join: longest edges along it, px
  std::vector<CurveRun> robin;            ///< per Robin range of the scene
  std::vector<CurveRun> relation_ranges;  ///< per relation with a range
  /// Size of the smallest features that are kept, px: the spacing, or less if that is coarse.
  double detail = 0;
  std::vector<std::string> warnings;
};

/// Arc length from one place on a closed curve forward to another, in [0, length).
double arc_forward(double from, double to, double length);

/// Arc length between two places on a closed curve, the shorter way.
double arc_distance(double a, double b, double length);

/// Finds the joins and ranges of the scene on the outlines and marks their ends. Rings that are
/// specks are emptied, with a warning that names their part. Fails with bad_input naming a join
/// whose line is far from the upper outline or whose ends meet it at one point.
/// O(outline points * marks of the part).
Result<MarkedOutlines> mark_outlines(const Scene& scene, double spacing);

}  // namespace relievo::relief
