#include "relief/finish/ink_shell.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "kernel/meshing/simplify_triangles.h"
#include "kernel/meshing/vertex_numbering.h"
#include "relief/finish/beside_rim.h"

namespace relievo::relief {
namespace {

constexpr double shell_share = 0.35;   ///< of the surface's triangles that a shell has
constexpr double shell_error = 0.5;    ///< of the ink's width by which it may depart
constexpr double widths_of_shell = 4;  ///< of ink over which outlines determine the shell's width

/// Returns the usual width of ink at every vertex, the mean of its triangles', canvas px.
std::vector<double> usual_widths(const std::vector<PartInk>& parts, const Model& model) {
  std::vector<double> width(model.positions.size(), 0);
  std::vector<int> count(model.positions.size(), 0);
  for (size_t p = 0; p < parts.size(); ++p)
    for (int t = model.parts[p].first_triangle; t < model.parts[p].end(); ++t)
      for (const int v : model.triangles[t]) {
        width[v] += parts[p].width;
        ++count[v];
      }
  for (size_t v = 0; v < width.size(); ++v) width[v] /= std::max(1, count[v]);
  return width;
}

/// Returns the width of ink at every vertex, canvas px: beside an outline that of its line, which
/// is 0 where there is none.
std::vector<double> shell_widths(const ContourInk& ink, const Model& model,
                                 const SolidPlace& place) {
  std::vector<double> width = usual_widths(ink.parts, model);
  std::vector<Point2> outline;
  std::vector<double> drawn;
  for (const InkLine& line : ink.lines)
    for (const OutlinePoint& p : line.points) {
      outline.push_back(p.place - p.inside * p.out);
      drawn.push_back(p.inside + p.outside);
    }
  for (const OutlinePoint& p : ink.plain) {
    outline.push_back(p.place);
    drawn.push_back(0);
  }
  const BesideRim beside(std::move(outline),
                         widths_of_shell * *std::max_element(width.begin(), width.end()));
  for (size_t v = 0; v < width.size(); ++v) {
    const Point3 p = model.positions[v];
    const Point2 at{(p.x - place.shift.x) / place.scale.x, (p.y - place.shift.y) / place.scale.y};
    const double nearest = beside.distance_to(at);
    if (width[v] == 0 || nearest >= beside.reach()) continue;
    double local = 0;
    beside.for_each(at, nearest, [&](size_t i, double weight) { local += weight * drawn[i]; });
    const double share = BesideRim::share_within(nearest, beside.reach());
    width[v] += share * (local - width[v]);
  }
  return width;
}

/// Adds the shell of a part.
void add_shell(const Model& model, const ModelPart& part, double error,
               const std::vector<double>& width, Point2 uv, VertexNumbering& numbers,
               InkMesh& mesh) {
  numbers.restart();
  std::vector<std::array<int, 3>> triangles;
  for (int t = part.first_triangle; t < part.end(); ++t)
    triangles.push_back(numbers.of(model.triangles[t]));
  std::vector<Point3> positions;
  for (const int v : numbers.given()) positions.push_back(model.positions[v]);
  triangles = simplify_triangles(
      positions, triangles,
      static_cast<size_t>(shell_share * static_cast<double>(triangles.size())), error);
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

void add_shells(const ContourInk& ink, const Model& model, const SolidPlace& place, double width,
                const std::vector<Point2>& uvs, InkMesh& mesh) {
  std::vector<double> widths = shell_widths(ink, model, place);
  for (double& w : widths) w *= width * place.scale.x;
  VertexNumbering numbers(model.positions.size());
  for (size_t p = 0; p < ink.parts.size(); ++p)
    if (ink.parts[p].width > 0)
      add_shell(model, model.parts[p], shell_error * width * place.scale.x * ink.parts[p].width,
                widths, uvs[p], numbers, mesh);
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
