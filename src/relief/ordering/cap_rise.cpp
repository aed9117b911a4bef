#include "relief/ordering/cap_rise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/ordering/limb_rise.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// Of the outline of what it lies on a cap covers a share, and of its own it has a share on that:
/// up to the first share of either there is no cap, from the second on it is one altogether.
constexpr double no_cap = 0.17;
constexpr double whole_cap = 0.25;

double smooth_step(double x) {
  const double t = std::clamp((x - no_cap) / (whole_cap - no_cap), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The faces of parts, but for flaps.
class PartFaces {
 public:
  explicit PartFaces(const SurfaceInput& surface)
      : mesh_(surface.mesh), of_part_(mesh_.part_count), surface_(mesh_.part_count, -1) {
    for (size_t face = 0; face < mesh_.faces.size(); ++face) {
      if (mesh_.is_flap(face)) continue;
      const int part = mesh_.face_part[face];
      of_part_[part].push_back(static_cast<int>(face));
      surface_[part] = surface.discretisation.surface[mesh_.faces[face][0]];
    }
  }

  const std::vector<int>& operator[](int part) const { return of_part_[part]; }
  bool are_joined(int part, int other) const { return surface_[part] == surface_[other]; }
  int part_count() const { return mesh_.part_count; }

  /// Calls visit(a, b) for the edges of the part that lie on the outline of its joined surface.
  template <class Visit>
  void visit_outline(int part, const Visit& visit) const {
    for (const int face : of_part_[part])
      for (int k = 0; k < 3; ++k) {
        const int a = mesh_.faces[face][(k + 1) % 3];
        const int b = mesh_.faces[face][(k + 2) % 3];
        if (is_edge_of_surface(mesh_.neighbours[mesh_.face_triangle[face]][k], a, b)) visit(a, b);
      }
  }

 private:
  /// Whether no face of that triangle has both nodes.
  bool is_edge_of_surface(int triangle, int a, int b) const {
    if (triangle < 0) return true;
    for (int face = mesh_.stack_begin[triangle]; face < mesh_.stack_begin[triangle + 1]; ++face) {
      const auto& corners = mesh_.faces[face];
      if (!mesh_.is_flap(face) && std::count(corners.begin(), corners.end(), a) > 0 &&
          std::count(corners.begin(), corners.end(), b) > 0)
        return false;
    }
    return true;
  }

  const LayeredMesh& mesh_;
  std::vector<std::vector<int>> of_part_;
  std::vector<int> surface_;
};

/// Base vertices that belong to a set for now.
class VertexSet {
 public:
  explicit VertexSet(const LayeredMesh& mesh) : mesh_(mesh), stamp_(mesh.vertices.size(), 0) {}

  void restart() { ++now_; }
  void add(const std::vector<int>& faces) {
    for (const int face : faces)
      for (const int n : mesh_.faces[face]) stamp_[mesh_.node_vertex[n]] = now_;
  }
  bool has(int node) const { return stamp_[mesh_.node_vertex[node]] == now_; }

 private:
  const LayeredMesh& mesh_;
  std::vector<int> stamp_;
  int now_ = 0;
};

/// The share of an outline within a set, of all parts or of one.
struct Share {
  double within = 0;
  double length = 0;
  double value() const { return length > 0 ? within / length : 0; }
};

void add_outline(const LayeredMesh& mesh, const PartFaces& faces, int part, const VertexSet& set,
                 Share& share) {
  faces.visit_outline(part, [&](int a, int b) {
    const double length =
        distance(mesh.vertices[mesh.node_vertex[a]], mesh.vertices[mesh.node_vertex[b]]);
    share.length += length;
    if (set.has(a) && set.has(b)) share.within += length;
  });
}

/// What a cap lies on, and how much of a cap it is.
struct Cap {
  std::vector<int> lower;
  double amount = 0;
};

Cap find_cap(const SurfaceInput& surface, const PartFaces& faces, int part, VertexSet& set) {
  const Scene& scene = surface.scene;
  Cap cap;
  const bool grows = std::any_of(scene.joins.begin(), scene.joins.end(),
                                 [&](const Join& join) { return join.upper == part; });
  if (grows || scene.parts[part].lean != Point2{} || scene.parts[part].d < 0) return cap;
  for (const Relation& relation : scene.relations) {
    if (relation.upper != part || relation.kind != RelationKind::equal || relation.range ||
        scene.parts[relation.lower].d < 0 || faces.are_joined(part, relation.lower))
      continue;
    cap.lower.push_back(relation.lower);
    Share contact;
    set.restart();
    set.add(faces[relation.lower]);
    add_outline(surface.mesh, faces, part, set, contact);
    if (contact.value() <= no_cap) continue;
    Share cover;
    set.restart();
    set.add(faces[part]);
    add_outline(surface.mesh, faces, relation.lower, set, cover);
    const double amount = smooth_step(cover.value()) * smooth_step(contact.value());
    cap.amount = std::max(cap.amount, amount);
  }
  if (!(cap.amount > 0)) return cap;
  Share beside;
  set.restart();
  for (const int face : faces[part])
    if (face > surface.mesh.stack_begin[surface.mesh.face_triangle[face]]) set.add({face});
  add_outline(surface.mesh, faces, part, set, beside);
  cap.amount *= smooth_step(1 - beside.value());
  return cap;
}

/// #N flags: nodes of the part on triangles where something lies behind it.
std::vector<uint8_t> nodes_on_others(const LayeredMesh& mesh, const std::vector<int>& faces) {
  std::vector<uint8_t> on_others(mesh.node_vertex.size(), 0);
  for (const int face : faces)
    if (face > mesh.stack_begin[mesh.face_triangle[face]])
      for (const int n : mesh.faces[face]) on_others[n] = 1;
  return on_others;
}

/// The heights that are wanted along the cap's outline: NaN where they are not known.
void set_rim(const SurfaceInput& surface, const PartFaces& faces, int part, const Cap& cap,
             const VectorXd& f, VectorXd& wanted) {
  const LayeredMesh& mesh = surface.mesh;
  const std::vector<uint8_t> on_others = nodes_on_others(mesh, faces[part]);
  std::vector<double> below(mesh.vertices.size(), -1);
  for (const int lower : cap.lower)
    for (const int face : faces[lower])
      for (const int n : mesh.faces[face])
        below[mesh.node_vertex[n]] = std::max(below[mesh.node_vertex[n]], f[n]);
  const auto set = [&](int n) {
    const double height = below[mesh.node_vertex[n]];
    if (height >= 0 || on_others[n] == 0) wanted[n] = std::max(0.0, height);
  };
  faces.visit_outline(part, [&](int a, int b) {
    set(a);
    set(b);
  });
}

/// Fills in what is NaN on the parts so that the wanted heights cost least.
bool fill(const SurfaceInput& surface, const ShiftMetric& metric, const PartFaces& faces,
          const std::vector<int>& parts, VectorXd& wanted) {
  std::vector<int> place(surface.mesh.node_vertex.size(), -1);
  std::vector<int> inner;
  VectorXd held = VectorXd::Zero(wanted.size());
  for (const int part : parts)
    for (const int face : faces[part])
      for (const int n : surface.mesh.faces[face]) {
        if (!std::isnan(wanted[n]))
          held[n] = wanted[n];
        else
          inner.push_back(n);
      }
  std::sort(inner.begin(), inner.end());
  inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
  for (size_t i = 0; i < inner.size(); ++i) place[inner[i]] = static_cast<int>(i);
  const SparseMatrix block = lower_block(metric.A, place, static_cast<int>(inner.size()));
  SparseCholesky factor;
  factor.analyse(block, Refactorisation::complete,
                 order_of_places(surface.discretisation.elimination, place));
  if (!factor.factorise(block)) return false;
  const VectorXd load = -(metric.A * held);
  wanted(inner) = factor.solve(load(inner));
  return true;
}

}  // namespace

VectorXd cap_rise(const SurfaceInput& surface, const Inflation& inflation,
                  const ShiftMetric& metric) {
  const auto nodes = static_cast<Eigen::Index>(inflation.u.size());
  VectorXd rise = VectorXd::Zero(nodes);
  const PartFaces faces(surface);
  const std::vector<Join> joins = joins_by_upper(surface.scene);
  VertexSet set(surface.mesh);
  VectorXd f;
  for (int part = 0; part < faces.part_count(); ++part) {
    const Cap cap = find_cap(surface, faces, part, set);
    if (!(cap.amount > 0)) continue;
    if (f.size() == 0) f = surface.discretisation.scale * inflated_heights(inflation.u);
    VectorXd wanted = VectorXd::Constant(nodes, std::nan(""));
    set_rim(surface, faces, part, cap, f, wanted);
    const std::vector<int> grown = grown_from(part, joins, surface.scene.parts.size());
    if (!fill(surface, metric, faces, grown, wanted)) continue;
    for (Eigen::Index n = 0; n < nodes; ++n)
      if (!std::isnan(wanted[n])) rise[n] = cap.amount * wanted[n];
  }
  return rise;
}

}  // namespace relievo
