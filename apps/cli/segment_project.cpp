#include "apps/cli/segment_project.h"

#include <filesystem>

#include "io/project/record_proposal.h"

namespace relievo::cli {
namespace {

SegmentationRecord record_of(const SegmentInput& input, const Proposal& proposal) {
  SegmentationRecord record = record_proposal(proposal.regions, proposal.completion,
                                              proposal.stacking, proposal.joining, proposal.scene);
  record.labels = input.labels;
  record.scribbles = input.scribbles;
  record.corrections = input.corrections;
  return record;
}

}  // namespace

Project project_of(const SegmentInput& input, const Proposal& proposal, const Scene& scene) {
  Project project;
  project.name =
      input.name.empty() ? std::filesystem::path(input.drawing.name).stem().string() : input.name;
  project.drawing = input.drawing;
  project.segmentation = record_of(input, proposal);
  project.scene = scene;
  project.scene.drawing = "drawing";
  project.other_keys = input.other_keys;
  return project;
}

}  // namespace relievo::cli
