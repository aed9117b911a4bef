#pragma once

#include <string>
#include <vector>

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/solid.h"

namespace relievo {

/// A limb as a solid where the figure has it, which has the same parts.
struct SolidLimb {
  std::string id;
  double twice_middle = 0;  ///< mm; mirrored, z becomes so much less z
  Model model;
};

/// Unites a figure with its limbs mirrored to the far side, on a grid of `unit` mm; not its volume.
/// `colours`: by part, in place of the limbs' own, or empty. A limb is moved by 0.01 to 0.04 mm, as
/// it has the figure's outline. Fails with usage, naming the limb, where they do not become one.
/// Near-linear for each limb.
Status unite_with_limbs(const std::vector<SolidLimb>& limbs, double unit,
                        const std::vector<Point2>& colours, Solid& solid);

}  // namespace relievo
