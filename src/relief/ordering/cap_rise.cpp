#include "relief/ordering/cap_rise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/ordering/limb_rise.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// Of the outline of what it lies on a cap covers a share, of its own it has one on that, and one
/// with nothing behind it: up to the first share of any there is no cap, from the second on of all
/// it is one altogether.
constexpr double no_cap = 0.17;
constexpr double whole_cap = 0.25;

/// From 0 to 1 with the share of a length in a whole.
double capped(double length, double whole) {
  if (!(whole > 0)) return 0;
  const double t = std::clamp((length / whole - no_cap) / (whole_cap - no_cap), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The faces of each part, but for flaps.
std::vector<std::vector<int>> faces_by_part(const LayeredMesh& mesh) {
  std::vector<std::vector<int>> faces(mesh.part_count);
  for (size_t face = 0; face < mesh.faces.size(); ++face)
    if (!mesh.is_flap(face)) faces[mesh.face_part[face]].push_back(static_cast<int>(face));
  return faces;
}

/// Whether the edge opposite to a corner of a face lies on the outline of its joined surface.
bool is_on_outline(const LayeredMesh& mesh, int face, int corner) {
  const int across = mesh.neighbours[mesh.face_triangle[face]][corner];
  if (across < 0) return true;
  const int a = mesh.faces[face][(corner + 1) % 3];
  const int b = mesh.faces[face][(corner + 2) % 3];
  for (int other = mesh.stack_begin[across]; other < mesh.stack_begin[across + 1]; ++other) {
    const Triangle& nodes = mesh.faces[other];
    if (!mesh.is_flap(other) && std::count(nodes.begin(), nodes.end(), a) > 0 &&
        std::count(nodes.begin(), nodes.end(), b) > 0)
      return false;
  }
  return true;
}

/// How much of the outline of its joined surface belongs to a face, px.
double outline_length(const LayeredMesh& mesh, int face) {
  double length = 0;
  const Triangle& vertices = mesh.triangles[mesh.face_triangle[face]];
  for (int k = 0; k < 3; ++k)
    if (is_on_outline(mesh, face, k))
      length +=
          distance(mesh.vertices[vertices[(k + 1) % 3]], mesh.vertices[vertices[(k + 2) % 3]]);
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

/// The heights that are wanted along the part's outline, NaN where they are not known and inside.
VectorXd wanted_on_outline(const LayeredMesh& mesh, const std::vector<int>& faces,
                           const std::set<int>& tied, const VectorXd& f) {
  VectorXd height = VectorXd::Constant(f.size(), -1);
  std::vector<uint8_t> on_others(mesh.node_vertex.size(), 0);
  for (const int face : faces)
    for (int below = mesh.stack_begin[mesh.face_triangle[face]]; below < face; ++below)
      for (int k = 0; k < 3; ++k) {
        const int n = mesh.faces[face][k];
        on_others[n] = 1;
        if (tied.count(mesh.face_part[below]) > 0)
          height[n] = std::max(height[n], f[mesh.faces[below][k]]);
      }
  VectorXd wanted = VectorXd::Constant(f.size(), std::nan(""));
  for (const int face : faces)
    for (int k = 0; k < 3; ++k) {
      if (!is_on_outline(mesh, face, k)) continue;
      for (const int n : {mesh.faces[face][(k + 1) % 3], mesh.faces[face][(k + 2) % 3]})
        if (height[n] >= 0 || on_others[n] == 0) wanted[n] = std::max(0.0, height[n]);
    }
  return wanted;
}

/// Fills in what is NaN at these nodes so that the wanted heights cost least; false where there is
/// nothing to fill in.
bool fill(const Discretisation& discretisation, const SparseMatrix& A, std::vector<int> nodes,
          VectorXd& wanted) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<int> place(static_cast<size_t>(wanted.size()), -1);
  std::vector<int> free;
  VectorXd held = VectorXd::Zero(wanted.size());
  for (const int n : nodes) {
    if (!std::isnan(wanted[n])) {
      held[n] = wanted[n];
    } else {
      place[n] = static_cast<int>(free.size());
      free.push_back(n);
    }
  }
  if (free.empty()) return false;
  const SparseMatrix block = lower_block(A, place, static_cast<int>(free.size()));
  SparseCholesky factor;
  factor.analyse(block, Refactorisation::complete,
                 order_of_places(discretisation.elimination, place));
  if (!factor.factorise(block)) return false;
  const VectorXd load = -(A * held);
  wanted(free) = factor.solve(load(free));
  return true;
}

/// The parts behind it that each part may be a cap of: those that it is tied to all along.
std::vector<std::set<int>> tied_parts(const Scene& scene) {
  std::vector<std::set<int>> tied(scene.parts.size());
  for (const Relation& relation : scene.relations)
    if (relation.kind == RelationKind::equal && !relation.range &&
        scene.parts[relation.lower].d > 0)
      tied[relation.upper].insert(relation.lower);
  for (const Join& join : scene.joins) tied[join.upper].clear();
  for (size_t part = 0; part < tied.size(); ++part)
    if (scene.parts[part].lean != Point2{} || scene.parts[part].d < 0) tied[part].clear();
  return tied;
}

}  // namespace

VectorXd cap_rise(const SurfaceInput& surface, const Inflation& inflation,
                  const ShiftMetric& metric) {
  const LayeredMesh& mesh = surface.mesh;
  const std::vector<std::vector<int>> faces = faces_by_part(mesh);
  const std::vector<std::set<int>> tied = tied_parts(surface.scene);
  const std::vector<Join> joins = joins_by_upper(surface.scene);
  std::vector<double> outline(faces.size(), 0);
  for (size_t part = 0; part < faces.size(); ++part)
    for (const int face : faces[part]) outline[part] += outline_length(mesh, face);
  const VectorXd f = surface.discretisation.scale * inflated_heights(inflation.u);
  VectorXd rise = VectorXd::Zero(f.size());
  for (int part = 0; part < mesh.part_count; ++part) {
    if (tied[part].empty()) continue;
    const double share = cap_share(mesh, faces[part], part, outline, tied[part]);
    if (!(share > 0)) continue;
    VectorXd wanted = wanted_on_outline(mesh, faces[part], tied[part], f);
    std::vector<int> nodes;
    for (const int grown : grown_from(part, joins, surface.scene.parts.size()))
      for (const int face : faces[grown])
        nodes.insert(nodes.end(), mesh.faces[face].begin(), mesh.faces[face].end());
    if (!fill(surface.discretisation, metric.A, std::move(nodes), wanted)) continue;
    for (Eigen::Index n = 0; n < rise.size(); ++n)
      if (!std::isnan(wanted[n])) rise[n] = share * wanted[n];
  }
  return rise;
}

}  // namespace relievo
