#pragma once

#include <span>
#include <string_view>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layer_parts.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo {

struct RivalOptions {
  double graft = 0.25;  ///< of Ink-and-Ray: half the width of the graft / the join's length, >= 0
  Image8 graft_mask;    ///< likewise: what is grafted instead, where it is not dark, over the
                        ///< whole canvas; none where it is empty
  double cell = 0.2;    ///< of Entem: size of cells / the radius there, > 0
};

/// What every method of reconstruction is given: the same parts on the same triangulation.
struct RivalInput {
  const Scene& scene;
  const LayeredMesh& joined;  ///< of layer_for_rivals; a rival may undo its joins
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
Result<LayeredMesh> layer_for_rivals(const Scene& scene, LayerOptions layers,
                                     const RunContext& context = {});

/// Every method, ours first.
std::span<const Rival> rivals();

/// The one of that name, or null.
const Rival* find_rival(std::string_view name);

/// Our own, with its defaults.
Result<Model> reconstruct_ours(const RivalInput& input, const RunContext& context);

/// Our joined surface with u = 0 along the whole outline of the upper part, as in Monster Mash
/// (Dvorožňák et al. 2020): pits where joins end.
Result<Model> reconstruct_with_firm_ends(const RivalInput& input, const RunContext& context);

/// Every part by itself, without joins: what inflating layers one by one gives.
Result<Model> reconstruct_pillows(const RivalInput& input, const RunContext& context);

/// Parts by themselves with the profile of Poisson's equation without the root (Yeh et al. 2017,
/// Jayaraman et al. 2018): f = d u s, s of each part such that its apex is that of d sqrt(u).
Result<Model> reconstruct_parabolic(const RivalInput& input, const RunContext& context);

/// Ink-and-Ray (Sýkora et al. 2014): parts by themselves with a natural boundary where they join,
/// brought to the height of the lower part there by the depth order, and grafted afterwards.
Result<Model> reconstruct_ink_and_ray(const RivalInput& input, const RunContext& context);

/// A convolution surface over the medial axes of all parts (Entem et al. 2015), closed.
Result<Model> reconstruct_entem(const RivalInput& input, const RunContext& context);

}  // namespace relievo
