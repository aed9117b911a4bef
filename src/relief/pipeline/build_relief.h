#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/model/assemble_model.h"
#include "relief/model/relief_maps.h"
#include "relief/pipeline/relief_options.h"
#include "relief/pipeline/stage_clock.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// Every intermediate value of a reconstruction.
struct Relief {
  LayeredMesh layers;
  Inflation inflation;
  Ordering ordering;
  int overlap_samples = 0;               ///< faces that come out in front of the next one
  double overlap_worst = 0;              ///< and by how much at most, px
  JointReport joint;                     ///< of the non-linear method; without steps otherwise
  std::vector<JointSnapshot> snapshots;  ///< likewise
  std::vector<StageTime> times;          ///< of the stages that ran
};

/// Layers and inflation, then the order of depths, or the joint problem from there.
Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context = {});

}  // namespace relievo
