#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/session/build_relief.h"
#include "solid/check_print.h"
#include "solid/make_solid.h"
#include "understanding/scene/propose_scene.h"

namespace relievo::cli {

/// The contents of a report.
struct ReportInput {
  std::string name;  ///< of the input
  const Scene& scene;
  const relief::Relief& relief;
  const relief::NonlinearOptions& options;
  const Model* model = nullptr;  ///< null if none was made
  std::optional<SolidFacts> solid;
  std::vector<PrintFinding> print;       ///< weak spots of the solid
  std::vector<relief::StageTime> times;  ///< of the program: "read", "export", "total"
  std::vector<std::string> warnings;
};

/// Formats the report as JSON, with keys in a fixed order. docs/report.md describes it.
std::string write_report(const ReportInput& input);

/// Formats the report of `relievo segment` as JSON: the parts and how they were completed, the
/// depth order and the joins with their confidence, relations, tilts, times and warnings.
std::string write_segment_report(const std::string& input, const understanding::Proposal& proposal,
                                 double milliseconds);

}  // namespace relievo::cli
