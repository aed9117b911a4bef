#pragma once

#include <string>

#include "apps/cli/arguments.h"
#include "io/files/bytes.h"
#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/drawing/drawing.h"
#include "relief/model/model.h"

namespace relievo::cli {

/// A picture of a model as a PNG file, as the arguments describe it.
Result<Bytes> draw_picture(const Model& model, const Drawing& drawing,
                           const RenderArguments& arguments, const RunContext& context);

}  // namespace relievo::cli
