#pragma once

#include <functional>

#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// Calls `work(row)` once for every row in [0, rows), on `threads` threads (as many as the machine
/// has when 0). Progress is reported from the calling thread alone. `interrupted` where the
/// context was cancelled; `work` should itself return early then.
Status run_rows(int rows, int threads, const RunContext& context,
                const std::function<void(int row)>& work);

}  // namespace relievo
