#pragma once

#include <span>
#include <string_view>

#include "relief/layers/layer_parts.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"
#include "research/rivals/graft.h"

namespace relievo::research {

struct RivalOptions {
  double graft = 0.25;  ///< for Ink-and-Ray: half the width of the graft / length of the join, >= 0
  Image8 graft_mask;    ///< for Ink-and-Ray: picture of the canvas that is not dark where to graft
                        ///< instead; or empty
  double cell = 0.2;    ///< for Entem: size of triangles / the radius there, > 0
};

/// The input of every method: the same parts on the same triangulation.
struct RivalInput {
  const Scene& scene;
  const relief::LayeredMesh& joined;  ///< from layer_for_rivals; a rival may undo its joins
  const RivalOptions& options;
};

/// A method of reconstruction. Returns whole parts, including hidden ones. Errors: those of the
/// stages.
using Reconstruct = Result<Model> (*)(const RivalInput& input, const RunContext& context);

/// A published method.
struct Rival {
  const char* name;    ///< on the command line
  const char* source;  ///< publication
  Reconstruct reconstruct;
};

/// Triangulates the parts and joins them as in the paper, for all methods. Errors: as layer_parts.
Result<relief::LayeredMesh> layer_for_rivals(const Scene& scene, relief::LayerOptions layers,
                                             const RunContext& context = {});

/// Returns all methods, ours first.
std::span<const Rival> rivals();

/// Returns the method of that name, or null.
const Rival* find_rival(std::string_view name);

}  // namespace relievo::research
