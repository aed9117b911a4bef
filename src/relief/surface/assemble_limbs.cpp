#include "relief/surface/assemble_limbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <set>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "relief/surface/assemble_model.h"

namespace relievo::relief {
namespace {

/// Share of a loose part's area that must lie on the limb for the part to go with it.
constexpr double resting_share = 0.8;
/// Depth of a limb at its join, of that of its trunk.
constexpr double root_share = 0.7;
/// Drawing in at the limb's free outline on the trunk, of that at its join.
constexpr double rim_share = 0.4;
/// Least distance of a limb from the middle of its trunk, of the limb's mean half depth.
constexpr double least_offset = 0.15;
/// Distances, in widths of the join, over which the drawing in fades: from the join, from the free
/// outline, and from the points where the limb leaves the trunk.
constexpr double root_reach = 0.75;
constexpr double rim_reach = 0.25;
constexpr double leaving_reach = 0.375;

constexpr double unreached = std::numeric_limits<double>::infinity();

/// Returns the part that a limb grows out of, the largest of several; or -1.
int trunk_of(const Scene& scene, const std::vector<double>& areas, int limb) {
  int trunk = -1;
  for (const Join& join : scene.joins)
    if (join.upper == limb && (trunk < 0 || areas[join.lower] > areas[trunk])) trunk = join.lower;
  return trunk;
}

/// Returns the area of each part, px^2.
std::vector<double> part_areas(const LayeredMesh& mesh, const std::vector<double>& areas) {
  std::vector<double> of_part(mesh.part_count, 0);
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    of_part[mesh.face_part[f]] += areas[mesh.face_triangle[f]];
  return of_part;
}

/// Returns for each part whether it is joined to the limb other than through the trunk.
std::vector<char> joined_to(const Scene& scene, int limb, int trunk) {
  std::vector<char> member(scene.parts.size(), 0);
  std::vector<int> open{limb};
  member[limb] = 1;
  while (!open.empty()) {
    const int part = open.back();
    open.pop_back();
    for (const Join& join : scene.joins)
      if (join.upper == part || join.lower == part) {
        const int other = join.upper == part ? join.lower : join.upper;
        if (other == trunk || member[other] != 0) continue;
        member[other] = 1;
        open.push_back(other);
      }
  }
  return member;
}

/// Adds the parts that are joined to nothing and lie on the limb. `areas`: of triangles, `whole`:
/// of parts, px^2.
void add_resting(const LayeredMesh& mesh, const Scene& scene, const std::vector<double>& areas,
                 const std::vector<double>& whole, std::vector<char>& member) {
  std::vector<char> free(scene.parts.size(), 1);
  for (const Join& join : scene.joins) free[join.upper] = free[join.lower] = 0;
  for (int part = 0; part < static_cast<int>(scene.parts.size()); ++part) {
    if (free[part] == 0) continue;
    double resting = 0;
    for (size_t f = 1; f < mesh.faces.size(); ++f)
      if (mesh.face_part[f] == part && mesh.face_triangle[f - 1] == mesh.face_triangle[f] &&
          member[mesh.face_part[f - 1]] != 0)
        resting += areas[mesh.face_triangle[f]];
    if (resting > resting_share * whole[part]) member[part] = 1;
  }
}

/// A relief of some of the parts.
struct PartialRelief {
  LayeredMesh mesh;
  Inflation inflation;
  Ordering ordering;
};

/// Returns the faces of some parts; all nodes stay.
PartialRelief faces_of(const SolvedSurface& surface, const std::vector<char>& member) {
  const auto& [mesh, inflation, ordering, scene] = surface;
  PartialRelief limb{mesh, inflation, ordering};
  LayeredMesh& kept = limb.mesh;
  kept.face_triangle.clear();
  kept.face_part.clear();
  kept.face_source.clear();
  kept.faces.clear();
  kept.face_flap.clear();
  kept.creases.clear();
  std::vector<int> number(mesh.faces.size(), -1);
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    kept.stack_begin[t] = static_cast<int>(kept.faces.size());
    for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f) {
      if (member[mesh.face_part[f]] == 0) continue;
      number[f] = static_cast<int>(kept.faces.size());
      kept.face_triangle.push_back(mesh.face_triangle[f]);
      kept.face_part.push_back(mesh.face_part[f]);
      kept.faces.push_back(mesh.faces[f]);
      if (!mesh.face_source.empty()) kept.face_source.push_back(mesh.face_source[f]);
      if (!mesh.face_flap.empty()) kept.face_flap.push_back(mesh.face_flap[f]);
    }
  }
  kept.stack_begin.back() = static_cast<int>(kept.faces.size());
  const auto renumbered = [&number](Corner corner) {
    const int face = number[triangle_of(corner)];
    return face < 0 ? -1 : corner_of(face, place_of(corner));
  };
  for (CreaseEdge edge : mesh.creases) {
    for (Corner& corner : edge.corner) corner = renumbered(corner);
    if (edge.corner[0] >= 0 && edge.corner[1] >= 0) kept.creases.push_back(edge);
  }
  limb.ordering.creases = {};
  for (size_t i = 0; i < ordering.creases.corner.size(); ++i)
    if (const Corner corner = renumbered(ordering.creases.corner[i]); corner >= 0) {
      limb.ordering.creases.corner.push_back(corner);
      limb.ordering.creases.gradient.push_back(ordering.creases.gradient[i]);
    }
  // Faces cross parts that hid them, which are not there.
  limb.ordering.crossing.clear();
  return limb;
}

