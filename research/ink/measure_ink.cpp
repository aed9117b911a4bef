// Measures the contours of models: how far the front view departs from the drawing, how much ink is
// left on lit surfaces when the model is turned, and how the width of the contour changes then.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "io/mesh/glb_decode.h"
#include "kernel/geometry/box3.h"
#include "kernel/image/compose.h"
#include "relief/finish/find_ink.h"
#include "relief/finish/ink_mask.h"
#include "relievo/export.h"
#include "relievo/read.h"
#include "relievo/session.h"
#include "render/ray_scene.h"

namespace relievo::research {
namespace {

constexpr int rays_per_side = 4;  ///< per pixel of the front view
constexpr int turned_side = 800;  ///< px of turned views

/// Returns the colour of the nearest pixel of a texture.
std::array<double, 3> texel(const Image8& rgba, Point2 uv) {
  const int x = std::clamp(static_cast<int>(uv.x * rgba.width), 0, rgba.width - 1);
  const int y = std::clamp(static_cast<int>(uv.y * rgba.height), 0, rgba.height - 1);
  const uint8_t* c = &rgba.at(x, y);
  return {1.0 * on_paper(c[0], c[3]), 1.0 * on_paper(c[1], c[3]), 1.0 * on_paper(c[2], c[3])};
}

double far_of(const Model& model) {
  Box3 box;
  for (const Point3 p : model.positions) box.add(p);
  return norm(box.sides()) + norm(box.max) + norm(box.min);
}

/// A front view without light.
struct Front {
  Image8 rgb;
  ImageF cover;
};

/// Renders the front view without light at the drawing's resolution, on white paper.
Front front_view(const Model& model, const Drawing& drawing, const RayScene& scene, int width,
                 int height) {
  Front front{Image8(width, height, 3), ImageF(width, height, 1)};
  const double far = far_of(model);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::array<double, 3> sum{};
      double hits = 0;
      for (int s = 0; s < rays_per_side * rays_per_side; ++s) {
        const double u = (s % rays_per_side + 0.5) / rays_per_side;
        const double v = (s / rays_per_side + 0.5) / rays_per_side;
        const Point3 from{(x + u) / width * model.width,
                          model.height - (y + v) / height * model.height, far};
        const auto hit = scene.first_hit(from, {0, 0, -1});
        hits += hit ? 1 : 0;
        const std::array<double, 3> paper{255, 255, 255};
        const auto rgb = hit ? texel(drawing.rgba, texture_place(model, *hit)) : paper;
        for (size_t k = 0; k < 3; ++k) sum[k] += rgb[k];
      }
      constexpr double all = rays_per_side * rays_per_side;
      front.cover.at(x, y) = static_cast<float>(hits / all);
      for (size_t k = 0; k < 3; ++k)
        front.rgb.at(x, y, static_cast<int>(k)) = static_cast<uint8_t>(std::lround(sum[k] / all));
    }
  return front;
}

/// Views from the side.
class Camera {
 public:
  Camera(const Model& model, double yaw) {
    const double a = yaw * std::numbers::pi / 180;
    const double unit = std::max(model.width, model.height) / turned_side * 1.2;
    across_ = unit * Point3{std::cos(a), 0, -std::sin(a)};
    down_ = {0, -unit, 0};
    back_ = {std::sin(a), 0, std::cos(a)};
    corner_ = Point3{0.5 * model.width, 0.5 * model.height, 0} + far_of(model) * back_ -
              0.5 * turned_side * (across_ + down_);
  }

  /// Returns what a scene shows at a pixel.
  std::optional<RayHit> hit(const RayScene& scene, int x, int y) const {
    return scene.first_hit(corner_ + x * across_ + y * down_, -1 * back_);
  }

