#include "support/sample_models.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo {
namespace {

/// Adds a vertex above the canvas point (x, y); returns its index.
int add_vertex(Model& model, Point2 canvas, double z, Point3 normal) {
  model.positions.push_back({canvas.x, model.height - canvas.y, z});
  model.normals.push_back(normalized(normal));
  model.uvs.push_back({canvas.x / model.width, canvas.y / model.height});
  return static_cast<int>(model.positions.size()) - 1;
}

void finish_part(Model& model, const std::string& id, size_t first_triangle) {
  ModelPart part;
  part.id = id;
  part.first_triangle = static_cast<int>(first_triangle);
  part.triangle_count = static_cast<int>(model.triangles.size() - first_triangle);
  model.parts.push_back(part);
}

}  // namespace

Model empty_model(double width, double height) {
  Model model;
  model.width = width;
  model.height = height;
  return model;
}

void add_ellipsoid(Model& model, const Ellipsoid& e) {
  const size_t first_triangle = model.triangles.size();
  const int sectors = 4 * e.rings;
  const double pole_z = e.base + e.radii.z;
  const int pole = add_vertex(model, e.centre, pole_z, {0, 0, 1});
  for (int ring = 1; ring <= e.rings; ++ring) {
    const double theta = 0.5 * std::numbers::pi * ring / e.rings;
    const double radius = ring == e.rings ? 1 : std::sin(theta);
    const double height = ring == e.rings ? 0 : std::cos(theta);
    for (int s = 0; s < sectors; ++s) {
      const double phi = 2 * std::numbers::pi * s / sectors;
      const Point2 unit{radius * std::cos(phi), radius * std::sin(phi)};
      const double side = e.radii.z > 0 ? 1 : -1;
      const Point3 normal{side * unit.x / e.radii.x, side * unit.y / e.radii.y,
                          height / std::abs(e.radii.z)};
      add_vertex(model, {e.centre.x + e.radii.x * unit.x, e.centre.y - e.radii.y * unit.y},
                 e.base + e.radii.z * height, normal);
    }
  }
  const auto at = [&](int ring, int s) { return pole + 1 + (ring - 1) * sectors + s % sectors; };
  for (int s = 0; s < sectors; ++s) model.triangles.push_back({pole, at(1, s), at(1, s + 1)});
  for (int ring = 1; ring < e.rings; ++ring)
    for (int s = 0; s < sectors; ++s) {
      model.triangles.push_back({at(ring, s), at(ring + 1, s), at(ring + 1, s + 1)});
      model.triangles.push_back({at(ring, s), at(ring + 1, s + 1), at(ring, s + 1)});
    }
  finish_part(model, e.id, first_triangle);
}

void add_plane(Model& model, const std::string& id, double z) {
  const size_t first_triangle = model.triangles.size();
  const int a = add_vertex(model, {0, model.height}, z, {0, 0, 1});
  const int b = add_vertex(model, {model.width, model.height}, z, {0, 0, 1});
  const int c = add_vertex(model, {model.width, 0}, z, {0, 0, 1});
  const int d = add_vertex(model, {0, 0}, z, {0, 0, 1});
  model.triangles.push_back({a, b, c});
  model.triangles.push_back({a, c, d});
  finish_part(model, id, first_triangle);
}

Model hemisphere(double radius, int rings) {
  const double side = 2.5 * radius;
  Model model = empty_model(side, side);
  add_ellipsoid(model, {"ball", {0.5 * side, 0.5 * side}, 0, {radius, radius, radius}, rings});
  return model;
}

InkMesh ink_rectangle(Point2 low, Point2 high, double z, bool facing) {
  InkMesh ink;
  ink.positions = {{low.x, low.y, z}, {high.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}};
  ink.uvs.assign(4, {0.1, 0.1});
  ink.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (!facing)
    for (std::array<int, 3>& t : ink.triangles) std::swap(t[1], t[2]);
  return ink;
}

Model split_hemisphere(double radius) {
  Model model = hemisphere(radius, 12);
  const double middle = 0.5 * model.width;
  const auto is_left = [&](const std::array<int, 3>& t) {
    return model.positions[t[0]].x + model.positions[t[1]].x + model.positions[t[2]].x < 3 * middle;
  };
  const auto first_right =
      std::stable_partition(model.triangles.begin(), model.triangles.end(), is_left);
  const int left = static_cast<int>(first_right - model.triangles.begin());
  const int all = static_cast<int>(model.triangles.size());
  model.parts = {{"left half", 4, 1, 0, {}, 0, left},
                 {"right half", 2, 0.5, 0.25, {0.5, -0.125}, left, all - left}};
  return model;
}

Drawing quarters() {
  Drawing drawing{Image8(8, 8, 4, 255)};
  const auto paint = [&](int x0, int y0, std::array<uint8_t, 3> rgb) {
    for (int y = y0; y < y0 + 4; ++y)
      for (int x = x0; x < x0 + 4; ++x)
        for (int c = 0; c < 3; ++c) drawing.rgba.at(x, y, c) = rgb[static_cast<size_t>(c)];
  };
  paint(0, 0, {255, 0, 0});
  paint(4, 0, {0, 255, 0});
  paint(0, 4, {0, 0, 255});
  return drawing;
}

}  // namespace relievo
