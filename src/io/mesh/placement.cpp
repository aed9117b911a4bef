#include "io/mesh/placement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <unordered_map>

namespace relievo {
namespace {

bool is_finite(Point3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }
bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

double longest_side(const Box3& box) {
  const Point3 sides = box.sides();
  return std::max({sides.x, sides.y, sides.z});
}

}  // namespace

Box3 extent(const Model& model) {
  Box3 box;
  for (const Point3 p : model.positions) box.add(p);
  for (const Point3 p : model.ink.positions) box.add(p);
  return box;
}

double longest_side(const Model& model) { return longest_side(extent(model)); }

Placement centred_placement(const Model& model, double size, bool grounded) {
  const Box3 box = extent(model);
  const Point3 middle = 0.5 * (box.min + box.max);
  return {size / longest_side(box), {middle.x, grounded ? box.min.y : middle.y, 0}};
}

Placement octant_placement(const Model& model, double size, bool standing) {
  const Box3 box = extent(model);
  const Point3 corner = standing ? Point3{box.min.x, -box.max.z, box.min.y} : box.min;
  return {size / longest_side(box), corner, standing};
}

SharedVertices share_vertices(const Model& model, const Placement& placement) {
  const auto hash = [](const std::array<float, 3>& place) {
    uint64_t sum = 0;
    for (const float value : place)
      sum = sum * uint64_t{0x9E3779B97F4A7C15} + std::hash<float>()(value);
    return static_cast<size_t>(sum);
  };
  SharedVertices shared;
  std::unordered_map<std::array<float, 3>, int, decltype(hash)> numbers(model.positions.size());
  shared.number.reserve(model.positions.size());
  for (const Point3& position : model.positions) {
    const Point3 p = place(placement, position);
    const std::array<float, 3> narrow{static_cast<float>(p.x), static_cast<float>(p.y),
                                      static_cast<float>(p.z)};
    const auto [at, fresh] = numbers.try_emplace(narrow, static_cast<int>(shared.places.size()));
    if (fresh) shared.places.push_back(narrow);
    shared.number.push_back(at->second);
  }
  return shared;
}

Status check_exportable(const Model& model, double size_mm) {
  if (!std::isfinite(size_mm) || size_mm <= 0)
    return Error{ErrorCode::usage, "the size of the model must be above 0 mm", ""};
  if (model.triangles.empty()) return Error{ErrorCode::bad_input, "the model has no triangles", ""};
  for (size_t v = 0; v < model.ink.positions.size(); ++v)
    if (!is_finite(model.ink.positions[v]) || !is_finite(model.ink.uvs[v]))
      return Error{ErrorCode::bad_input,
                   "the ink has a vertex with a coordinate that is not finite",
                   "vertex " + std::to_string(v)};
  for (size_t v = 0; v < model.positions.size(); ++v)
    if (!is_finite(model.positions[v]) || !is_finite(model.normals[v]) || !is_finite(model.uvs[v]))
      return Error{ErrorCode::bad_input,
                   "the model has a vertex with a coordinate that is not finite",
                   "vertex " + std::to_string(v)};
  if (longest_side(extent(model)) <= 0)
    return Error{ErrorCode::bad_input, "all vertices of the model lie at one point", ""};
  return Done{};
}

}  // namespace relievo
