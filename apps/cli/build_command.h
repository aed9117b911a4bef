#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Each command prints its results on standard output and warnings on standard error; its error
/// is printed by the caller. Where it fails, nothing has been written.
Status run_build(const BuildArguments& build, Interruption& interruption);

}  // namespace relievo::cli
