// Wanted shifts r of caps and spots (add_wanted), in scene units. On a cap with rim R and inner
// nodes I,
//
//   r_R = share max(0, f_below),    or 0 where nothing lies below
//   r_I = -A_II^-1 A_IR r_R
//
// On a spot, with w the area around a node that lies on something and p its position,
//
//   r = share (a + s . (p - m)),    (a, s) minimising  sum w (height_below - a - s . (p - m))^2
//
//   letter       in the code
//   A_II, A_IR   Cap::factor, coupling
//   f_below      f at the nodes of Cap::on
//   w            Rest::weight
//   m, a, s      middle, mean, slope in add_plane

#include "relief/ordering/cap_rise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "relief/ordering/limb_rise.h"
#include "relief/ordering/shift_metric.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// A cap covers a share of the other part's outline, with a share of its own, and has nothing
/// behind another share of its own. A part is no cap if any share is below `no_cap`, and a cap
/// altogether if all are above `whole_cap`.
constexpr double no_cap = 0.17;
constexpr double whole_cap = 0.25;

/// Grows from 0 to 1 with the share of a length in a whole.
double capped(double length, double whole) {
  return whole > 0 ? smooth_step(no_cap, whole_cap, length / whole) : 0;
}

/// Shares of a part's area that lie on what it is tied to: no spot below the first, altogether one
/// above the second.
constexpr double no_spot = 0.9;
constexpr double whole_spot = 0.98;

/// Checks whether the edge opposite to a corner of a face lies on the outline of its joined
/// surface.
bool is_on_outline(const LayeredMesh& mesh, int face, int corner) {
  const int across = face_across(mesh, face, corner);
  return across < 0 || mesh.is_flap(across);
}

/// Returns the length of a face's edges on the outline of its joined surface, px.
double outline_length(const LayeredMesh& mesh, int face) {
  double length = 0;
  const Triangle& vertices = mesh.triangles[mesh.face_triangle[face]];
  for (int k = 0; k < 3; ++k)
    if (is_on_outline(mesh, face, k))
      length +=
          distance(mesh.vertices[vertices[next_place(k)]], mesh.vertices[vertices[last_place(k)]]);
  return length;
}

/// Returns the degree to which a part is a cap of the part `lower` by the lengths with which their
/// outlines lie on each other, from 0 to 1. `outline`: length of each part's outline, px.
double contact_share(const LayeredMesh& mesh, const std::vector<int>& faces, int part, int lower,
                     const std::vector<double>& outline) {
  double own = 0;
  double other = 0;
  for (const int face : faces)
    for (int below = mesh.stack_begin[mesh.face_triangle[face]]; below < face; ++below) {
      if (mesh.is_flap(below) || mesh.face_part[below] != lower) continue;
      own += outline_length(mesh, face);
      other += outline_length(mesh, below);
    }
  return capped(own, outline[part]) * capped(other, outline[lower]);
}

/// Returns the degree to which a part is a cap, from 0 to 1. `tied`: parts that it may be a cap of.
double cap_share(const LayeredMesh& mesh, const std::vector<int>& faces, int part,
                 const std::vector<double>& outline, const std::set<int>& tied) {
  double open = 0;
  for (const int face : faces)
    if (face == mesh.stack_begin[mesh.face_triangle[face]]) open += outline_length(mesh, face);
  double most = 0;
  for (const int lower : tied)
    most = std::max(most, contact_share(mesh, faces, part, lower, outline));
  return most * capped(open, outline[part]);
}

/// Returns 0 for nodes off the part's outline, 1 for those with nothing behind them and 2 for the
/// other ones, #N.
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

/// Finds the cap's rim and the nodes that it lies on.
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

/// Finds the inner nodes among `nodes` and factorises the metric on them. Returns false if there
/// are none, or no factor.
bool find_inner(const std::vector<int>& elimination, const SparseMatrix& A, std::vector<int> nodes,
                Cap& cap) {
  sort_once(nodes);
  std::set_difference(nodes.begin(), nodes.end(), cap.rim.begin(), cap.rim.end(),
                      std::back_inserter(cap.inner));
  if (cap.inner.empty()) return false;
  const auto size = static_cast<int>(cap.inner.size());
  std::vector<int> index(static_cast<size_t>(A.cols()), -1);
  for (int i = 0; i < size; ++i) index[cap.inner[i]] = i;
  const SparseMatrix block = lower_block(A, index, size);
  cap.factor.analyse(block, Refactorisation::complete, order_of_places(elimination, index));
  cap.coupling.resize(size, static_cast<Eigen::Index>(cap.rim.size()));
  for (int j = 0; j < cap.coupling.cols(); ++j) {
    cap.coupling.startVec(j);
    for (SparseMatrix::InnerIterator entry(A, cap.rim[j]); entry; ++entry)
      if (index[entry.row()] >= 0) cap.coupling.insertBack(index[entry.row()], j) = entry.value();
  }
  cap.coupling.finalize();
  return cap.factor.factorise(block);
}

/// The area with which parts lie on those that they are tied to.
struct Rest {
  double area = 0;         ///< of the parts, px^2
  double resting = 0;      ///< of it, lies on others, px^2
  std::vector<int> nodes;  ///< of the parts
  VectorXd below;          ///< #N, height of what the node lies on
  VectorXd weight;         ///< #N, a third of the faces around the node that lie on something, px^2
};

