#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/session/build_relief.h"
#include "solid/check_print.h"
#include "solid/make_solid.h"

namespace relievo::cli {

struct ReportInput {
  std::string name;  ///< of the input
  const Scene& scene;
  const relief::Relief& relief;
  const relief::NonlinearOptions& options;  ///< of the non-linear method
  const Model* model = nullptr;             ///< where one was made
  std::optional<SolidFacts> solid;
  std::vector<PrintFinding> print;       ///< what is wrong with the solid
  std::vector<relief::StageTime> times;  ///< of the program: "read", "export", "total"
  std::vector<std::string> warnings;
};

/// The report as JSON text, keys in a fixed order; described in docs/report.md.
std::string write_report(const ReportInput& input);

}  // namespace relievo::cli
