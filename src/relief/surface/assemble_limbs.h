#pragma once

#include <string>
#include <vector>

#include "relief/surface/surface_sample.h"
#include "relief/surface/visible_sheet.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// Assembles the limbs named in `ids`: parts that are joined to a part behind them. Fails with
/// usage, naming the part, if there is no part of that name, it is joined to no part behind it or
/// lies in the middle of that part; otherwise as assemble_visible_sheet. Near-linear for each limb.
Result<std::vector<LimbSheet>> assemble_limbs(const SolvedSurface& surface,
                                              const std::vector<std::string>& ids,
                                              const RunContext& context = {});

}  // namespace relievo::relief
