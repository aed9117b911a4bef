#pragma once

#include "apps/cli/arguments.h"
#include "relievo/image.h"

namespace relievo::cli {

/// Applies --pixel-art, where it is given, to a drawing that was read.
void settle_pixel_art(const CommonArguments& common, Drawing& drawing);

}  // namespace relievo::cli
