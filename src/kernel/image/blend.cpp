#include "kernel/image/blend.h"

#include <algorithm>
#include <cmath>

#include "kernel/image/compose.h"

namespace relievo {
namespace {

double burn(double b, double s) {
  if (b >= 1) return 1;
  return s <= 0 ? 0 : 1 - std::min(1.0, (1 - b) / s);
}

double dodge(double b, double s) {
  if (b <= 0) return 0;
  return s >= 1 ? 1 : std::min(1.0, b / (1 - s));
}

double hard(double b, double s) { return s <= 0.5 ? 2 * b * s : 1 - 2 * (1 - b) * (1 - s); }

double soft(double b, double s) {
  if (s <= 0.5) return b - (1 - 2 * s) * b * (1 - b);
  const double d = b <= 0.25 ? ((16 * b - 12) * b + 4) * b : std::sqrt(b);
  return b + (2 * s - 1) * (d - b);
}

/// Blends one channel of a mode that treats the channels alike; `b` lies below `s`.
double blend_channel(BlendMode mode, double b, double s) {
  if (mode == BlendMode::multiply) return b * s;
  if (mode == BlendMode::screen) return b + s - b * s;
  if (mode == BlendMode::overlay) return hard(s, b);
  if (mode == BlendMode::darken) return std::min(b, s);
  if (mode == BlendMode::lighten) return std::max(b, s);
  if (mode == BlendMode::color_dodge) return dodge(b, s);
  if (mode == BlendMode::color_burn) return burn(b, s);
  if (mode == BlendMode::hard_light) return hard(b, s);
  if (mode == BlendMode::soft_light) return soft(b, s);
  if (mode == BlendMode::difference) return std::abs(b - s);
  if (mode == BlendMode::exclusion) return b + s - 2 * b * s;
  if (mode == BlendMode::add) return std::min(1.0, b + s);
  if (mode == BlendMode::linear_burn) return std::max(0.0, b + s - 1);
  if (mode == BlendMode::subtract) return std::max(0.0, b - s);
  if (mode == BlendMode::divide) return s <= 0 ? 1 : std::min(1.0, b / s);
  if (mode == BlendMode::vivid_light) return s <= 0.5 ? burn(b, 2 * s) : dodge(b, 2 * s - 1);
  if (mode == BlendMode::linear_light) return std::clamp(b + 2 * s - 1, 0.0, 1.0);
  if (mode == BlendMode::pin_light) return std::clamp(b, 2 * s - 1, 2 * s);
  return s;
}

double light(const Rgb& c) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; }
double least(const Rgb& c) { return std::min({c[0], c[1], c[2]}); }
double most(const Rgb& c) { return std::max({c[0], c[1], c[2]}); }
double saturation(const Rgb& c) { return most(c) - least(c); }

/// Moves the colour to this lightness, and towards grey where it would leave [0, 1].
Rgb with_light(Rgb c, double lightness) {
  const double shift = lightness - light(c);
  for (double& v : c) v += shift;
  const double low = least(c);
  const double high = most(c);
  for (double& v : c) {
    if (low < 0) v = lightness + (v - lightness) * lightness / (lightness - low);
    if (high > 1) v = lightness + (v - lightness) * (1 - lightness) / (high - lightness);
  }
  return c;
}

Rgb with_saturation(Rgb c, double wanted) {
  const double low = least(c);
  const double range = saturation(c);
  for (double& v : c) v = range > 0 ? (v - low) * wanted / range : 0;
  return c;
}

/// Returns whether black leaves what lies below as it is.
bool black_is_neutral(BlendMode mode) {
  return mode == BlendMode::screen || mode == BlendMode::lighten ||
         mode == BlendMode::color_dodge || mode == BlendMode::difference ||
         mode == BlendMode::exclusion || mode == BlendMode::add || mode == BlendMode::subtract;
}

/// Colour times alpha, and alpha.
struct Premultiplied {
  Rgb color = {};
  double alpha = 0;
};

/// Returns what a pixel shows where nothing lies below it. On a page of the neutral colour it looks
/// as it is.
Premultiplied alone(BlendMode mode, const Rgb& c, double alpha) {
  if (white_is_neutral(mode)) {
    const double white = least(c);
    return {{alpha * (c[0] - white), alpha * (c[1] - white), alpha * (c[2] - white)},
            alpha * (1 - white)};
  }
  const double shown = black_is_neutral(mode) ? most(c) : 1;
  return {{alpha * c[0], alpha * c[1], alpha * c[2]}, alpha * shown};
}

Premultiplied scaled(const Rgb& c, double alpha) {
  return {{c[0] * alpha, c[1] * alpha, c[2] * alpha}, alpha};
}

Premultiplied operator+(const Premultiplied& p, const Premultiplied& q) {
  return {{p.color[0] + q.color[0], p.color[1] + q.color[1], p.color[2] + q.color[2]},
          p.alpha + q.alpha};
}

Premultiplied covered(const Rgb& below, double b, const Rgb& above, double s, Blending blending) {
  const Rgb mixed = b > 0 && s > 0 ? blend(blending.mode, below, above) : above;
  const Premultiplied on_it = scaled(mixed, s * b) + scaled(below, (1 - s) * b);
  Premultiplied beside = alone(blending.mode, above, s);
  for (double& v : beside.color) v *= 1 - b;
  beside.alpha *= 1 - b;
  if (blending.cover == CoverMode::atop) return on_it;
  if (blending.cover == CoverMode::source_in) return scaled(mixed, s * b);
  if (blending.cover == CoverMode::below_in) return scaled(below, s * b);
  if (blending.cover == CoverMode::below_out) return scaled(below, (1 - s) * b);
  if (blending.cover == CoverMode::below_atop) return scaled(below, s * b) + beside;
  return on_it + beside;
}

Rgb rgb_of(const uint8_t* p) { return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0}; }

}  // namespace

Rgb blend(BlendMode mode, const Rgb& below, const Rgb& above) {
  if (mode == BlendMode::hue)
    return with_light(with_saturation(above, saturation(below)), light(below));
  if (mode == BlendMode::saturation)
    return with_light(with_saturation(below, saturation(above)), light(below));
  if (mode == BlendMode::color) return with_light(above, light(below));
  if (mode == BlendMode::luminosity) return with_light(below, light(above));
  return {blend_channel(mode, below[0], above[0]), blend_channel(mode, below[1], above[1]),
          blend_channel(mode, below[2], above[2])};
}

bool white_is_neutral(BlendMode mode) {
  return mode == BlendMode::multiply || mode == BlendMode::darken ||
         mode == BlendMode::color_burn || mode == BlendMode::linear_burn ||
         mode == BlendMode::divide;
}

void blend_over(uint8_t* below, const uint8_t* above, double opacity, Blending blending) {
  if (blending.is_plain()) return lay_over(below, above, opacity);
  const Premultiplied result =
      covered(rgb_of(below), below[3] / 255.0, rgb_of(above), opacity * above[3] / 255, blending);
  for (size_t k = 0; k < 3; ++k)
    below[k] = result.alpha > 0 ? static_cast<uint8_t>(std::lround(
                                      255 * std::clamp(result.color[k] / result.alpha, 0.0, 1.0)))
                                : 0;
  below[3] = static_cast<uint8_t>(std::lround(255 * std::clamp(result.alpha, 0.0, 1.0)));
}

double alpha_alone(const uint8_t* rgba, BlendMode mode) {
  return 255 * alone(mode, rgb_of(rgba), rgba[3] / 255.0).alpha;
}

}  // namespace relievo
