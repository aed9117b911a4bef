#pragma once

#include "rivals/rival.h"

namespace relievo {

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
