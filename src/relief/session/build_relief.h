#pragma once

#include <string>
#include <vector>

#include "relief/inflation/inflate.h"
#include "relief/layers/layer_parts.h"
#include "relief/layers/layered_mesh.h"
#include "relief/nonlinear/solve_nonlinear.h"
#include "relief/ordering/order_depth.h"
#include "relievo/model.h"
#include "relievo/options.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

struct ReliefOptions {
  Method method = Method::approximate;
  LayerOptions layers;
  InflationOptions inflation;
  OrderingOptions ordering;
  NonlinearOptions nonlinear;  ///< of the non-linear method; epsilon and limbs are the ordering's
  /// Whether what is hidden from the front is wanted too: in models of whole sheets.
  bool hidden = true;
};

/// Wall time of a stage, or of a piece of work inside one. A name may occur several times. Only
/// what is done beside others overlaps them.
struct StageTime {
  std::string stage;  ///< "mesh", "assemble", "analyse", "inflate", "order", "nonlinear" or "hide"
  double milliseconds = 0;
  bool beside = false;  ///< on another thread than the stage that it counts to
};

/// Every intermediate value of a reconstruction.
struct Relief {
  LayeredMesh layers;
  Inflation inflation;
  Ordering ordering;
  int overlap_samples = 0;                   ///< faces that come out in front of the next one
  double overlap_worst = 0;                  ///< and by how much at most, px
  NonlinearReport nonlinear;                 ///< of the non-linear method; without steps otherwise
  std::vector<NonlinearSnapshot> snapshots;  ///< likewise
  std::vector<StageTime> times;              ///< of the stages that ran
};

/// Layers and inflation, then the order of depths, or the non-linear problem from there.
Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context = {});

/// Leaves only one of the fields in the relief, in place of h, so that it can be looked at.
/// O(N).
void keep_field(Relief& relief, Field field);

}  // namespace relievo::relief
