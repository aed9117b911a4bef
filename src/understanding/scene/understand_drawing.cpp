#include "understanding/scene/understand_drawing.h"

#include <utility>

#include "kernel/image/compose.h"
#include "understanding/scene/keep_edits.h"
#include "understanding/scene/open_borders.h"
#include "understanding/scene/outline_rim.h"

namespace relievo::understanding {
namespace {

std::map<std::string, PartLabel> labels_by_id(const SegmentationRecord& record) {
  std::map<std::string, PartLabel> label_of;
  for (const PartRecord& part : record.parts) label_of[part.id] = part.label;
  return label_of;
}

/// The known record with a proposal in place of what was proposed before.
SegmentationRecord with_proposal(SegmentationRecord record, const Proposal& proposal) {
  const std::vector<PartLabel>& labels = proposal.regions.labels;
  const Stacking& stacking = proposal.stacking;
  record.parts.clear();
  record.order.clear();
  record.joins.clear();
  for (const int part : stacking.back_to_front)
    record.parts.push_back({labels[part], proposal.scene.parts[stacking.rank[part]].id,
                            proposal.completion.parts[part].kind});
  for (OrderArrow arrow : stacking.arrows) {
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

Relabelling relabel(const Segmentation& found, SegmentationRecord known,
                    const ProposalOptions& options) {
  KeptLabels kept = keep_labels(found, {std::move(known.labels), labels_by_id(known)});
  name_scribbled(found, kept, known.corrections);
  known.corrections = corrections_of(kept.labels, known.corrections, options.min_pixels);
  known.labels = std::move(kept.labels);
  return {std::move(known), std::move(kept.label_of)};
}

Result<Understanding> understand_drawing(const Image8& rgba, const SegmentationRecord& known,
                                         const Scene& edited, const ProposalOptions& options,
                                         const RunContext& context) {
  ProposalOptions with_colours = options;
  with_colours.joining.colours = label_colours(rgba, known.labels);
  with_colours.joining.open = open_borders(rgba, known.labels);
  with_colours.rim = rim_width(rgba, known.labels, with_colours.joining.colours);
  auto proposal = propose_scene(known.labels, known.corrections, with_colours, context);
  if (!proposal) return proposal.error();
  const std::vector<std::string>& scribbled = known.scribbles.parts;
  const EditedScene edits{edited, labels_by_id(known), {scribbled.begin(), scribbled.end()}};
  Understanding understanding{std::move(*proposal), {}, {}};
  Proposal& proposed = understanding.proposal;
  avoid_drawn_names(edits, proposed.scene);
  understanding.record = with_proposal(known, proposed);
  std::vector<PartLabel> labels;
  for (const PartRecord& part : understanding.record.parts) labels.push_back(part.label);
  understanding.scene = keep_edits(proposed.scene, labels, edits);
  if (understanding.scene.parts.empty()) return understanding;
  if (Status status = validate(understanding.scene); !status) return status.error();
  return understanding;
}

}  // namespace relievo::understanding