/// Adds one part. `height`: #N.
void add_rest(const LayeredMesh& mesh, const std::vector<int>& faces, const std::set<int>& tied,
              const VectorXd& height, Rest& rest) {
  for (const int face : faces) {
    const Triangle& corners = mesh.triangles[mesh.face_triangle[face]];
    const Point2 a = mesh.vertices[corners[0]];
    const double area =
        std::abs(cross(mesh.vertices[corners[1]] - a, mesh.vertices[corners[2]] - a)) / 2;
    rest.area += area;
    rest.nodes.insert(rest.nodes.end(), mesh.faces[face].begin(), mesh.faces[face].end());
    const int begin = mesh.stack_begin[mesh.face_triangle[face]];
    int below = face - 1;
    while (below >= begin && (mesh.is_flap(below) || tied.count(mesh.face_part[below]) == 0))
      --below;
    if (below < begin) continue;
    rest.resting += area;
    for (int k = 0; k < 3; ++k) {
      const int n = mesh.faces[face][k];
      rest.below[n] = std::max(rest.below[n], height[mesh.faces[below][k]]);
      rest.weight[n] += area / 3;
    }
  }
}

/// Adds `share` times the plane nearest to what the nodes lie on, by the mean square, to `rise` and
/// `height`. Precondition: some area lies on others.
void add_plane(const LayeredMesh& mesh, const Rest& rest, double share, VectorXd& rise,
               VectorXd& height) {
  const auto position = [&mesh](int n) { return mesh.vertices[mesh.node_vertex[n]]; };
  Point2 middle;
  double mean = 0;
  for (const int n : rest.nodes) {
    middle = middle + rest.weight[n] / rest.resting * position(n);
    mean += rest.weight[n] / rest.resting * rest.below[n];
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  Point2 moment;
  for (const int n : rest.nodes) {
    const Point2 r = position(n) - middle;
    xx += rest.weight[n] * r.x * r.x;
    xy += rest.weight[n] * r.x * r.y;
    yy += rest.weight[n] * r.y * r.y;
    moment = moment + rest.weight[n] * (rest.below[n] - mean) * r;
  }
  const double determinant = xx * yy - xy * xy;
  Point2 slope;
  if (determinant > 0)
    slope = {(yy * moment.x - xy * moment.y) / determinant,
             (xx * moment.y - xy * moment.x) / determinant};
  for (const int n : rest.nodes) {
    rise[n] = share * (mean + dot(slope, position(n) - middle));
    height[n] += rise[n];
  }
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

std::vector<Cap> find_caps(const SurfaceInput& surface, const std::vector<std::set<int>>& tied,
                           const SparseMatrix& A) {
  const auto& [mesh, discretisation, scene] = surface;
  std::vector<Cap> caps;
  const std::vector<std::vector<int>> faces = faces_by_part(mesh);
  const std::vector<Join> joins = joins_by_upper(scene);
  std::vector<double> outline(faces.size(), 0);
  for (size_t part = 0; part < faces.size(); ++part)
    for (const int face : faces[part]) outline[part] += outline_length(mesh, face);
  for (int part = 0; part < mesh.part_count; ++part) {
    Cap cap;
    cap.part = part;
    if (!tied[part].empty()) cap.share = cap_share(mesh, faces[part], part, outline, tied[part]);
    if (!(cap.share > 0)) continue;
    find_rim(mesh, faces[part], tied[part], cap);
    std::vector<int> nodes;
    for (const int grown : grown_from(part, joins, scene.parts.size()))
      for (const int face : faces[grown])
        nodes.insert(nodes.end(), mesh.faces[face].begin(), mesh.faces[face].end());
    if (find_inner(discretisation.elimination, A, std::move(nodes), cap))
      caps.push_back(std::move(cap));
  }
  return caps;
}

VectorXd cap_rise(const std::vector<Cap>& caps, const Inflation& inflation, double scale) {
  const VectorXd f = scale * inflated_heights(inflation.u);
  VectorXd rise = VectorXd::Zero(f.size());
  for (const Cap& cap : caps) {
    VectorXd height = VectorXd::Zero(static_cast<Eigen::Index>(cap.rim.size()));
    for (const auto& [i, below] : cap.on) height[i] = std::max(height[i], f[below]);
    rise(cap.rim) = cap.share * height;
    rise(cap.inner) = cap.share * cap.factor.solve(-(cap.coupling * height));
  }
  return rise;
}

VectorXd spot_rise(const SurfaceInput& surface, const std::vector<std::set<int>>& tied,
                   const std::vector<Cap>& caps, VectorXd height) {
  const auto& [mesh, discretisation, scene] = surface;
  const std::vector<std::vector<int>> faces = faces_by_part(mesh);
  const std::vector<Join> joins = joins_by_upper(scene);
  std::vector<double> share(scene.parts.size(), 1);
  for (const Cap& cap : caps) share[cap.part] -= cap.share;
  VectorXd rise = VectorXd::Zero(height.size());
  for (int part = 0; part < mesh.part_count; ++part) {
    if (tied[part].empty() || share[part] <= 0) continue;
    Rest rest{0, 0, {}, VectorXd::Zero(height.size()), VectorXd::Zero(height.size())};
    for (const int grown : grown_from(part, joins, scene.parts.size()))
      add_rest(mesh, faces[grown], tied[part], height, rest);
    if (!(rest.resting > no_spot * rest.area)) continue;
    sort_once(rest.nodes);
    share[part] *= smooth_step(no_spot, whole_spot, rest.resting / rest.area);
    add_plane(mesh, rest, share[part], rise, height);
  }
  return rise;
}

}  // namespace relievo::relief