/// The depth range of all parts at a base vertex, px.
struct Column {
  double back = unreached;
  double front = -unreached;
};

std::vector<Column> columns_of(const SolvedSurface& surface) {
  const auto& [mesh, inflation, ordering, scene] = surface;
  std::vector<Column> columns(mesh.vertices.size());
  for (const Triangle& face : mesh.faces)
    for (const int n : face) {
      Column& column = columns[mesh.node_vertex[n]];
      const double raised = ordering.lowered.empty() ? 0 : ordering.lowered[n];
      column.front = std::max(column.front, ordering.h[n]);
      column.back =
          std::min(column.back, ordering.g[n] + raised - std::sqrt(std::abs(inflation.u[n])));
    }
  return columns;
}

/// The root of a limb: its join with the trunk, and the points where it leaves the trunk.
class LimbRoot {
 public:
  LimbRoot(const LayeredMesh& mesh, const std::vector<char>& member, int trunk)
      : mesh_(mesh),
        edges_(mesh.vertices.size()),
        leaving_(mesh.vertices.size(), 0),
        of_limb_(mesh.node_vertex.size(), 0) {
    for (size_t t = 0; t < mesh.triangles.size(); ++t) add_triangle(t, member, trunk);
    std::set<int> joined;
    for (size_t f = 0; f < mesh.faces.size(); ++f)
      if (member[mesh.face_part[f]] == 0)
        for (const int n : mesh.faces[f])
          if (of_limb_[n] != 0) joined.insert(n);
    joined_.assign(joined.begin(), joined.end());
  }

  /// Returns the nodes that the limb shares with other parts, ascending.
  const std::vector<int>& joined() const { return joined_; }

  /// Returns how far the limb is drawn in, by base vertex: 1 at its join, 0 where it leaves the
  /// trunk.
  std::vector<double> depth() const {
    const auto from_join = spread([this](std::vector<double>& distance) {
      for (const int n : joined_) distance[mesh_.node_vertex[n]] = 0;
    });
    const auto from_leaving = spread([this](std::vector<double>& distance) {
      for (size_t v = 0; v < leaving_.size(); ++v)
        if (leaving_[v] != 0) distance[v] = 0;
    });
    const auto from_rim = spread([this](std::vector<double>& distance) {
      for (size_t n = 0; n < of_limb_.size(); ++n)
        if (of_limb_[n] != 0 &&
            (mesh_.node_role[n] == NodeRole::outline || mesh_.node_role[n] == NodeRole::ramp))
          distance[mesh_.node_vertex[n]] = 0;
    });
    const double reach = root_reach * width();
    std::vector<double> depth(mesh_.vertices.size(), 0);
    for (size_t v = 0; v < depth.size(); ++v) {
      const double join = std::max(0.0, 1 - from_join[v] / reach);
      const double rim = std::max(0.0, 1 - from_rim[v] / (rim_reach * width()));
      const double leaving = std::min(1.0, from_leaving[v] / (leaving_reach * width()));
      depth[v] = from_join[v] == 0 ? 1 : leaving * std::max(join, rim_share * rim);
    }
    return depth;
  }

 private:
  void add_triangle(size_t t, const std::vector<char>& member, int trunk) {
    bool limb = false;
    bool carried = false;
    for (int f = mesh_.stack_begin[t]; f < mesh_.stack_begin[t + 1]; ++f) {
      carried = carried || mesh_.face_part[f] == trunk;
      if (member[mesh_.face_part[f]] == 0) continue;
      limb = true;
      for (const int n : mesh_.faces[f]) of_limb_[n] = 1;
    }
    if (!limb) return;
    const Triangle& triangle = mesh_.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const int next = triangle[next_place(k)];
      const double length = distance(mesh_.vertices[triangle[k]], mesh_.vertices[next]);
      edges_[triangle[k]].emplace_back(next, length);
      edges_[next].emplace_back(triangle[k], length);
      if (!carried) leaving_[triangle[k]] = 1;
    }
  }

  /// Returns the width of the join, px.
  double width() const {
    Box2 box;
    for (const int n : joined_) box.add(mesh_.vertices[mesh_.node_vertex[n]]);
    return box.diagonal();
  }

  /// Returns the distances along the edges of the limb's triangles to the vertices at which `begin`
  /// sets 0.
  template <class Begin>
  std::vector<double> spread(Begin begin) const {
    std::vector<double> distance(mesh_.vertices.size(), unreached);
    begin(distance);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (size_t v = 0; v < distance.size(); ++v)
      if (distance[v] == 0) open.emplace(0, static_cast<int>(v));
    while (!open.empty()) {
      const auto [so_far, v] = open.top();
      open.pop();
      if (so_far > distance[v]) continue;
      for (const auto& [next, length] : edges_[v])
        if (so_far + length < distance[next]) {
          distance[next] = so_far + length;
          open.emplace(distance[next], next);
        }
    }
    return distance;
  }

  const LayeredMesh& mesh_;
  std::vector<std::vector<std::pair<int, double>>> edges_;  ///< of the limb, by base vertex
  std::vector<char> leaving_;  ///< by base vertex, whether a triangle beside it is off the trunk
  std::vector<char> of_limb_;  ///< by node
  std::vector<int> joined_;
};

