#include "apps/cli/segment_report.h"

#include <nlohmann/json.hpp>

namespace relievo::cli {
namespace {

using Json = nlohmann::ordered_json;

class ReportWriter {
 public:
  explicit ReportWriter(const understanding::Proposal& proposal) : proposal_(proposal) {}

  Json parts() const {
    Json list = Json::array();
    for (int part = 0; part < proposal_.regions.count(); ++part) {
      const understanding::CompletedPart& completed = proposal_.completion[part];
      list.push_back({{"id", id(part)},
                      {"label", proposal_.regions.labels[part]},
                      {"visible_px", pixel_count(proposal_.regions.visible[part])},
                      {"completed_px", pixel_count(completed.shape)},
                      {"completion", name(completed.kind)}});
    }
    return list;
  }

  Json order() const {
    Json list = Json::array();
    for (const understanding::OrderArrow& arrow : proposal_.order)
      list.push_back({{"upper", id(proposal_.regions.part_of(arrow.upper))},
                      {"lower", id(proposal_.regions.part_of(arrow.lower))},
                      {"confidence", arrow.confidence},
                      {"source", arrow.user ? "user" : "guess"},
                      {"kept", arrow.kept}});
    return list;
  }

  Json joins() const {
    Json list = Json::array();
    for (const understanding::ProposedJoin& join : proposal_.joining.joins)
      list.push_back({{"upper", id(join.join.upper)},
                      {"lower", id(join.join.lower)},
                      {"confidence", join.confidence},
                      {"source", join.user ? "user" : "guess"}});
    return list;
  }

  Json relations() const {
    Json list = Json::array();
    for (const understanding::ProposedRelation& relation : proposal_.joining.relations)
      list.push_back({{"upper", id(relation.relation.upper)},
                      {"lower", id(relation.relation.lower)},
                      {"relation", name(relation.relation.kind)},
                      {"source", relation.user ? "user" : "guess"}});
    return list;
  }

  Json leans() const {
    Json list = Json::array();
    for (const understanding::ProposedLean& lean : proposal_.joining.leans)
      list.push_back({{"part", id(lean.part)},
                      {"lean", {lean.lean.x, lean.lean.y}},
                      {"confidence", lean.confidence}});
    return list;
  }

 private:
  const std::string& id(int part) const { return proposal_.scene.parts[part].id; }

  const understanding::Proposal& proposal_;
};

}  // namespace

std::string write_segment_report(const std::string& input, const understanding::Proposal& proposal,
                                 double milliseconds) {
  const ReportWriter writer(proposal);
  Json report;
  report["version"] = RELIEVO_VERSION;
  report["input"] = input;
  report["parts"] = writer.parts();
  report["order"] = writer.order();
  report["joins"] = writer.joins();
  report["relations"] = writer.relations();
  report["leans"] = writer.leans();
  report["timings_ms"] = {{"propose", milliseconds}};
  report["warnings"] = proposal.warnings;
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace relievo::cli
