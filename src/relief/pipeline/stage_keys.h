#pragma once

#include "kernel/geometry/polygon.h"
#include "relief/layers/layer_parts.h"
#include "relief/pipeline/key.h"
#include "relief/pipeline/relief_options.h"
#include "relievo/scene.h"

namespace relievo {

// What each stage reads, besides values of earlier stages.

/// Of join_sheets: geometry, joins, where ranges begin and end, and where creases lie.
Key sheets_key(const Scene& scene, const LayerOptions& options);

/// Of constrain_sheets: relations and what Robin ranges say.
Key layers_key(const Scene& scene, const LayerOptions& options);

/// What inflate reads of the mesh besides its triangulation.
Key boundary_key(const LayeredMesh& mesh);

/// Of inflate: amounts of inflation, and bulges.
Key inflation_key(const Scene& scene, const InflationOptions& options);

/// Of order_depth: constraints, which faces may cross, leans, and the cues that slope.
Key ordering_key(const LayeredMesh& mesh, const Scene& scene, const OrderingOptions& options);

/// Of solve_jointly, besides what the ordering reads.
Key joint_key(const JointOptions& options);

}  // namespace relievo
