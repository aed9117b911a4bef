#include "relief/finish/take_off_ink.h"

#include "kernel/image/distance_transform.h"
#include "relief/finish/cover_ink.h"
#include "relief/finish/extend_paint.h"
#include "relief/finish/fill_triangle.h"
#include "relief/finish/ink_mask.h"

namespace relievo::relief {
namespace {

constexpr int reach = 6;  ///< px beside contours where the paint is settled

/// Returns 1 on the pixels near those of a mask.
Image8 near_to(const Image8& mask) {
  const Image<int32_t> away = squared_distance_to(mask);
  Image8 near(mask.width, mask.height, 1);
  for (size_t i = 0; i < near.pixels.size(); ++i)
    near.pixels[i] = away.pixels[i] <= reach * reach ? 1 : 0;
  return near;
}

}  // namespace

void take_off_ink(const Model& model, const ContourInk& ink, Image8& rgba) {
  const Image8 mask = ink_mask(ink, model, rgba);
  const Image8 near = near_to(mask);
  cover_ink(front_parts(model, {rgba.width, rgba.height}), mask, near, rgba);
  extend_paint(model, near, rgba);
}

}  // namespace relievo::relief
