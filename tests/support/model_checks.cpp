#include "support/model_checks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include "relief/surface/surface_sample.h"

namespace relievo {
namespace {

std::vector<int> merged_by_place(const std::vector<Point3>& positions) {
  std::map<std::tuple<double, double, double>, int> first;
  std::vector<int> merged;
  for (const Point3 p : positions)
    merged.push_back(
        first.try_emplace({p.x, p.y, p.z}, static_cast<int>(merged.size())).first->second);
  return merged;
}

double front_area(const Model& model, const std::array<int, 3>& t) {
  const Point3 a = model.positions[t[1]] - model.positions[t[0]];
  const Point3 b = model.positions[t[2]] - model.positions[t[0]];
  return 0.5 * (a.x * b.y - a.y * b.x);
}

/// Barycentric coordinates of `p` in a base triangle; the least is negative outside.
std::array<double, 3> barycentric(const relief::LayeredMesh& mesh, int t, Point2 p) {
  const Point2 a = mesh.vertices[mesh.triangles[t][0]];
  const Point2 b = mesh.vertices[mesh.triangles[t][1]];
  const Point2 c = mesh.vertices[mesh.triangles[t][2]];
  const double area = cross(b - a, c - a);
  return {cross(c - b, p - b) / area, cross(a - c, p - c) / area, cross(b - a, p - a) / area};
}

/// Height of `part` at `p` by the face around it that contains `p` best.
double face_height(const DiscRelief& relief, int part, Point2 p) {
  double least = -1e300;
  double result = 0;
  for (size_t f = 0; f < relief.mesh.faces.size(); ++f) {
    if (relief.mesh.face_part[f] != part) continue;
    const auto w = barycentric(relief.mesh, relief.mesh.face_triangle[f], p);
    const double inside = std::min({w[0], w[1], w[2]});
    if (inside <= least) continue;
    least = inside;
    double u = 0;
    double g = 0;
    for (int k = 0; k < 3; ++k) {
      u += w[k] * relief.inflation.u[relief.mesh.faces[f][k]];
      g += w[k] * relief.ordering.g[relief.mesh.faces[f][k]];
    }
    result = g + relief::signed_root(u);
  }
  return result;
}

template <class T>
void append_bytes(const std::vector<T>& values, std::vector<unsigned char>& bytes) {
  const size_t before = bytes.size();
  bytes.resize(before + values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(bytes.data() + before, values.data(), values.size() * sizeof(T));
}

}  // namespace

EdgeCensus count_edges(const Model& model, bool merge_places) {
  std::vector<int> vertex = merged_by_place(model.positions);
  if (!merge_places)
    for (size_t v = 0; v < vertex.size(); ++v) vertex[v] = static_cast<int>(v);
  struct Use {
    int forward = 0;
    int backward = 0;
    std::array<int, 2> vertices{};
  };
  std::map<std::array<int, 2>, Use> uses;
  for (const auto& t : model.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = vertex[t[k]];
      const int b = vertex[t[(k + 1) % 3]];
      Use& use = uses[{std::min(a, b), std::max(a, b)}];
      ++(a < b ? use.forward : use.backward);
      use.vertices = {t[k], t[(k + 1) % 3]};
    }
  EdgeCensus census;
  for (const auto& [key, use] : uses) {
    ++census.edges;
    if (use.forward + use.backward > 2) ++census.crowded;
    if (use.forward > 1 || use.backward > 1) ++census.repeated;
    if (use.forward == use.backward) continue;
    ++census.open;
    census.open_edges.push_back(use.vertices);
  }
  return census;
}

SilhouetteCensus count_silhouette(const Model& model, const relief::LayeredMesh& mesh) {
  SilhouetteCensus census;
  std::set<std::pair<double, double>> places;
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (mesh.neighbours[t][k] >= 0) continue;
      ++census.outline;
      for (const int side : {1, 2}) {
        const Point2 p = mesh.vertices[mesh.triangles[t][(k + side) % 3]];
        places.insert({p.x, model.height - p.y});
      }
    }
  for (const auto& [a, b] : count_edges(model, true).open_edges) {
    const Point3 p = model.positions[a];
    const Point3 q = model.positions[b];
    if (places.count({p.x, p.y}) == 0 || places.count({q.x, q.y}) == 0) ++census.elsewhere;
    if (p.x != q.x || p.y != q.y) ++census.along;
  }
  return census;
}

bool is_wall(const Model& model, const std::array<int, 3>& triangle) {
  return std::all_of(triangle.begin(), triangle.end(),
                     [&model](int v) { return model.normals[v].z == 0; }) &&
         std::abs(front_area(model, triangle)) < 1e-9;
}

std::vector<std::array<int, 3>> sheet_triangles(const Model& model, int part) {
  std::vector<std::array<int, 3>> sheets;
  for (size_t p = 0; p < model.parts.size(); ++p) {
    if (part >= 0 && p != static_cast<size_t>(part)) continue;
    const int first = model.parts[p].first_triangle;
    for (int t = first; t < first + model.parts[p].triangle_count; ++t)
      if (!is_wall(model, model.triangles[t])) sheets.push_back(model.triangles[t]);
  }
  return sheets;
}

double front_area(const Model& model, const std::vector<std::array<int, 3>>& triangles) {
  double area = 0;
  for (const auto& t : triangles) area += front_area(model, t);
  return area;
}

double worst_departure(const Model& model, const DiscRelief& relief, int part) {
  const std::array<std::array<double, 3>, 7> weights{{{1.0 / 3, 1.0 / 3, 1.0 / 3},
                                                      {0.5, 0.5, 0},
                                                      {0, 0.5, 0.5},
                                                      {0.5, 0, 0.5},
                                                      {0.75, 0.25, 0},
                                                      {0, 0.75, 0.25},
                                                      {0.25, 0, 0.75}}};
  double worst = 0;
  for (const auto& t : sheet_triangles(model, part))
    for (const auto& w : weights) {
      const Point3 p = w[0] * model.positions[t[0]] + w[1] * model.positions[t[1]] +
                       w[2] * model.positions[t[2]];
      const double z = face_height(relief, part, {p.x, model.height - p.y});
      worst = std::max(worst, std::abs(p.z - z));
    }
  return worst;
}

std::vector<unsigned char> model_bytes(const Model& model) {
  std::vector<unsigned char> bytes;
  append_bytes(model.positions, bytes);
  append_bytes(model.normals, bytes);
  append_bytes(model.uvs, bytes);
  append_bytes(model.triangles, bytes);
  for (const ModelPart& part : model.parts) {
    const std::vector<int> run{part.first_triangle, part.triangle_count};
    append_bytes(run, bytes);
  }
  return bytes;
}

}  // namespace relievo
