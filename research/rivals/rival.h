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
  double graft = 0.25;  ///< of Ink-and-Ray: half the width of the graft / the join's length, >= 0
  Image8 graft_mask;    ///< likewise: what is grafted instead, where it is not dark, over the
                        ///< whole canvas; none where it is empty
  double cell = 0.2;    ///< of Entem: size of cells / the radius there, > 0
};

/// What every method of reconstruction is given: the same parts on the same triangulation.
struct RivalInput {
  const Scene& scene;
  const relief::LayeredMesh& joined;  ///< of layer_for_rivals; a rival may undo its joins
  const RivalOptions& options;
};

/// A method of reconstruction. Whole parts, hidden ones too, in the space of `Model`. Fails as the
/// stages do.
using Reconstruct = Result<Model> (*)(const RivalInput& input, const RunContext& context);

struct Rival {
  const char* name;    ///< as the command line spells it
  const char* source;  ///< where it was published
  Reconstruct reconstruct;
};

/// The parts on one triangulation, joined as in the paper, for all methods. Fails as layer_parts.
Result<relief::LayeredMesh> layer_for_rivals(const Scene& scene, relief::LayerOptions layers,
                                             const RunContext& context = {});

/// Every method, ours first.
std::span<const Rival> rivals();

/// The one of that name, or null.
const Rival* find_rival(std::string_view name);

}  // namespace relievo::research
