#pragma once

#include <optional>
#include <set>
#include <vector>

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/cap_rise.h"
#include "relief/ordering/depth_system.h"
#include "relief/ordering/ordering.h"
#include "relief/ordering/shift_metric.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

struct OrderingOptions {
  double epsilon = 1e-4;       ///< weight of the pull to h = f, in scene units (box diagonal 2)
  bool start_active = false;   ///< first active set: all gaps closed, or none
  bool straight_limbs = true;  ///< limbs keep the height of their roots (limb_rise); not in [P]
  bool close_caps = true;      ///< caps and spots follow what they lie on (cap_rise); not in [P]
};

/// State of the depth order of one surface, kept from one solve to the next.
struct OrderingSystem {
  double epsilon = 0;  ///< of the metric; 0 if there is none yet
  ShiftMetric metric;
  /// The tied_parts that `caps` were found for, if any.
  std::optional<std::vector<std::set<int>>> tied;
  std::vector<Cap> caps;
  std::optional<std::vector<DepthPair>> pairs;  ///< pairs of `depth`, if it is made
  DepthSystem depth;
  /// Start of the first solve: heights on this mesh if there are any, otherwise contacts on another
  /// mesh, otherwise OrderingOptions::start_active.
  std::vector<double> h;
  std::vector<DepthContact> contacts;
};

/// Makes the metric if epsilon has changed, and then marks pairs and caps as stale. O(N + F).
void set_metric(const SurfaceInput& surface, double epsilon, OrderingSystem& system,
                const RunContext& context);

/// Sets the wanted shifts of leans, slopes, limbs, caps and spots in the metric. Precondition: the
/// metric is set. Costs as set_slopes and the rises, and find_caps if other parts are tied.
void set_wanted(const SurfaceInput& surface, const Inflation& inflation,
                const OrderingOptions& options, OrderingSystem& system);

/// Makes the system for the mesh's pairs, by select_pairs if that serves. If `context` is
/// cancelled, no pairs are set.
void set_pairs(const SurfaceInput& surface, OrderingSystem& system, const RunContext& context);

/// Changes a system to `pairs` that link only nodes that it was made to link. The pattern of matrix
/// and factor stays, and so do the unchanged parts of the factor. Returns false and changes nothing
/// if other nodes are linked. `metric` is that of the system. Costs as make_depth_system without
/// its analysis.
bool select_pairs(const std::vector<int>& node_part, const std::vector<DepthPair>& pairs,
                  const ShiftMetric& metric, DepthSystem& system);

/// Makes the matrix of order_depth and its analysis, which do not depend on the inflation, so that
/// both can run at the same time. Optional, and of no effect on the result.
void prepare_ordering(const SurfaceInput& surface, const OrderingOptions& options,
                      OrderingSystem& system, const RunContext& context = {});

/// Shifts the parts so that all depth pairs of the mesh hold, at the least cost of g (ShiftMetric):
/// its Dirichlet energy, or that of its difference from wanted shifts. `system` is new or was used
/// with the same discretisation before. Then the solver starts from the last active set and
/// computes only what has changed; the minimum is the same. Fails with usage for options out of
/// range, with limit or internal if the solver fails, and when cancelled.
Result<Ordering> order_depth(const SurfaceInput& surface, const Inflation& inflation,
                             const OrderingOptions& options, OrderingSystem& system,
                             const RunContext& context = {});

Status check_options(const OrderingOptions& options);

/// Returns the error that a status of the solver stands for, if any.
Status check_solved(SolveStatus status);

/// Computes g = h - f, its gradients and the worst violation of the mesh's pairs from h.
/// O(N + pairs).
void finish_ordering(const SurfaceInput& surface, const Inflation& inflation, Ordering& ordering);

}  // namespace relievo::relief
