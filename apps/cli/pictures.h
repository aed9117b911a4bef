#pragma once

#include <string>

#include "apps/cli/arguments.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::cli {

/// A picture of a model as a PNG file, as the arguments describe it.
Result<Bytes> draw_picture(const Model& model, const Drawing& drawing,
                           const RenderArguments& arguments, const RunContext& context);

}  // namespace relievo::cli
