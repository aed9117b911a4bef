#include "face/read_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "face/inputs.h"
#include "io/files/number_text.h"
#include "io/image/decode_image.h"
#include "understanding/labels/segment_drawing.h"
#include "understanding/scene/understand_drawing.h"

namespace relievo {
namespace {

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

/// Summarises what was found.
std::string summary(const Image16& labels, const Scene& scene) {
  const auto background = std::count(labels.pixels.begin(), labels.pixels.end(), 0);
  const double covered =
      1 - static_cast<double>(background) / static_cast<double>(labels.pixels.size());
  return "the picture was understood as " + counted(scene.parts.size(), "part") + " with " +
         counted(scene.joins.size(), "join") + "; they cover " + percent(covered) + " of it";
}

/// Names the most doubtful decision, and the ways to correct it.
std::string advice(const understanding::Proposal& proposal, const std::string& file) {
  const std::vector<understanding::OrderArrow>& arrows = proposal.stacking.arrows;
  const auto doubtful =
      std::min_element(arrows.begin(), arrows.end(),
                       [](const understanding::OrderArrow& a, const understanding::OrderArrow& b) {
                         return a.confidence < b.confidence;
                       });
  const auto id = [&](int part) { return proposal.scene.parts[proposal.stacking.rank[part]].id; };
  const std::string doubt = doubtful == arrows.end()
                                ? ""
                                : "the most doubtful decision is that " + id(doubtful->upper) +
                                      " lies before " + id(doubtful->lower) + " (" +
                                      percent((1 + doubtful->confidence) / 2) + "); ";
  return doubt + "look with --overlay, correct with strokes: relievo segment " + file +
         " --scribbles strokes.png, or in the editor";
}

understanding::JoinProposals by_rank(understanding::JoinProposals joining,
                                     const std::vector<int>& rank) {
  const auto renumber = [&](auto& item) {
    item.upper = rank[item.upper];
    item.lower = rank[item.lower];
  };
  for (understanding::ProposedJoin& proposed : joining.joins) renumber(proposed.join);
  for (understanding::ProposedRelation& proposed : joining.relations) renumber(proposed.relation);
  for (RobinRange& range : joining.robin) renumber(range);
  for (understanding::ProposedLean& proposed : joining.leans) proposed.part = rank[proposed.part];
  return joining;
}

}  // namespace

Result<SceneInput> understand_flat(Drawing drawing, const std::string& file, bool connect,
                                   const RunContext& context) {
  auto found = understanding::segment_drawing(drawing, {}, context);
  if (!found) return found.error();
  const understanding::SegmentationRecord record = understanding::relabel(*found, {}).record;
  auto understood = understanding::understand_drawing(drawing.rgba, record, {}, {}, context);
  if (!understood) return understood.error();
  understanding::Proposal& proposal = understood->proposal;
  SceneInput loaded{std::move(understood->scene), std::move(drawing)};
  loaded.drawing_file = file;
  loaded.proposed = true;
  loaded.understood = {summary(record.labels, loaded.scene), advice(proposal, file)};
  loaded.warnings = std::move(found->notes);
  for (std::string& warning : proposal.warnings) loaded.warnings.push_back(std::move(warning));
  if (connect) {
    loaded.guesses = by_rank(std::move(proposal.joining), proposal.stacking.rank);
  } else {
    loaded.scene.joins.clear();
    loaded.scene.relations.clear();
    loaded.scene.robin.clear();
  }
  return loaded;
}

Result<SceneInput> read_picture(const InputFile& input, bool connect, const RunContext& context) {
  auto pixels = decode_image(input.bytes);
  if (!pixels) return pixels.error();
  return understand_flat({std::move(*pixels)}, input.name, connect, context);
}

}  // namespace relievo
