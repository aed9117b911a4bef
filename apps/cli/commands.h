#pragma once

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Each command prints its results on standard output and warnings on standard error; its error
/// is printed by the caller. Where it fails, nothing has been written.
Status run_build(const BuildArguments& build, Interruption& interruption);
Status run_check(const CheckArguments& check, Interruption& interruption);
Status run_compare(const CompareArguments& compare, Interruption& interruption);
Status run_segment(const SegmentArguments& segment, Interruption& interruption);
Status run_sequence(const SequenceArguments& sequence, Interruption& interruption);
Status run_render(const RenderArguments& render, Interruption& interruption);

/// Goes on where drawings fail. The exit code: that of the worst failure, 0 where all are built.
Result<int> run_batch(const BatchArguments& batch, Interruption& interruption);

}  // namespace relievo::cli
