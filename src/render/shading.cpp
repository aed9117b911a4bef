#include "render/shading.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace relievo {
namespace {

/// Maps the unit square to the unit disc; areas are kept.
Point2 disc_point(Point2 square) {
  const double radius = std::sqrt(square.x);
  const double angle = 2 * std::numbers::pi * square.y;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

double bend(double x) {
  constexpr double knee = 0.7;
  return x <= knee ? x : 1 - (1 - knee) * std::exp((knee - x) / (1 - knee));
}

std::array<double, 256> linear_values() {
  std::array<double, 256> values;
  for (size_t i = 0; i < values.size(); ++i) values[i] = to_linear(static_cast<double>(i) / 255);
  return values;
}

Image8 halved(const Image8& image, const std::array<double, 256>& linear) {
  Image8 half(std::max(1, image.width / 2), std::max(1, image.height / 2), image.channels);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < image.channels; ++c) {
        double sum = 0;
        for (int k = 0; k < 4; ++k)
          sum += linear[image.at(std::min(2 * x + k % 2, image.width - 1),
                                 std::min(2 * y + k / 2, image.height - 1), c)];
        half.at(x, y, c) = static_cast<uint8_t>(std::lround(255 * to_srgb(sum / 4)));
      }
  return half;
}

}  // namespace

AxisFrame frame_around(Point3 axis) {
  const Point3 other = std::abs(axis.x) < 0.7 ? Point3{1, 0, 0} : Point3{0, 1, 0};
  const Point3 first = normalized(cross(axis, other));
  return {first, cross(axis, first), axis};
}

LightRig light_rig(const RenderOptions& options, const Camera& camera) {
  LightRig rig = {};
  rig.key = frame_around(normalized(from_camera(camera, options.light)));
  rig.key_tangent = std::tan(options.light_radius * std::numbers::pi / 180);
  rig.up = camera.up;
  rig.rim = normalized(from_camera(camera, {0.75, 0.35, -0.55}));
  if (options.shading == Shading::clay) {
    rig.key_light = {1.0, 0.925, 0.83};
    rig.sky = {0.36, 0.385, 0.43};
    rig.ground = {0.12, 0.10, 0.085};
    rig.rim_light = {0.50, 0.54, 0.64};
    rig.gloss = 0.07;
  } else {
    rig.key_light = {0.72, 0.72, 0.72};
    rig.sky = {0.66, 0.66, 0.66};
    rig.ground = {0.42, 0.42, 0.42};
    rig.rim_light = {0.3, 0.3, 0.3};
    rig.gloss = 0.02;
  }
  return rig;
}

Point3 key_direction(const LightRig& rig, Point2 square) {
  const Point2 disc = rig.key_tangent * disc_point(square);
  return normalized(rig.key.axis + disc.x * rig.key.first + disc.y * rig.key.second);
}

Point3 ambient_direction(const AxisFrame& surface, Point2 square) {
  const Point2 disc = disc_point(square);
  const double height = std::sqrt(std::max(0.0, 1 - dot(disc, disc)));
  return disc.x * surface.first + disc.y * surface.second + height * surface.axis;
}

Rgb surroundings(const LightRig& rig, Point3 direction) {
  const double rim = std::max(0.0, dot(direction, rig.rim));
  return mix(rig.ground, rig.sky, 0.5 + 0.5 * dot(direction, rig.up)) + rim * rim * rig.rim_light;
}

double highlight(const LightRig& rig, Point3 normal, Point3 to_light, Point3 to_viewer) {
  const double cosine = std::max(0.0, dot(normal, normalized(to_light + to_viewer)));
  const double square = cosine * cosine;
  const double eighth = square * square * square * square;
  return rig.gloss * eighth * eighth * eighth;
}

Rgb tone_curve(Rgb colour) { return {bend(colour.r), bend(colour.g), bend(colour.b)}; }

TextureSampler::TextureSampler(Image8 rgb, double max_width, bool smooth)
    : rgb_(std::move(rgb)), smooth_(smooth), linear_(linear_values()) {
  while (smooth_ && rgb_.width >= 2 * max_width && rgb_.width > 1) rgb_ = halved(rgb_, linear_);
}

Rgb TextureSampler::pixel(int x, int y) const {
  x = std::clamp(x, 0, rgb_.width - 1);
  y = std::clamp(y, 0, rgb_.height - 1);
  return {linear_[rgb_.at(x, y, 0)], linear_[rgb_.at(x, y, 1)], linear_[rgb_.at(x, y, 2)]};
}

Rgb TextureSampler::at(Point2 uv) const {
  const double x = std::clamp(uv.x, 0.0, 1.0) * rgb_.width - 0.5;
  const double y = std::clamp(uv.y, 0.0, 1.0) * rgb_.height - 0.5;
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  if (!smooth_) return pixel(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
  const Rgb top = mix(pixel(x0, y0), pixel(x0 + 1, y0), x - x0);
  const Rgb bottom = mix(pixel(x0, y0 + 1), pixel(x0 + 1, y0 + 1), x - x0);
  return mix(top, bottom, y - y0);
}

}  // namespace relievo
