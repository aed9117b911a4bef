#include "io/project/record_proposal.h"

namespace relievo {

SegmentationRecord record_proposal(const PartRegions& regions, const Completion& completion,
                                   const Stacking& stacking, const Joining& joining,
                                   const Scene& scene) {
  const std::vector<PartLabel>& labels = regions.labels;
  SegmentationRecord record;
  for (const int part : stacking.back_to_front)
    record.parts.push_back(
        {labels[part], scene.parts[stacking.rank[part]].id, completion.parts[part].kind});
  for (OrderArrow arrow : stacking.arrows) {
    arrow.upper = labels[arrow.upper];
    arrow.lower = labels[arrow.lower];
    record.order.push_back(arrow);
  }
  for (const ProposedJoin& proposed : joining.joins)
    record.joins.push_back(
        {labels[proposed.join.upper], labels[proposed.join.lower], proposed.confidence});
  return record;
}

}  // namespace relievo
