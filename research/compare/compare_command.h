#pragma once

#include "apps/cli/interruption.h"
#include "relievo/result.h"
#include "research/compare/compare_arguments.h"

namespace relievo::research {

/// Reconstructs a drawing by a rival, and writes the outputs that are asked for.
Status run_compare(const CompareArguments& compare, cli::Interruption& interruption);

}  // namespace relievo::research
