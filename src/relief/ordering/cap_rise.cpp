#include "relief/ordering/cap_rise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/geometry/polygon.h"
#include "relief/ordering/limb_rise.h"
#include "relief/ordering/shift_metric.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// Of the outline of what it lies on a cap covers a share, of its own it has one on that, and one
/// with nothing behind it: up to the first share of any there is no cap, from the second on of all
/// it is one altogether.
constexpr double no_cap = 0.17;
constexpr double whole_cap = 0.25;

/// From 0 to 1 with the share of a length in a whole.
double capped(double length, double whole) {
  return whole > 0 ? smooth_step(no_cap, whole_cap, length / whole) : 0;
}

/// Of the area of a spot this much lies on what it is tied to, and all of it counts as doing so.
constexpr double no_spot = 0.9;
constexpr double whole_spot = 0.98;

/// Whether the edge opposite to a corner of a face lies on the outline of its joined surface.
bool is_on_outline(const LayeredMesh& mesh, int face, int corner) {
  const int across = face_across(mesh, face, corner);
  return across < 0 || mesh.is_flap(across);
}

/// How much of the outline of its joined surface belongs to a face, px.
double outline_length(const LayeredMesh& mesh, int face) {
  double length = 0;
  const Triangle& vertices = mesh.triangles[mesh.face_triangle[face]];
  for (int k = 0; k < 3; ++k)
    if (is_on_outline(mesh, face, k))
      length +=
          distance(mesh.vertices[vertices[next_place(k)]], mesh.vertices[vertices[last_place(k)]]);
  return length;
}

/// What parts lie on each other with, px.
struct Contact {
  double own = 0;    ///< of the upper part's outline
  double other = 0;  ///< of the lower part's outline
};

/// How much of a cap the part is, from 0 to 1. `outline`: length of each part's, px. `tied`: parts
/// that it may be a cap of.
double cap_share(const LayeredMesh& mesh, const std::vector<int>& faces, int part,
                 const std::vector<double>& outline, const std::set<int>& tied) {
  std::map<int, Contact> contacts;
  double open = 0;
  for (const int face : faces) {
    const double length = outline_length(mesh, face);
    const int begin = mesh.stack_begin[mesh.face_triangle[face]];
    if (face == begin) open += length;
    for (int below = begin; below < face; ++below) {
      if (mesh.is_flap(below) || tied.count(mesh.face_part[below]) == 0) continue;
      Contact& contact = contacts[mesh.face_part[below]];
      contact.own += length;
      contact.other += outline_length(mesh, below);
    }
  }
  double most = 0;
  for (const auto& [lower, contact] : contacts)
    most =
        std::max(most, capped(contact.own, outline[part]) * capped(contact.other, outline[lower]));
  return most * capped(open, outline[part]);
}

/// #N: of nodes on the part's outline, 1 where nothing lies behind them and 2 elsewhere.
std::vector<uint8_t> outline_nodes(const LayeredMesh& mesh, const std::vector<int>& faces) {
  std::vector<uint8_t> kind(mesh.node_vertex.size(), 0);
  for (const int face : faces)
    for (int k = 0; k < 3; ++k)
      if (is_on_outline(mesh, face, k))
        for (const int corner : {next_place(k), last_place(k)}) kind[mesh.faces[face][corner]] = 1;
  for (const int face : faces)
    if (face > mesh.stack_begin[mesh.face_triangle[face]])
      for (const int n : mesh.faces[face])
        if (kind[n] != 0) kind[n] = 2;
  return kind;
}

