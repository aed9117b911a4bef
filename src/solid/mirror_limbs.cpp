#include "solid/mirror_limbs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "kernel/meshing/unite_meshes.h"

namespace relievo {
namespace {

/// Moves of a limb, tried in this order, in units of `nudge` mm: limb and figure have the same
/// outline, and their walls must not coincide.
constexpr double nudge = 0.01;
constexpr std::array<Point3, 5> nudges{
    {{1, 0.6, 0}, {-0.7, 1.1, 1}, {0.9, -1.3, -1}, {-1.6, -0.8, 3}, {2.1, 1.7, -3}}};

struct PaintedCorner {
  Point3 normal;
  Point2 uv;
};

/// A closed mesh with the normals and texture coordinates of its model at the corners.
struct PaintedMesh {
  ClosedMesh mesh;
  std::vector<std::array<PaintedCorner, 3>> corners;
  std::vector<int> part;
};

std::tuple<double, double, double> key(Point3 p) { return {p.x, p.y, p.z}; }

PaintedMesh painted_mesh(const Model& model) {
  PaintedMesh painted;
  std::map<std::tuple<double, double, double>, int> numbers;
  std::vector<int> place;
  for (const Point3 p : model.positions) {
    const auto [at, fresh] =
        numbers.try_emplace(key(p), static_cast<int>(painted.mesh.points.size()));
    if (fresh) painted.mesh.points.push_back(p);
    place.push_back(at->second);
  }
  for (size_t p = 0; p < model.parts.size(); ++p)
    for (int i = 0; i < model.parts[p].triangle_count; ++i) {
      const auto& [a, b, c] = model.triangles[model.parts[p].first_triangle + i];
      painted.mesh.triangles.push_back({place[a], place[b], place[c]});
      painted.corners.push_back({PaintedCorner{model.normals[a], model.uvs[a]},
                                 {model.normals[b], model.uvs[b]},
                                 {model.normals[c], model.uvs[c]}});
      painted.part.push_back(static_cast<int>(p));
    }
  return painted;
}

/// Interpolates normal and texture coordinates at a point of a triangle.
PaintedCorner corner_at(const PaintedMesh& from, int triangle, Point3 place) {
  const auto& [a, b, c] = from.mesh.triangles[triangle];
  const std::array<Point3, 3> p{from.mesh.points[a], from.mesh.points[b], from.mesh.points[c]};
  const Point3 normal = cross(p[1] - p[0], p[2] - p[0]);
  std::array<double, 3> share{};
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    if (p[k] == place) return from.corners[triangle][k];
    const Point3 q = p[(k + 1) % 3];
    share[k] = std::max(0.0, dot(normal, cross(p[(k + 2) % 3] - q, place - q)));
    sum += share[k];
  }
  PaintedCorner corner{};
  for (int k = 0; k < 3; ++k) {
    const double s = sum > 0 ? share[k] / sum : 1.0 / 3;
    corner.normal = corner.normal + s * from.corners[triangle][k].normal;
    corner.uv = corner.uv + s * from.corners[triangle][k].uv;
  }
  corner.normal = normalized(corner.normal);
  return corner;
}

PaintedMesh repaint(UnitedMesh united, const PaintedMesh& first, const PaintedMesh& second) {
  PaintedMesh painted{std::move(united.mesh), {}, {}};
  for (size_t t = 0; t < painted.mesh.triangles.size(); ++t) {
    const auto [mesh, triangle] = united.sources[t];
    const PaintedMesh& from = mesh == 0 ? first : second;
    std::array<PaintedCorner, 3>& corners = painted.corners.emplace_back();
    for (int k = 0; k < 3; ++k)
      corners[k] = corner_at(from, triangle, painted.mesh.points[painted.mesh.triangles[t][k]]);
    painted.part.push_back(from.part[triangle]);
  }
  return painted;
}

/// Replaces the triangles of a model with the same parts.
void write_back(const PaintedMesh& painted, Model& model) {
  model.positions.clear();
  model.normals.clear();
  model.uvs.clear();
  std::map<std::tuple<int, double, double, double, double, double>, int> numbers;
  std::vector<std::vector<std::array<int, 3>>> of_part(model.parts.size());
  for (size_t t = 0; t < painted.mesh.triangles.size(); ++t) {
    std::array<int, 3>& triangle = of_part[painted.part[t]].emplace_back();
    for (int k = 0; k < 3; ++k) {
      const int point = painted.mesh.triangles[t][k];
      const auto& [n, uv] = painted.corners[t][k];
      const auto [at, fresh] = numbers.try_emplace({point, n.x, n.y, n.z, uv.x, uv.y},
                                                   static_cast<int>(model.positions.size()));
      triangle[k] = at->second;
      if (!fresh) continue;
      model.positions.push_back(painted.mesh.points[point]);
      model.normals.push_back(n);
      model.uvs.push_back(uv);
    }
  }
  model.triangles.clear();
  for (size_t p = 0; p < of_part.size(); ++p) {
    model.parts[p].first_triangle = static_cast<int>(model.triangles.size());
    model.parts[p].triangle_count = static_cast<int>(of_part[p].size());
    model.triangles.insert(model.triangles.end(), of_part[p].begin(), of_part[p].end());
  }
}

/// Mirrors a mesh about the middle, z to twice_middle - z, and moves it.
PaintedMesh mirrored(PaintedMesh painted, double twice_middle, Point3 moved,
                     const std::vector<Point2>& colours) {
  for (Point3& p : painted.mesh.points) p = moved + Point3{p.x, p.y, twice_middle - p.z};
  for (size_t t = 0; t < painted.corners.size(); ++t) {
    std::swap(painted.mesh.triangles[t][1], painted.mesh.triangles[t][2]);
    std::swap(painted.corners[t][1], painted.corners[t][2]);
    for (PaintedCorner& corner : painted.corners[t]) {
      corner.normal.z = -corner.normal.z;
      if (!colours.empty()) corner.uv = colours[painted.part[t]];
    }
  }
  return painted;
}

}  // namespace

Status unite_with_limbs(const std::vector<SolidLimb>& limbs, double unit,
                        const std::vector<Point2>& colours, Solid& solid) {
  if (limbs.empty()) return Done{};
  PaintedMesh whole = painted_mesh(solid.model);
  for (const SolidLimb& limb : limbs) {
    const PaintedMesh near = painted_mesh(limb.model);
    bool united = false;
    for (const Point3 by : nudges) {
      const auto steps = [unit](double share) { return unit * std::round(share * nudge / unit); };
      const PaintedMesh far =
          mirrored(near, limb.twice_middle, {steps(by.x), steps(by.y), steps(by.z)}, colours);
      auto both = unite_meshes(whole.mesh, far.mesh, unit);
      if (!both && both.error().code != ErrorCode::internal) return both.error();
      if (!both || both->pieces > solid.facts.pieces) continue;
      solid.facts.pieces = both->pieces;
      whole = repaint(std::move(*both), whole, far);
      united = true;
      break;
    }
    if (!united)
      return Error{ErrorCode::usage,
                   "the mirrored \"" + limb.id +
                       "\" does not become one solid with the figure; leave it out, or use "
                       "other --vertices",
                   "--mirror"};
  }
  if (solid.facts.pieces == 1) solid.facts.loose.clear();
  write_back(whole, solid.model);
  return Done{};
}

}  // namespace relievo
