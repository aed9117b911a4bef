#include "lod/simplify_model.h"

#include <meshoptimizer.h>

#include <array>
#include <vector>

namespace relievo {
namespace {

/// Greatest distance by which a surface may move, of the model's extent; beyond it limbs fall off.
constexpr float most_error = 0.005F;

/// A model whose parts share no vertex, in the simplifier's format.
struct Pieces {
  std::vector<unsigned> indices;
  std::vector<std::array<float, 3>> positions;
  std::vector<int> source;  ///< vertex of the model
  std::vector<int> part;
};

Pieces take_apart(const Model& model) {
  Pieces pieces;
  std::vector<int> local(model.positions.size(), -1);
  for (size_t p = 0; p < model.parts.size(); ++p) {
    const ModelPart& part = model.parts[p];
    const size_t first = pieces.source.size();
    for (int t = part.first_triangle; t < part.end(); ++t)
      for (const int v : model.triangles[t]) {
        if (local[v] < 0) {
          local[v] = static_cast<int>(pieces.source.size());
          const Point3 at = model.positions[v];
          pieces.positions.push_back(
              {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
          pieces.source.push_back(v);
          pieces.part.push_back(static_cast<int>(p));
        }
        pieces.indices.push_back(static_cast<unsigned>(local[v]));
      }
    for (size_t i = first; i < pieces.source.size(); ++i) local[pieces.source[i]] = -1;
  }
  return pieces;
}

/// Returns the model of the indices that are left.
Model put_together(const Model& model, const Pieces& pieces) {
  Model result;
  result.width = model.width;
  result.height = model.height;
  result.parts = model.parts;
  std::vector<std::vector<size_t>> corners(model.parts.size());
  for (size_t i = 0; i < pieces.indices.size(); i += 3)
    corners[pieces.part[pieces.indices[i]]].push_back(i);
  std::vector<int> number(model.positions.size(), -1);
  const auto number_of = [&](int v) {
    if (number[v] < 0) {
      number[v] = static_cast<int>(result.positions.size());
      result.positions.push_back(model.positions[v]);
      result.normals.push_back(model.normals[v]);
      result.uvs.push_back(model.uvs[v]);
    }
    return number[v];
  };
  for (size_t p = 0; p < corners.size(); ++p) {
    result.parts[p].first_triangle = static_cast<int>(result.triangles.size());
    result.parts[p].triangle_count = static_cast<int>(corners[p].size());
    for (const size_t i : corners[p]) {
      std::array<int, 3> triangle{};
      for (size_t k = 0; k < 3; ++k) triangle[k] = number_of(pieces.source[pieces.indices[i + k]]);
      result.triangles.push_back(triangle);
    }
  }
  return result;
}

}  // namespace

Model simplify_model(const Model& model, int triangles) {
  if (model.triangles.size() <= static_cast<size_t>(triangles)) return model;
  Pieces pieces = take_apart(model);
  const std::vector<unsigned> before = pieces.indices;
  const size_t left = meshopt_simplify(pieces.indices.data(), before.data(), pieces.indices.size(),
                                       pieces.positions.front().data(), pieces.positions.size(),
                                       sizeof pieces.positions.front(),
                                       3 * static_cast<size_t>(triangles), most_error, 0, nullptr);
  pieces.indices.resize(left);
  return put_together(model, pieces);
}

Model unite_parts(Model model, const std::string& id) {
  ModelPart all;
  all.id = id;
  all.triangle_count = static_cast<int>(model.triangles.size());
  model.parts = {all};
  return model;
}

}  // namespace relievo
