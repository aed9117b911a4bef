#include "io/layered/merged_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "kernel/image/compose.h"

namespace relievo {
namespace {

/// Largest share of the painted pixels that may be painted in one of the pictures alone.
constexpr double most_beside = 0.04;
/// Largest share of the painted pixels that may have other colours.
constexpr double most_other = 0.02;
/// Least difference of a channel by which colours differ, of 255.
constexpr int other_color = 32;

bool same_on_paper(const uint8_t* p, const uint8_t* q) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(on_paper(p[k], p[3]) - on_paper(q[k], q[3])) > other_color) return false;
  return true;
}

/// Shares of the pixels that are painted in one of two pictures.
struct Difference {
  double beside = 0;  ///< painted in one of them alone
  double other = 0;   ///< painted in both, in different colours
};

/// An opaque merged picture does not tell paper from paint: it is painted where it is not white.
Difference difference_of(const Image8& layers, const Image8& merged) {
  const bool opaque = least_alpha(merged) == 255;
  const uint8_t white[4] = {255, 255, 255, 255};
  double painted = 0;
  Difference difference;
  for (size_t i = 0; i < layers.pixels.size(); i += 4) {
    const uint8_t* p = &layers.pixels[i];
    const uint8_t* q = &merged.pixels[i];
    const bool same = same_on_paper(p, q);
    const bool below = p[3] >= 128;
    const bool above = opaque ? !same_on_paper(q, white) || (below && same) : q[3] >= 128;
    painted += below || above ? 1 : 0;
    difference.beside += below != above ? 1 : 0;
    difference.other += below && above && !same ? 1 : 0;
  }
  painted = std::max(painted, 1.0);
  return {difference.beside / painted, difference.other / painted};
}

/// Takes the white paper out of an opaque picture where the other one is transparent.
void take_alpha(Image8& opaque, const Image8& other) {
  for (size_t i = 0; i < opaque.pixels.size(); i += 4) {
    const double alpha = other.pixels[i + 3] / 255.0;
    for (size_t k = 0; k < 3 && alpha > 0; ++k)
      opaque.pixels[i + k] = off_paper(opaque.pixels[i + k], alpha);
    opaque.pixels[i + 3] = other.pixels[i + 3];
  }
}

}  // namespace

bool is_blank(const Image8& rgba) {
  for (size_t i = 4; i < rgba.pixels.size(); ++i)
    if (rgba.pixels[i] != rgba.pixels[i - 4]) return false;
  return true;
}

void take_merged(understanding::LayeredDrawing& drawing, Image8 merged, const std::string& reason) {
  drawing.marks.clear();
  drawing.scene.parts.clear();
  drawing.colors.clear();
  drawing.picture.rgba = std::move(merged);
  drawing.flat = true;
  drawing.warnings = {reason + ": the parts are found in the merged picture that the file holds"};
}

bool compare_with_merged(understanding::LayeredDrawing& drawing, Image8 merged) {
  const Difference difference = difference_of(drawing.picture.rgba, merged);
  if (difference.beside > most_beside) {
    take_merged(drawing, std::move(merged), "the layers alone do not show the drawing");
    return true;
  }
  if (difference.other <= most_other) return false;
  if (least_alpha(merged) == 255) take_alpha(merged, drawing.picture.rgba);
  drawing.picture.rgba = std::move(merged);
  drawing.warnings.emplace_back(
      "the layers alone do not have the drawing's colours: these are taken from the merged picture "
      "that the file holds");
  return true;
}

}  // namespace relievo
