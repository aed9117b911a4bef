#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/session/build_relief.h"
#include "solid/check_print.h"
#include "solid/make_solid.h"

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

}  // namespace relievo::cli
