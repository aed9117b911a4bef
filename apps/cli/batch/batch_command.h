#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Goes on where drawings fail. The exit code: that of the worst failure, 0 where all are built.
Result<int> run_batch(const BatchArguments& batch, Interruption& interruption);

}  // namespace relievo::cli
