#pragma once

#include <cstdint>
#include <vector>

#include "kernel/image/mask.h"
#include "understanding/completion/completion.h"
#include "understanding/completion/part_regions.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/joins/layer_grid.h"

namespace relievo::understanding {

/// The amount of inflation c that makes an ellipse with the proportions of a mask as deep as it is
/// narrow. With half axes a >= b,
///   h = c a^2 b^2 / (2 (a^2 + b^2)) (1 - x^2 / a^2 - y^2 / b^2)
/// solves -laplace(h) = c, and the height sqrt(h) is b in the middle for
///   c = 2 (1 + (b / a)^2):
/// 4 for a disc, 2 for a long limb. O(box).
double round_inflation(const Mask& mask);

/// The factor of c of a feature that takes a share q of the part that it lies on,
///   max(0.4 (1 - 1.5 sqrt(q)), 0.02).
/// Features bulge about half as much as balls, as the eyes, noses and flowers of the samples do by
/// their authors' choice (median c 0.3 of round), and less the larger they are: a patch on a belly
/// hardly bulges.
double feature_inflation(double share);

/// The factor of c of a backdrop, and its profile (Part::flat).
constexpr double backdrop_inflation = 0.5;
constexpr double backdrop_flat = 1;

/// Per part, 1 where it is a backdrop, as a cape or a mane is: cloth or hair behind the figure, of
/// which only narrow strips are seen. Inflated as other parts are, a backdrop would bend like a
/// drum and turn its strips away from the figure. A backdrop takes a good share of the figure; less
/// than half of it is seen, nowhere more than about half as thick as the whole; a good part of the
/// edge of what is seen borders on the background; next to nothing lies behind it; and no part of
/// some size that lies within it grows out of it, as a face does out of hair. `regions`, sorted
/// back to front, have what is seen with the ink of outlines; `shapes` are those in the scene.
/// O(pixels of the shapes).
std::vector<uint8_t> find_backdrops(const PartRegions& regions, const Completion& shapes,
                                    const std::vector<ProposedJoin>& joins);

/// Finds the parts that look hollow by their colours: open mouths, which lie inside a larger part,
/// are wide, red and much darker than it; and the cups of ears, which are pink, not dark, and fill
/// a good share of a limb. `limb` is 1 for each part that is a limb. The result is in ascending
/// order, and empty where no colours are known.
std::vector<int> hollow_parts(const LayerGrid& grid, const PartColors& colors,
                              const std::vector<uint8_t>& limb);

}  // namespace relievo::understanding
