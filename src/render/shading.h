#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "relievo/image.h"
#include "relievo/point.h"
#include "relievo/render.h"

namespace relievo {

/// An orthographic camera. The axes are unit, in model space.
struct Camera {
  Point3 right{1, 0, 0};
  Point3 up{0, 1, 0};
  Point3 back{0, 0, 1};  ///< towards the viewer
  Point3 centre;         ///< the point of model space in the middle of the picture
  double unit = 1;       ///< model px per picture px
  double distance = 1;   ///< from the centre to the origins of rays, outside the model
  int width = 1;         ///< of the picture, px
  int height = 1;
};

/// Converts a vector from the camera's axes to model space.
inline Point3 from_camera(const Camera& camera, Point3 v) {
  return v.x * camera.right + v.y * camera.up + v.z * camera.back;
}

/// A colour in linear light; 1 is the white of the picture.
struct Rgb {
  double r = 0;
  double g = 0;
  double b = 0;
};

inline Rgb operator+(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }

inline Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }

inline Rgb operator*(double s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }

inline Rgb mix(Rgb a, Rgb b, double t) { return (1 - t) * a + t * b; }

/// Converts from sRGB to linear light, on [0, 1].
inline double to_linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

/// Converts from linear light to sRGB, on [0, 1].
inline double to_srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// An orthonormal basis around a unit vector.
struct AxisFrame {
  Point3 first;
  Point3 second;
  Point3 axis;
};

/// Returns a frame with the given unit axis.
AxisFrame frame_around(Point3 axis);

/// The lights of a picture. Directions are unit, in model space.
struct LightRig {
  AxisFrame key;       ///< its axis points to the middle of the key light
  double key_tangent;  ///< tangent of its angular radius
  Rgb key_light;       ///< light on a surface that faces it
  Point3 up;
  Rgb sky;     ///< light from above
  Rgb ground;  ///< light from below
  Point3 rim;  ///< direction to a broad glow behind the model, which sets it off the background
  Rgb rim_light;
  double gloss;  ///< strength of the highlight
};

/// Returns a key light with soft fill for clay, and more even, neutral light for a drawing, under
/// which a surface that faces the viewer keeps its colour.
LightRig light_rig(const RenderOptions& options, const Camera& camera);

/// Returns a direction to the key light; `square` is a point of the unit square.
Point3 key_direction(const LightRig& rig, Point2 square);

/// Returns a direction above a surface, distributed with the cosine to its normal, the frame's
/// axis.
Point3 ambient_direction(const AxisFrame& surface, Point2 square);

/// Returns the unoccluded light from a direction.
Rgb surroundings(const LightRig& rig, Point3 direction);

/// Returns the highlight of a surface under the key light.
double highlight(const LightRig& rig, Point3 normal, Point3 to_light, Point3 to_viewer);

/// Keeps values below 0.7 and bends larger ones smoothly towards 1.
Rgb tone_curve(Rgb colour);

/// Colours of an opaque RGB image between its pixels, in linear light.
class TextureSampler {
 public:
  /// Halves the image while it has more than `max_width` columns by a factor of 2 or more, so that
  /// a picture smaller than the texture does not flicker between its pixels. Keeps the pixels of an
  /// image that is not `smooth`.
  TextureSampler(Image8 rgb, double max_width, bool smooth);

  /// Returns the colour at `uv` in [0, 1]^2, origin top-left; outside, that of the border. Between
  /// the pixels of an image that is not smooth it is that of the nearest.
  Rgb at(Point2 uv) const;

 private:
  Rgb pixel(int x, int y) const;

  Image8 rgb_;
  bool smooth_;
  std::array<double, 256> linear_;
};

/// Hashes three numbers.
inline uint32_t hash(uint32_t a, uint32_t b, uint32_t c) {
  uint32_t h = a * 0x9e3779b1U ^ (b + 0x7f4a7c15U) * 0x85ebca77U ^ (c + 0x165667b1U) * 0xc2b2ae3dU;
  h ^= h >> 16;
  h *= 0x7feb352dU;
  h ^= h >> 15;
  h *= 0x846ca68bU;
  return h ^ h >> 16;
}

/// Returns point i of the additive recurrence over the plastic number (M. Roberts, 2018), in
/// fixed-point numbers that wrap: any run of it fills the unit square evenly.
inline Point2 even_point(uint32_t i) {
  return {(i * 3242174889U + 0x80000000U) * 0x1p-32, (i * 2447445414U + 0x80000000U) * 0x1p-32};
}

/// Returns the place of a pixel on a curve that visits every block of 2^k x 2^k pixels in one go,
/// each in an order of its own; x, y < 16384. Pixels that take their samples from consecutive runs
/// of one sequence in this order have errors that cancel between neighbours, which looks like fine,
/// even grain (A. Ahmed, P. Wonka: Screen-space blue-noise diffusion of Monte Carlo sampling error
/// via hierarchical ordering of pixels, 2020). `seed` gives another curve.
inline uint32_t block_order(uint32_t x, uint32_t y, uint32_t seed) {
  uint32_t order = 0;
  for (int level = 13; level >= 0; --level) {
    const uint32_t quarter = (x >> level & 1) | (y >> level & 1) << 1;
    const uint32_t turn = hash(x >> (level + 1), y >> (level + 1), seed + level) & 3;
    order = order << 2 | (quarter ^ turn);
  }
  return order;
}

}  // namespace relievo