/// Draws the root of a limb in, so that the mirrored root ends inside the columns: with depth s,
/// f <- (1 - s) f + s min(f, root_share half depth) and g <- (1 - s) g + s (2 middle - column
/// middle).
void draw_in(const std::vector<double>& depth, const std::vector<Column>& columns, double middle,
             PartialRelief& limb) {
  std::vector<char> done(limb.mesh.node_vertex.size(), 0);
  for (const Triangle& face : limb.mesh.faces)
    for (const int n : face) {
      if (std::exchange(done[n], 1) != 0) continue;
      const int v = limb.mesh.node_vertex[n];
      const double s = depth[v];
      const double thick = 0.5 * (columns[v].front - columns[v].back);
      const double f = std::sqrt(std::abs(limb.inflation.u[n]));
      const double drawn = (1 - s) * f + s * std::min(f, root_share * thick);
      const double inside = 2 * middle - 0.5 * (columns[v].front + columns[v].back);
      double& g = limb.ordering.g[n];
      g = (1 - s) * g + s * inside;
      limb.inflation.u[n] = std::copysign(drawn * drawn, limb.inflation.u[n]);
      limb.ordering.h[n] = g + signed_root(limb.inflation.u[n]);
    }
}

/// Returns whether the part of a limb that is not drawn in lies about the middle, so that its
/// mirror image is much the same.
bool in_the_middle(const PartialRelief& limb, const std::vector<double>& depth, double middle) {
  double off = 0;
  double thick = 0;
  for (const Triangle& face : limb.mesh.faces)
    for (const int n : face) {
      const double free = 1 - depth[limb.mesh.node_vertex[n]];
      off += free * std::abs(limb.ordering.g[n] - middle);
      thick += free * std::sqrt(std::abs(limb.inflation.u[n]));
    }
  return off < least_offset * thick;
}

/// Raises sheets that were lowered to hide them.
void raise_lowered(Ordering& ordering) {
  for (size_t n = 0; n < ordering.lowered.size(); ++n) {
    ordering.g[n] += ordering.lowered[n];
    ordering.h[n] += ordering.lowered[n];
  }
  ordering.lowered.clear();
}

Result<int> part_named(const Scene& scene, const std::string& id) {
  for (size_t p = 0; p < scene.parts.size(); ++p)
    if (scene.parts[p].id == id) return static_cast<int>(p);
  return Error{ErrorCode::usage, "there is no part \"" + id + "\"", "--mirror"};
}

}  // namespace

Result<std::vector<LimbSheet>> assemble_limbs(const SolvedSurface& surface,
                                              const std::vector<std::string>& ids,
                                              const RunContext& context) {
  const auto& [mesh, inflation, ordering, scene] = surface;
  std::vector<LimbSheet> limbs;
  if (ids.empty()) return limbs;
  const std::vector<double> areas = triangle_areas({mesh.vertices, mesh.triangles});
  const std::vector<double> of_parts = part_areas(mesh, areas);
  const std::vector<Column> columns = columns_of(surface);
  for (const std::string& id : std::set<std::string>(ids.begin(), ids.end())) {
    const auto part = part_named(scene, id);
    if (!part) return part.error();
    const int trunk = trunk_of(scene, of_parts, *part);
    std::vector<char> member = joined_to(scene, *part, trunk);
    add_resting(mesh, scene, areas, of_parts, member);
    const LimbRoot root(mesh, member, trunk);
    if (trunk < 0 || root.joined().empty())
      return Error{ErrorCode::usage, "\"" + id + "\" is joined to no part behind it", "--mirror"};
    double middle = 0;
    for (const int n : root.joined()) middle += ordering.g[n];
    middle /= static_cast<double>(root.joined().size());
    PartialRelief limb = faces_of(surface, member);
    raise_lowered(limb.ordering);
    const std::vector<double> depth = root.depth();
    if (in_the_middle(limb, depth, middle))
      return Error{ErrorCode::usage,
                   "\"" + id + "\" lies in the middle of \"" + scene.parts[trunk].id +
                       "\": its mirror image is itself",
                   "--mirror"};
    draw_in(depth, columns, middle, limb);
    auto sheet =
        assemble_visible_sheet({limb.mesh, limb.inflation, limb.ordering, scene}, {}, context);
    if (!sheet) return sheet.error();
    limbs.push_back({id, middle, std::move(*sheet)});
  }
  return limbs;
}

}  // namespace relievo::relief
