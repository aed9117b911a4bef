#include "apps/cli/report.h"

#include <nlohmann/json.hpp>

namespace relievo::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* name(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return "solved";
    case SolveStatus::iteration_limit:
      return "iteration_limit";
    case SolveStatus::not_positive_definite:
      return "not_positive_definite";
    case SolveStatus::interrupted:
      return "interrupted";
  }
  return "";
}

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
  return {{"status", name(report.status)},
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
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace relievo::cli
