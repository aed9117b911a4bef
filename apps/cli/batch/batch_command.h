#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Builds a batch. Goes on if a drawing fails. Returns the exit code of the worst failure, or 0.
Result<int> run_batch(const BatchArguments& batch, Interruption& interruption);

}  // namespace relievo::cli