void sort_once(std::vector<int>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// Fills in the cap's rim, and what it lies on.
void find_rim(const LayeredMesh& mesh, const std::vector<int>& faces, const std::set<int>& tied,
              Cap& cap) {
  const std::vector<uint8_t> kind = outline_nodes(mesh, faces);
  std::set<std::array<int, 2>> on;
  for (const int face : faces)
    for (int k = 0; k < 3; ++k) {
      const int n = mesh.faces[face][k];
      if (kind[n] == 1) cap.rim.push_back(n);
      if (kind[n] != 2) continue;
      for (int below = mesh.stack_begin[mesh.face_triangle[face]]; below < face; ++below)
        if (tied.count(mesh.face_part[below]) > 0) on.insert({n, mesh.faces[below][k]});
    }
  for (const auto& [n, below] : on) cap.rim.push_back(n);
  sort_once(cap.rim);
  for (const auto& [n, below] : on) {
    const auto at = std::lower_bound(cap.rim.begin(), cap.rim.end(), n);
    cap.on.push_back({static_cast<int>(at - cap.rim.begin()), below});
  }
}

/// Fills in what is between, among these nodes; false where there is nothing, or no factor.
bool find_inner(const std::vector<int>& elimination, const SparseMatrix& A, std::vector<int> nodes,
                Cap& cap) {
  sort_once(nodes);
  std::set_difference(nodes.begin(), nodes.end(), cap.rim.begin(), cap.rim.end(),
                      std::back_inserter(cap.inner));
  if (cap.inner.empty()) return false;
  const auto size = static_cast<int>(cap.inner.size());
  std::vector<int> place(static_cast<size_t>(A.cols()), -1);
  for (int i = 0; i < size; ++i) place[cap.inner[i]] = i;
  const SparseMatrix block = lower_block(A, place, size);
  cap.factor.analyse(block, Refactorisation::complete, order_of_places(elimination, place));
  cap.coupling.resize(size, static_cast<Eigen::Index>(cap.rim.size()));
  for (int j = 0; j < cap.coupling.cols(); ++j) {
    cap.coupling.startVec(j);
    for (SparseMatrix::InnerIterator entry(A, cap.rim[j]); entry; ++entry)
      if (place[entry.row()] >= 0) cap.coupling.insertBack(place[entry.row()], j) = entry.value();
  }
  cap.coupling.finalize();
  return cap.factor.factorise(block);
}

/// A node of parts that lie on others.
struct RestingNode {
  double below = 0;   ///< the height of what it lies on
  double weight = 0;  ///< px^2, of the faces around it that lie on something, 0 where none does
};

/// What parts lie on, of those that one is tied to.
struct Rest {
  double area = 0;                   ///< px^2, of the parts
  double resting = 0;                ///< that of it which lies on others
  std::map<int, RestingNode> nodes;  ///< of the parts, all of them
};

/// Adds what one part lies on. `height`: of all nodes.
void add_rest(const LayeredMesh& mesh, const std::vector<int>& faces, const std::set<int>& tied,
              const VectorXd& height, Rest& rest) {
  for (const int face : faces) {
    const Triangle& corners = mesh.triangles[mesh.face_triangle[face]];
    const Point2 a = mesh.vertices[corners[0]];
    const double area =
        std::abs(cross(mesh.vertices[corners[1]] - a, mesh.vertices[corners[2]] - a)) / 2;
    rest.area += area;
    for (const int n : mesh.faces[face]) rest.nodes[n];
    const int begin = mesh.stack_begin[mesh.face_triangle[face]];
    int below = face - 1;
    while (below >= begin && (mesh.is_flap(below) || tied.count(mesh.face_part[below]) == 0))
      --below;
    if (below < begin) continue;
    rest.resting += area;
    for (int k = 0; k < 3; ++k) {
      RestingNode& node = rest.nodes[mesh.faces[face][k]];
      node.below = std::max(node.below, height[mesh.faces[below][k]]);
      node.weight += area / 3;
    }
  }
}

/// A plane over the canvas.
struct Plane {
  Point2 middle;
  double height = 0;
  Point2 slope;

  double at(Point2 p) const { return height + dot(slope, p - middle); }
};

/// The plane that departs least from what parts lie on, by its mean square. Precondition: they do.
Plane plane_below(const LayeredMesh& mesh, const Rest& rest) {
  const auto place = [&mesh](int n) { return mesh.vertices[mesh.node_vertex[n]]; };
  Plane plane;
  for (const auto& [n, node] : rest.nodes) {
    plane.middle = plane.middle + node.weight / rest.resting * place(n);
    plane.height += node.weight / rest.resting * node.below;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  Point2 moment;
  for (const auto& [n, node] : rest.nodes) {
    const Point2 r = place(n) - plane.middle;
    xx += node.weight * r.x * r.x;
    xy += node.weight * r.x * r.y;
    yy += node.weight * r.y * r.y;
    moment = moment + node.weight * (node.below - plane.height) * r;
  }
  const double determinant = xx * yy - xy * xy;
  if (determinant > 0)
    plane.slope = {(yy * moment.x - xy * moment.y) / determinant,
                   (xx * moment.y - xy * moment.x) / determinant};
  return plane;
}

}  // namespace

std::vector<std::set<int>> tied_parts(const Scene& scene) {
  std::vector<std::set<int>> tied(scene.parts.size());
  for (const Relation& relation : scene.relations)
    if (is_tie(relation.kind) && !relation.range && scene.parts[relation.lower].d > 0)
      tied[relation.upper].insert(relation.lower);
  for (const Join& join : scene.joins) tied[join.upper].clear();
  for (size_t part = 0; part < tied.size(); ++part)
    if (scene.parts[part].lean != Point2{} || scene.parts[part].d < 0) tied[part].clear();
  return tied;
}

Caps find_caps(const LayeredMesh& mesh, const Discretisation& discretisation, const Scene& scene,
               const SparseMatrix& A) {
  Caps caps{tied_parts(scene), {}};
  const std::vector<std::vector<int>> faces = faces_by_part(mesh);
  const std::vector<Join> joins = joins_by_upper(scene);
  std::vector<double> outline(faces.size(), 0);
  for (size_t part = 0; part < faces.size(); ++part)
    for (const int face : faces[part]) outline[part] += outline_length(mesh, face);
  for (int part = 0; part < mesh.part_count; ++part) {
    const std::set<int>& tied = caps.tied[part];
    Cap cap;
    cap.part = part;
    if (!tied.empty()) cap.share = cap_share(mesh, faces[part], part, outline, tied);
    if (!(cap.share > 0)) continue;
    find_rim(mesh, faces[part], tied, cap);
    std::vector<int> nodes;
    for (const int grown : grown_from(part, joins, scene.parts.size()))
      for (const int face : faces[grown])
        nodes.insert(nodes.end(), mesh.faces[face].begin(), mesh.faces[face].end());
    if (find_inner(discretisation.elimination, A, std::move(nodes), cap))
      caps.caps.push_back(std::move(cap));
  }
  return caps;
}

VectorXd cap_rise(const Caps& caps, const Inflation& inflation, double scale) {
  const VectorXd f = scale * inflated_heights(inflation.u);
  VectorXd rise = VectorXd::Zero(f.size());
  for (const Cap& cap : caps.caps) {
    VectorXd height = VectorXd::Zero(static_cast<Eigen::Index>(cap.rim.size()));
    for (const auto& [place, below] : cap.on) height[place] = std::max(height[place], f[below]);
    rise(cap.rim) = cap.share * height;
    rise(cap.inner) = cap.share * cap.factor.solve(-(cap.coupling * height));
  }
  return rise;
}

VectorXd spot_rise(const LayeredMesh& mesh, const Scene& scene, const Caps& caps, VectorXd height) {
  const std::vector<std::vector<int>> faces = faces_by_part(mesh);
  const std::vector<Join> joins = joins_by_upper(scene);
  std::vector<double> share(scene.parts.size(), 1);
  for (const Cap& cap : caps.caps) share[cap.part] -= cap.share;
  VectorXd rise = VectorXd::Zero(height.size());
  for (int part = 0; part < mesh.part_count; ++part) {
    if (caps.tied[part].empty() || share[part] <= 0) continue;
    Rest rest;
    for (const int grown : grown_from(part, joins, scene.parts.size()))
      add_rest(mesh, faces[grown], caps.tied[part], height, rest);
    if (!(rest.resting > no_spot * rest.area)) continue;
    share[part] *= smooth_step(no_spot, whole_spot, rest.resting / rest.area);
    const Plane plane = plane_below(mesh, rest);
    for (const auto& [n, node] : rest.nodes) {
      rise[n] = share[part] * plane.at(mesh.vertices[mesh.node_vertex[n]]);
      height[n] += rise[n];
    }
  }
  return rise;
}

}  // namespace relievo::relief
