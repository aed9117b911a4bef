#include "relief/finish/take_off_ink.h"

#include "kernel/image/distance_transform.h"
#include "relief/finish/cover_ink.h"
#include "relief/finish/extend_paint.h"
#include "relief/finish/fill_triangle.h"
#include "relief/finish/ink_mask.h"

namespace relievo::relief {
namespace {

constexpr int reach = 6;  ///< px beside contours where the paint is settled

}  // namespace

void take_off_ink(const Model& model, const ContourInk& ink, Image8& rgba) {
  const Image8 mask = ink_mask(ink, model, rgba);
  const Image8 near = pixels_within(mask, reach);
  cover_ink(front_parts(model, {rgba.width, rgba.height}), mask, near, rgba);
  extend_paint(model, near, rgba);
}

}  // namespace relievo::relief
