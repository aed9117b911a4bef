#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/inflation/inflate.h"
#include "relief/layers/layer_parts.h"
#include "relief/model/assemble_model.h"
#include "relief/model/relief_maps.h"
#include "relief/ordering/order_depth.h"

namespace relievo {

struct ReliefOptions {
  LayerOptions layers;
  InflationOptions inflation;
  OrderingOptions ordering;
};

/// Wall time of a stage, or of a piece of work inside one. They do not overlap; a name may occur
/// several times.
struct StageTime {
  std::string stage;  ///< "mesh", "assemble", "analyse", "inflate" or "order"
  double milliseconds = 0;
};

/// Every intermediate value of a reconstruction.
struct Relief {
  LayeredMesh layers;
  Inflation inflation;
  Ordering ordering;
  std::vector<StageTime> times;
};

/// Runs the approximate method: layers, inflation, ordering [P §3.2].
Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context = {});

}  // namespace relievo
