#pragma once

#include <array>
#include <cstdint>

namespace relievo {

/// Changes of the colours below a layer by its own, as "Compositing and Blending" of the W3C
/// defines it, and some further modes of painting programs.
enum class BlendMode {
  normal,
  multiply,
  screen,
  overlay,
  darken,
  lighten,
  color_dodge,
  color_burn,
  hard_light,
  soft_light,
  difference,
  exclusion,
  add,
  linear_burn,
  subtract,
  divide,
  vivid_light,
  linear_light,
  pin_light,
  hue,
  saturation,
  color,
  luminosity,
};

/// The parts of a layer and of its backdrop that are kept, as Porter and Duff define them.
enum class CoverMode {
  over,        ///< both
  atop,        ///< what lies below, with the layer on it
  source_in,   ///< the layer where something lies below
  below_in,    ///< what lies below the layer
  below_out,   ///< what does not lie below the layer
  below_atop,  ///< what lies below the layer, and the rest of the layer
};

/// The way in which a layer is laid on what lies below it.
struct Blending {
  BlendMode mode = BlendMode::normal;
  CoverMode cover = CoverMode::over;

  bool is_plain() const { return mode == BlendMode::normal && cover == CoverMode::over; }
};

/// Red, green and blue, in [0, 1].
using Rgb = std::array<double, 3>;

/// Computes the colour of an opaque layer on an opaque layer.
Rgb blend(BlendMode mode, const Rgb& below, const Rgb& above);

/// Returns whether white leaves what lies below as it is.
bool white_is_neutral(BlendMode mode);

/// Lays the RGBA pixel `above` on `below`, both with straight alpha. `opacity` in [0, 1] multiplies
/// the alpha of the one above. Where nothing lies below, white that only darkens and black that
/// only lightens are clear, so that a sheet of ink hides nothing and fills nothing.
void blend_over(uint8_t* below, const uint8_t* above, double opacity, Blending blending);

/// Computes the alpha that the pixel has where nothing lies below it (see blend_over), 0 to 255.
double alpha_alone(const uint8_t* rgba, BlendMode mode);

}  // namespace relievo
