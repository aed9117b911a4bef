#include "apps/cli/segment_project.h"

#include <filesystem>

namespace relievo::cli {
namespace {

SegmentationRecord record_of(const SegmentInput& input, const Proposal& proposal) {
  const std::vector<PartLabel>& labels = proposal.regions.labels;
  SegmentationRecord record{input.labels, input.scribbles, input.corrections, {}, {}, {}};
  for (const int part : proposal.stacking.back_to_front)
    record.parts.push_back({labels[part], proposal.scene.parts[proposal.stacking.rank[part]].id,
                            proposal.completion.parts[part].kind});
  for (OrderArrow arrow : proposal.stacking.arrows) {
    arrow.upper = labels[arrow.upper];
    arrow.lower = labels[arrow.lower];
    record.order.push_back(arrow);
  }
  for (const ProposedJoin& proposed : proposal.joining.joins)
    record.joins.push_back(
        {labels[proposed.join.upper], labels[proposed.join.lower], proposed.confidence});
  return record;
}

}  // namespace

Project project_of(const SegmentInput& input, const Proposal& proposal) {
  Project project;
  project.name = std::filesystem::path(input.drawing.name).stem().string();
  project.drawing = input.drawing;
  project.segmentation = record_of(input, proposal);
  project.scene = proposal.scene;
  project.scene.drawing = "drawing";
  return project;
}

}  // namespace relievo::cli
