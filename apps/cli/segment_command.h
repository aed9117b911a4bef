#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/result.h"

namespace relievo::cli {

Status run_segment(const SegmentArguments& segment, Interruption& interruption);

}  // namespace relievo::cli
