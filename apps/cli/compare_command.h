#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/result.h"

namespace relievo::cli {

Status run_compare(const CompareArguments& compare, Interruption& interruption);

}  // namespace relievo::cli
