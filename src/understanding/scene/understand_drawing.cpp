#include "understanding/scene/understand_drawing.h"

#include <utility>

#include "understanding/scene/keep_edits.h"

namespace relievo::understanding {
namespace {

/// Replaces the proposal that a record keeps.
void record_proposal(const Proposal& proposal, SegmentationRecord& record) {
  const std::vector<PartLabel>& labels = proposal.regions.labels;
  record.parts.clear();
  for (size_t part = 0; part < labels.size(); ++part)
    record.parts.push_back(
        {labels[part], proposal.scene.parts[part].id, proposal.completion[part].kind});
  record.order = proposal.order;
  record.joins.clear();
  for (const auto& [join, confidence, user] : proposal.joining.joins)
    record.joins.push_back({labels[join.upper], labels[join.lower], confidence});
}

}  // namespace

Result<Understanding> understand_drawing(const Image8& rgba, Segmentation segmentation,
                                         SegmentationRecord known, const Scene& edited,
                                         const RunContext& context) {
  if (!segmentation.labels.empty()) relabel(segmentation, known);
  DrawingEvidence evidence = measure_evidence(rgba, known.labels, segmentation.front);
  auto proposed = propose_scene(known.labels, known.corrections, evidence, context);
  if (!proposed) return proposed.error();
  Proposal& proposal = *proposed;
  avoid_drawn_names(edited, known, proposal.scene);
  Scene scene = keep_edits(proposal.scene, proposal.regions.labels, edited, known);
  if (!scene.parts.empty())
    if (Status status = validate(scene); !status) return status.error();
  record_proposal(proposal, known);
  std::vector<std::string> warnings = segmentation.notes;
  warnings.insert(warnings.end(), proposal.warnings.begin(), proposal.warnings.end());
  return Understanding{std::move(segmentation), std::move(evidence), std::move(proposal),
                       std::move(known),        std::move(scene),    std::move(warnings)};
}

}  // namespace relievo::understanding
