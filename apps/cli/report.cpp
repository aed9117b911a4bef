#include "apps/cli/report.h"

#include <nlohmann/json.hpp>

namespace relievo::cli {
namespace {

using Json = nlohmann::ordered_json;
using understanding::Proposal;

/// The names of SolveStatus, in its order.
constexpr const char* status_names[] = {"solved", "iteration_limit", "not_positive_definite",
                                        "interrupted"};

Json parts(const Scene& scene, const relief::LayeredMesh& mesh) {
  std::vector<size_t> faces(scene.parts.size());
  for (const int part : mesh.face_part) ++faces[part];
  Json list = Json::array();
  for (size_t i = 0; i < scene.parts.size(); ++i)
    list.push_back({{"id", scene.parts[i].id},
                    {"c", scene.parts[i].c},
                    {"d", scene.parts[i].d},
                    {"flat", scene.parts[i].flat},
                    {"lean", {scene.parts[i].lean.x, scene.parts[i].lean.y}},
                    {"faces", faces[i]}});
  return list;
}

Json solver(const BoundQpReport& report) {
  return {{"status", status_names[static_cast<int>(report.status)]},
          {"iterations", report.iterations},
          {"stationarity", report.stationarity},
          {"primal", report.primal},
          {"dual", report.dual},
          {"complementarity", report.complementarity},
          {"energy", report.energy}};
}

Json findings(const std::vector<PrintFinding>& print) {
  Json list = Json::array();
  for (const PrintFinding& finding : print)
    list.push_back(
        {{"trouble", name(finding.trouble)}, {"part", finding.part}, {"measure", finding.measure}});
  return list;
}

Json energies(const relief::NonlinearEnergy& energy) {
  return {{"total", energy.total()},
          {"inflation", energy.inflation},
          {"boundary", energy.boundary},
          {"shift", energy.shift}};
}

Json nonlinear_json(const relief::NonlinearReport& report,
                    const relief::NonlinearOptions& options) {
  Json steps = Json::array();
  for (const relief::NonlinearStep& step : report.steps)
    steps.push_back({{"energy", energies(step.energy)},
                     {"residual", step.residual},
                     {"factorisations", step.factorisations},
                     {"ms", step.milliseconds}});
  return {{"status", report.status == SolveStatus::solved ? "solved" : "iteration_limit"},
          {"lambda_bnd", options.lambda_bnd},
          {"lambda_shift", options.lambda_shift},
          {"iterations", report.steps.size()},
          {"residual", report.residual},
          {"energy", energies(report.energy)},
          {"steps", steps}};
}

/// Sums the milliseconds by stage. The stages of docs/report.md come first, with 0 if they did not
/// run.
Json times(const ReportInput& input) {
  Json sums;
  for (const char* stage :
       {"read", "mesh", "assemble", "analyse", "inflate", "order", "nonlinear", "export", "total"})
    sums[stage] = 0.0;
  for (const std::vector<relief::StageTime>* list : {&input.relief.times, &input.times})
    for (const relief::StageTime& time : *list)
      if (!time.beside) sums[time.stage] = sums.value(time.stage, 0.0) + time.milliseconds;
  return sums;
}

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

std::string dumped(const Json& report) {
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string write_report(const ReportInput& input) {
  const relief::LayeredMesh& mesh = input.relief.layers;
  const relief::Ordering& ordering = input.relief.ordering;
  Json report;
  report["version"] = RELIEVO_VERSION;
  report["input"] = input.name;
  const bool nonlinear = !input.relief.nonlinear.steps.empty();
  report["method"] = nonlinear ? "nonlinear" : "approximate";
  report["vertices"] = mesh.node_vertex.size();
  report["faces"] = mesh.faces.size();
  report["parts"] = parts(input.scene, mesh);
  report["constraints"] = {{"equalities", ordering.equalities},
                           {"inequalities", ordering.inequalities},
                           {"active", ordering.report.active}};
  report["solver"] = solver(ordering.report);
  if (nonlinear) report["nonlinear"] = nonlinear_json(input.relief.nonlinear, input.options);
  report["max_violation"] = ordering.max_violation;
  report["overlap_violation"] = {{"samples", input.relief.ordering.overlap_samples},
                                 {"worst", input.relief.ordering.overlap_worst}};
  if (input.model != nullptr)
    report["model"] = {{"vertices", input.model->positions.size()},
                       {"faces", input.model->triangles.size()}};
  if (input.solid)
    report["solid"] = {{"volume_mm3", input.solid->volume},
                       {"pieces", input.solid->pieces},
                       {"loose", input.solid->loose},
                       {"print", findings(input.print)}};
  report["timings_ms"] = times(input);
  report["warnings"] = input.warnings;
  return dumped(report);
}

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
  return dumped(report);
}

}  // namespace relievo::cli
