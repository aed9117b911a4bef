#include "apps/cli/pixel_art.h"

#include "relievo/pixel_art.h"

namespace relievo::cli {

void settle_pixel_art(const CommonArguments& common, Drawing& drawing) {
  if (common.pixel_art) drawing.pixel_art = own_pixels(drawing.rgba, common.pixel_art);
}

}  // namespace relievo::cli
