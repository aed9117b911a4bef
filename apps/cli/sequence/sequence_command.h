#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/result.h"

namespace relievo::cli {

Status run_sequence(const SequenceArguments& sequence, Interruption& interruption);

}  // namespace relievo::cli
