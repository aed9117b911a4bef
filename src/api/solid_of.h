#pragma once

#include "relief/session/build_relief.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"
#include "relievo/solid.h"

namespace relievo {

/// Makes the solid of a relief, its drawing on it. Errors: those of assemble_limbs and make_solid.
Result<Solid> solid_of(const relief::Relief& relief, const Scene& scene, const Drawing& drawing,
                       const SolidOptions& options, const RunContext& context = {});

}  // namespace relievo
