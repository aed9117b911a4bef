#pragma once

#include <string>
#include <vector>

#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/solid.h"
#include "solid/height_field.h"

namespace relievo {

/// A limb as a solid, at its place in the figure and with the figure's parts.
struct SolidLimb {
  std::string id;
  GridPoint low;            ///< least x and y of its field
  double twice_middle = 0;  ///< mm; mirrored, z becomes twice_middle - z
  Model model;
};

/// Unites a figure with its limbs mirrored to the far side, on a grid of `unit` mm. Updates the
/// model and pieces of `solid`, not its volume. `colours`: texture coordinates by part that replace
/// the limbs' own, or empty. A limb is moved by 0.01 to 0.04 mm, since it has the figure's outline.
/// Fails with usage, naming the limb, if figure and limb do not become one. Near-linear for each
/// limb.
Status unite_with_limbs(const std::vector<SolidLimb>& limbs, double unit,
                        const std::vector<Point2>& colours, Solid& solid);

}  // namespace relievo
