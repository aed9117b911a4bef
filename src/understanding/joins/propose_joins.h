#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "understanding/completion/part_regions.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/stacking/stacking.h"

namespace relievo::understanding {

struct JoinProposalOptions {
  double min_root = 0.1;        ///< a root takes at least this share of the upper part's outline
  int min_root_sides = 8;       ///< and so many pixel sides
  double max_size_ratio = 10;   ///< of what is seen of the upper part to what is of the lower
  double shortest_ramp = 0.08;  ///< share of the root beside each end of the join
  double longest_ramp = 0.3;
  /// Per label, the mean colour of what is seen, 0 to 255 a channel; none where unknown.
  std::vector<std::array<double, 3>> colours;
  /// Pairs of labels, the smaller first, that have grown together (see open_borders).
  std::vector<std::pair<uint16_t, uint16_t>> open;
};

/// Proposes how every part connects with those behind it. Where its completed outline shows that it
/// is a limb of one of them, it is joined to that at the cap of its root (see propose_layer_joins).
/// Of the others that touch:
///  - join: the outline of the part has exactly one run that borders on parts behind it (its
///    root), the rest of it goes elsewhere, the root is no small part of the outline, and the part
///    is not many times larger than the lower one, as a body over a far arm is. The join
///    is the middle of that run; the ramps beside it are as long as the run exceeds its chord, so
///    that they end where a limb leaves the lower part, and become Robin ranges;
///    A clear change of colour halves the confidence, since hats are not grown on, but sleeves are;
///    where the two have grown together, neither the root's share nor the size matters. What more
///    surely grows out from behind another part, as legs from behind a skirt, has no such join: a
///    cape behind it is not what it grows out of;
///  - equal: the outline does not touch the background: an eye, a button, a spot; or the completed
///    outlines tie the two, as a limb that comes out from behind a larger part;
///  - above: everything else.
/// `outlines` are those of the parts in the scene. O(sides).
JoinProposals propose_joins(const PartRegions& regions, const Stacking& stacking,
                            const std::vector<Outline>& outlines,
                            const JoinCorrections& corrections = {},
                            const JoinProposalOptions& options = {});

}  // namespace relievo::understanding
