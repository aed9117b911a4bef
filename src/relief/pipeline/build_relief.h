#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/inflation/inflate.h"
#include "relief/joint/solve_jointly.h"
#include "relief/layers/layer_parts.h"
#include "relief/model/assemble_model.h"
#include "relief/model/relief_maps.h"
#include "relief/ordering/order_depth.h"

namespace relievo {

enum class Method {
  approximate,  ///< inflation, then order [P §3.2]
  nonlinear,    ///< both at once [P §3.1]
};

struct ReliefOptions {
  Method method = Method::approximate;
  LayerOptions layers;
  InflationOptions inflation;
  OrderingOptions ordering;
  JointOptions joint;  ///< of the non-linear method; epsilon and max_rounds are the ordering's
};

/// Wall time of a stage, or of a piece of work inside one. They do not overlap; a name may occur
/// several times.
struct StageTime {
  std::string stage;  ///< "mesh", "assemble", "analyse", "inflate", "order" or "nonlinear"
  double milliseconds = 0;
};

/// Every intermediate value of a reconstruction.
struct Relief {
  LayeredMesh layers;
  Inflation inflation;
  Ordering ordering;
  JointReport joint;                     ///< of the non-linear method; without steps otherwise
  std::vector<JointSnapshot> snapshots;  ///< likewise
  std::vector<StageTime> times;
};

/// Layers and inflation, then the order of depths, or the joint problem from there.
Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context = {});

}  // namespace relievo