 private:
  Point3 across_;
  Point3 down_;
  Point3 back_;
  Point3 corner_;
};

/// Returns the mean width of the ink around the silhouette of a model, px: the area that it covers
/// beyond the model, per length of its outline.
double contour_width(const Model& model, const RayScene& inked, const RayScene& bare, double yaw) {
  const Camera camera(model, yaw);
  Image8 body(turned_side, turned_side, 1);
  double area = 0;
  double sides = 0;
  for (int y = 0; y < turned_side; ++y)
    for (int x = 0; x < turned_side; ++x) {
      body.at(x, y) = camera.hit(bare, x, y) ? 1 : 0;
      if (body.at(x, y) == 0 && camera.hit(inked, x, y)) ++area;
      if (x > 0 && body.at(x, y) != body.at(x - 1, y)) ++sides;
      if (y > 0 && body.at(x, y) != body.at(x, y - 1)) ++sides;
    }
  // A line of any direction crosses 4 / pi times as many sides of pixels as it is long, on average.
  return area / std::max(1.0, std::numbers::pi / 4 * sides);
}

/// Counts the pixels of paint that are as dark as ink and lie in the band of contours.
double dark_pixels(const Model& model, const Drawing& drawing, const RayScene& scene,
                   const Image8& band, double darkest, double yaw) {
  const Camera camera(model, yaw);
  double dark = 0;
  for (int y = 0; y < turned_side; ++y)
    for (int x = 0; x < turned_side; ++x) {
      const auto hit = camera.hit(scene, x, y);
      if (!hit || hit->is_ink) continue;
      Point2 at;
      for (size_t k = 0; k < 3; ++k) {
        const double w = k == 0 ? 1 - hit->u - hit->v : k == 1 ? hit->u : hit->v;
        const int v = model.triangles[hit->triangle][k];
        at = at + w * Point2{model.positions[v].x, model.positions[v].y};
      }
      const int px =
          std::clamp(static_cast<int>(at.x / model.width * band.width), 0, band.width - 1);
      const int py =
          std::clamp(static_cast<int>((1 - at.y / model.height) * band.height), 0, band.height - 1);
      const auto rgb = texel(drawing.rgba, texture_place(model, *hit));
      if (band.at(px, py) != 0 && (rgb[0] + rgb[1] + rgb[2]) / 3 < darkest) ++dark;
    }
  return dark;
}

Bytes read_all(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Prints a row about the model of a drawing; returns false if it cannot.
bool measure(const std::string& drawing_path, const std::string& model_path) {
  const auto drawn = read_drawing(drawing_path);
  const auto glb = decode_glb(read_all(model_path));
  if (!drawn || !glb) return false;
  Session session;
  if (!session.build(drawn->scene)) return false;
  const auto surface = session.model();
  if (!surface) return false;
  const Image8& rgba = drawn->drawing.rgba;

  const relief::ContourInk ink = relief::find_ink(*surface, drawn->drawing);
  Image8 band = relief::ink_mask(ink, *surface, rgba);
  std::vector<double> darkness;
  for (const relief::PartInk& part : ink.parts)
    if (part.width > 0) darkness.push_back((part.rgb[0] + part.rgb[1] + part.rgb[2]) / 3.0);
  std::sort(darkness.begin(), darkness.end());
  const double darkest = darkness.empty() ? 0 : darkness[darkness.size() / 2] + 40;

  const RunContext context;
  const auto scene = RayScene::build(glb->model, glb->model.ink, context);
  const auto bare = RayScene::build(glb->model, {}, context);
  const auto whole = RayScene::build(*surface, {}, context);
  if (!scene || !bare || !whole) return false;
  const Front front = front_view(glb->model, glb->drawing, *scene, rgba.width, rgba.height);
  const Front full = front_view(*surface, drawn->drawing, *whole, rgba.width, rgba.height);
  Image8 shown = front.rgb;
  double wrong = 0;
  double figure = 0;
  double common = 0;
  double united = 0;
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const float a = front.cover.at(x, y);
      const float b = full.cover.at(x, y);
      common += std::min(a, b);
      united += std::max(a, b);
      if (b < 0.5F) continue;
      ++figure;
      const uint8_t* c = &rgba.at(x, y);
      int most = 0;
      for (int k = 0; k < 3; ++k)
        most = std::max(most, std::abs(on_paper(c[k], c[3]) - front.rgb.at(x, y, k)));
      if (most <= 30) continue;
      ++wrong;
      shown.at(x, y, 0) = 255;
      shown.at(x, y, 1) = 0;
      shown.at(x, y, 2) = 255;
    }
  const std::string name = drawing_path.substr(drawing_path.rfind('/') + 1);
  if (const char* folder = std::getenv("RELIEVO_PICTURES")) {
    const auto png = encode_picture(shown);
    std::ofstream(std::string(folder) + "/" + name + ".png", std::ios::binary)
        .write(reinterpret_cast<const char*>(png->data()), std::ssize(*png));
  }
  std::printf("%s\t%.2f\t%.4f", name.c_str(), 100 * wrong / figure, common / united);
  for (const double yaw : {45.0, 75.0, 90.0})
    std::printf("\t%.0f", dark_pixels(glb->model, glb->drawing, *scene, band, darkest, yaw));
  std::printf("\t%.2f\n", contour_width(glb->model, *scene, *bare, 45) /
                              contour_width(glb->model, *scene, *bare, 0));
  return true;
}

}  // namespace
}  // namespace relievo::research

int main(int argc, char** argv) {
  if (argc < 3 || argc % 2 == 0) {
    std::fprintf(stderr, "usage: relievo-ink (DRAWING MODEL.glb)...\n");
    return 2;
  }
  for (int i = 1; i + 1 < argc; i += 2)
    if (!relievo::research::measure(argv[i], argv[i + 1]))
      std::fprintf(stderr, "%s cannot be measured\n", argv[i]);
  return 0;
}
