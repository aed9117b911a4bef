#include "relief/finish/ink_shell.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "kernel/meshing/simplify_triangles.h"
#include "kernel/meshing/vertex_numbering.h"

namespace relievo::relief {
namespace {

constexpr double shell_share = 0.35;  ///< of the surface's triangles that a shell has
constexpr double shell_error = 0.5;   ///< of the ink's width by which it may depart

/// Returns the width of ink at every vertex, the mean of its triangles'.
std::vector<double> shell_widths(const std::vector<PartInk>& parts, const Model& model,
                                 double scale) {
  std::vector<double> width(model.positions.size(), 0);
  std::vector<int> count(model.positions.size(), 0);
  for (size_t p = 0; p < parts.size(); ++p)
    for (int t = model.parts[p].first_triangle; t < model.parts[p].end(); ++t)
      for (const int v : model.triangles[t]) {
        width[v] += scale * parts[p].width;
        ++count[v];
      }
  for (size_t v = 0; v < width.size(); ++v) width[v] /= std::max(1, count[v]);
  return width;
}

/// Adds the shell of a part.
void add_shell(const Model& model, const ModelPart& part, const std::vector<double>& width,
               Point2 uv, VertexNumbering& numbers, InkMesh& mesh) {
  numbers.restart();
  std::vector<std::array<int, 3>> triangles;
  for (int t = part.first_triangle; t < part.end(); ++t)
    triangles.push_back(numbers.of(model.triangles[t]));
  std::vector<Point3> positions;
  double least = std::numeric_limits<double>::infinity();
  for (const int v : numbers.given()) {
    positions.push_back(model.positions[v]);
    least = std::min(least, width[v]);
  }
  triangles =
      simplify_triangles(positions, triangles,
                         static_cast<size_t>(shell_share * static_cast<double>(triangles.size())),
                         shell_error * least);
  VertexNumbering kept(positions.size());
  const int first = static_cast<int>(mesh.positions.size());
  for (const std::array<int, 3>& t : triangles) {
    const auto [a, b, c] = kept.of(t);
    mesh.triangles.push_back({first + c, first + b, first + a});
  }
  for (const int k : kept.given()) {
    const int v = numbers.given()[k];
    mesh.positions.push_back(model.positions[v] + width[v] * model.normals[v]);
    mesh.uvs.push_back(uv);
  }
}

}  // namespace

void add_shells(const std::vector<PartInk>& parts, const Model& model, double scale,
                const std::vector<Point2>& uvs, InkMesh& mesh) {
  const std::vector<double> width = shell_widths(parts, model, scale);
  VertexNumbering numbers(model.positions.size());
  for (size_t p = 0; p < parts.size(); ++p)
    if (parts[p].width > 0) add_shell(model, model.parts[p], width, uvs[p], numbers, mesh);
}

Model weld(const Model& model) {
  Model one;
  one.width = model.width;
  one.height = model.height;
  one.parts = model.parts;
  std::map<std::array<double, 3>, int> places;
  std::vector<int> place;
  for (const Point3& p : model.positions) {
    const auto [at, fresh] =
        places.try_emplace({p.x, p.y, p.z}, static_cast<int>(one.positions.size()));
    if (fresh) one.positions.push_back(p);
    place.push_back(at->second);
  }
  one.normals.resize(one.positions.size());
  for (const std::array<int, 3>& t : model.triangles) {
    const auto& [a, b, c] =
        one.triangles.emplace_back(std::array<int, 3>{place[t[0]], place[t[1]], place[t[2]]});
    const Point3 from = one.positions[a];
    const Point3 normal = cross(one.positions[b] - from, one.positions[c] - from);
    for (const int v : {a, b, c}) one.normals[v] = one.normals[v] + normal;
  }
  for (Point3& n : one.normals) n = normalized(n);
  return one;
}

}  // namespace relievo::relief
