#pragma once

#include <cstdint>
#include <vector>

#include "kernel/image/mask.h"
#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

/// The amount of inflation that makes an ellipse of these proportions as deep as it is narrow:
/// -c = laplace(c a^2 b^2 / (2 (a^2 + b^2)) (1 - x^2 / a^2 - y^2 / b^2)) with height b in the
/// middle, hence c = 2 (1 + (b / a)^2): 4 for a disc, 2 for a long limb.
/// O(box).
double round_inflation(const Mask& mask);

/// By what c is multiplied of a feature that takes a share q of what it lies on: 0.4 (1 - 1.5
/// sqrt(q)), at least 0.02. Features bulge half as much as balls, as the eyes, noses and flowers
/// of the samples do by their authors (c is 0.3 of round in the median), and the less the larger
/// they are: a patch on a belly hardly does.
double feature_inflation(double share);

/// By what c of a backdrop is multiplied, and the profile that it gets.
constexpr double backdrop_inflation = 0.5;
constexpr double backdrop_flat = 1;

/// Per part, 1 where it is a backdrop, as a cape or a mane is: cloth or hair behind the figure, of
/// which only narrow strips around what hides it are seen. Inflated as all others it would turn
/// like a drum, and its strips would face away from the figure, which they do not. A backdrop takes
/// a good share of the figure; less than half of it is seen, nowhere more than about half as thick
/// as it is itself; a good part of the edge of what is seen is towards the background; next to
/// nothing lies behind it; and nothing of some size that lies within it grows out of it, as a face
/// does out of hair. `shapes` are those of the parts in the scene, `regions` what is seen of them,
/// the ink of their outlines with it. O(pixels of the shapes).
std::vector<uint8_t> find_backdrops(const PartRegions& regions, const Stacking& stacking,
                                    const Completion& shapes,
                                    const std::vector<ProposedJoin>& joins);

}  // namespace relievo::understanding
