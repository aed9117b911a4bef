#include "kernel/image/mask_pieces.h"

#include <algorithm>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/components.h"
#include "kernel/image/mask.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"

namespace relievo {
namespace {

constexpr double piece_share = 0.03;  ///< least area of a piece over that of the largest

}  // namespace

double share_of_box(const Image8& mask) {
  const Box2 box = box_of(mask);
  if (box.empty()) return 0;
  return static_cast<double>(pixel_count(mask)) /
         ((box.max.x - box.min.x) * (box.max.y - box.min.y));
}

Image8 without_small_pieces(const Image8& mask) {
  const Components pieces = connected_components(mask, Connectivity::corners);
  if (pieces.areas.size() < 2) return mask;
  const auto largest =
      static_cast<double>(*std::max_element(pieces.areas.begin() + 1, pieces.areas.end()));
  Image8 result(mask.width, mask.height, 1);
  for (size_t i = 0; i < result.pixels.size(); ++i) {
    const int32_t piece = pieces.label.pixels[i];
    const bool large = static_cast<double>(pieces.areas[piece]) >= piece_share * largest;
    result.pixels[i] = piece != 0 && large ? 1 : 0;
  }
  return result;
}

Image8 without_holes(const Image8& mask) {
  const Components outside = connected_components(complement(mask), Connectivity::sides);
  const std::vector<uint8_t> reaches_edge = pieces_at_edge(outside);
  Image8 result(mask.width, mask.height, 1);
  for (size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = 1 - reaches_edge[outside.label.pixels[i]];
  return result;
}

}  // namespace relievo
