#include "lod/simplify_model.h"

#include <algorithm>
#include <array>
#include <vector>

#include "kernel/geometry/box3.h"
#include "kernel/meshing/simplify_triangles.h"
#include "kernel/meshing/vertex_numbering.h"

namespace relievo {
namespace {

/// Greatest distance by which a surface may move, of the model's extent; beyond it limbs fall off.
constexpr double most_error = 0.005;

/// A model whose parts share no vertex.
struct Pieces {
  std::vector<std::array<int, 3>> triangles;
  std::vector<Point3> positions;
  std::vector<int> source;  ///< vertex of the model
  std::vector<int> part;
};

Pieces take_apart(const Model& model) {
  Pieces pieces;
  VertexNumbering numbers(model.positions.size());
  for (size_t p = 0; p < model.parts.size(); ++p) {
    const ModelPart& part = model.parts[p];
    const int first = static_cast<int>(pieces.source.size());
    for (int t = part.first_triangle; t < part.end(); ++t) {
      const auto [a, b, c] = numbers.of(model.triangles[t]);
      pieces.triangles.push_back({first + a, first + b, first + c});
    }
    for (const int v : numbers.given()) {
      pieces.positions.push_back(model.positions[v]);
      pieces.source.push_back(v);
      pieces.part.push_back(static_cast<int>(p));
    }
    numbers.restart();
  }
  return pieces;
}

/// Returns the model of the triangles that are left.
Model put_together(const Model& model, const Pieces& pieces) {
  Model result;
  result.width = model.width;
  result.height = model.height;
  result.parts = model.parts;
  std::vector<std::vector<size_t>> triangles(model.parts.size());
  for (size_t t = 0; t < pieces.triangles.size(); ++t)
    triangles[pieces.part[pieces.triangles[t][0]]].push_back(t);
  VertexNumbering numbers(model.positions.size());
  for (size_t p = 0; p < triangles.size(); ++p) {
    result.parts[p].first_triangle = static_cast<int>(result.triangles.size());
    result.parts[p].triangle_count = static_cast<int>(triangles[p].size());
    for (const size_t t : triangles[p]) {
      const auto [a, b, c] = pieces.triangles[t];
      result.triangles.push_back(
          numbers.of({pieces.source[a], pieces.source[b], pieces.source[c]}));
    }
  }
  for (const int v : numbers.given()) {
    result.positions.push_back(model.positions[v]);
    result.normals.push_back(model.normals[v]);
    result.uvs.push_back(model.uvs[v]);
  }
  return result;
}

/// Simplifies lines and leaves out vertices without triangles.
InkMesh simplify_ink(const InkMesh& ink, size_t triangles, double error) {
  InkMesh result;
  VertexNumbering numbers(ink.positions.size());
  for (const auto& t : simplify_triangles(ink.positions, ink.triangles, triangles, error))
    result.triangles.push_back(numbers.of(t));
  for (const int v : numbers.given()) {
    result.positions.push_back(ink.positions[v]);
    result.uvs.push_back(ink.uvs[v]);
  }
  return result;
}

}  // namespace

Model simplify_model(const Model& model, int triangles) {
  if (model.all_triangles() <= static_cast<size_t>(triangles)) return model;
  const double share = static_cast<double>(triangles) / static_cast<double>(model.all_triangles());
  const auto left_of = [share](size_t count) {
    return static_cast<size_t>(share * static_cast<double>(count));
  };
  Pieces pieces = take_apart(model);
  Box3 box;
  for (const Point3 p : pieces.positions) box.add(p);
  const Point3 sides = box.sides();
  const double error = most_error * std::max({sides.x, sides.y, sides.z});
  pieces.triangles = simplify_triangles(pieces.positions, pieces.triangles,
                                        left_of(model.triangles.size()), error);
  Model result = put_together(model, pieces);
  result.ink = simplify_ink(model.ink, left_of(model.ink.triangles.size()), error);
  return result;
}

Model unite_parts(Model model, const std::string& id) {
  ModelPart all;
  all.id = id;
  all.triangle_count = static_cast<int>(model.triangles.size());
  model.parts = {all};
  return model;
}

}  // namespace relievo
