#include "apps/cli/segment_report.h"

#include <nlohmann/json.hpp>

namespace relievo::cli {
namespace {

using Json = nlohmann::ordered_json;
using understanding::Proposal;

/// The id of a part.
const std::string& id(const Proposal& proposal, int part) { return proposal.scene.parts[part].id; }

Json parts(const Proposal& proposal) {
  Json list = Json::array();
  for (int part = 0; part < proposal.regions.count(); ++part) {
    const understanding::CompletedPart& completed = proposal.completion[part];
    list.push_back({{"id", id(proposal, part)},
                    {"label", proposal.regions.labels[part]},
                    {"visible_px", pixel_count(proposal.regions.visible[part])},
                    {"completed_px", pixel_count(completed.shape)},
                    {"completion", name(completed.kind)}});
  }
  return list;
}

Json order(const Proposal& proposal) {
  Json list = Json::array();
  for (const understanding::OrderArrow& arrow : proposal.order)
    list.push_back({{"upper", id(proposal, proposal.regions.part_of(arrow.upper))},
                    {"lower", id(proposal, proposal.regions.part_of(arrow.lower))},
                    {"confidence", arrow.confidence},
                    {"source", arrow.user ? "user" : "guess"},
                    {"kept", arrow.kept}});
  return list;
}

Json joins(const Proposal& proposal) {
  Json list = Json::array();
  for (const understanding::ProposedJoin& join : proposal.joining.joins)
    list.push_back({{"upper", id(proposal, join.join.upper)},
                    {"lower", id(proposal, join.join.lower)},
                    {"confidence", join.confidence},
                    {"source", join.user ? "user" : "guess"}});
  return list;
}

Json relations(const Proposal& proposal) {
  Json list = Json::array();
  for (const understanding::ProposedRelation& relation : proposal.joining.relations)
    list.push_back({{"upper", id(proposal, relation.relation.upper)},
                    {"lower", id(proposal, relation.relation.lower)},
                    {"relation", name(relation.relation.kind)},
                    {"source", relation.user ? "user" : "guess"}});
  return list;
}

Json leans(const Proposal& proposal) {
  Json list = Json::array();
  for (const understanding::ProposedLean& lean : proposal.joining.leans)
    list.push_back({{"part", id(proposal, lean.part)},
                    {"lean", {lean.lean.x, lean.lean.y}},
                    {"confidence", lean.confidence}});
  return list;
}

}  // namespace

std::string write_segment_report(const std::string& input, const understanding::Proposal& proposal,
                                 double milliseconds) {
  Json report;
  report["version"] = RELIEVO_VERSION;
  report["input"] = input;
  report["parts"] = parts(proposal);
  report["order"] = order(proposal);
  report["joins"] = joins(proposal);
  report["relations"] = relations(proposal);
  report["leans"] = leans(proposal);
  report["timings_ms"] = {{"propose", milliseconds}};
  report["warnings"] = proposal.warnings;
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace relievo::cli
