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
  NonlinearOptions nonlinear;  ///< its `ordering` and `bumps` are replaced by those above
  bool hidden = true;          ///< whether to solve hidden sheets, for models of whole sheets
};

/// Wall time of a stage, or of a piece of work inside one. Names may repeat.
struct StageTime {
  std::string stage;  ///< "mesh", "assemble", "analyse", "inflate", "order", "nonlinear" or "hide"
  double milliseconds = 0;
  bool beside = false;  ///< whether another thread than that of its stage did the work
};

/// All intermediate results of a reconstruction.
struct Relief {
  LayeredMesh layers;
  Inflation inflation;
  Ordering ordering;
  NonlinearReport nonlinear;  ///< without steps for the approximate method
  std::vector<NonlinearSnapshot> snapshots;
  std::vector<StageTime> times;  ///< of the stages that ran
};

/// Builds layers and inflation, and then the depth order or the non-linear solution.
Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context = {});

/// Replaces h by one of its summands, for inspection. O(N).
void keep_field(Relief& relief, Field field);

}  // namespace relievo::relief
