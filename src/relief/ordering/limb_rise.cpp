#include "relief/ordering/limb_rise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "kernel/geometry/polygon.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What reaches the first share of the root's width at most is a lump, the second at least a limb.
constexpr double lump = 1;
constexpr double slender = 1.75;
/// From this share of its reach on a limb has its own height.
constexpr double far_share = 0.6;
/// It has come down where this share of the fall is left.
constexpr double rest_of_fall = 0.1;
constexpr double least_fade = 1.5;  ///< of the root's width
/// A limb comes forward by so much of its own height at most, or a thin leg would hang before a
/// thick belly.
constexpr double largest_rise = 1.5;
/// Distances without ridges are to some of more points than this, from so many of their steps on,
/// little by little.
constexpr size_t most_points = 64;
constexpr double far_steps = 4;

/// Nodes by part, each once, of faces that no part grows out of.
struct PartNodes {
  std::vector<std::vector<int>> faces;  ///< by part
  std::vector<std::vector<int>> of_part;
  std::vector<int> parts;  ///< #N how many parts share the node
};

PartNodes nodes_by_part(const LayeredMesh& mesh) {
  PartNodes nodes{faces_by_part(mesh), std::vector<std::vector<int>>(mesh.part_count),
                  std::vector<int>(mesh.node_vertex.size(), 0)};
  std::vector<int> last(mesh.node_vertex.size(), -1);
  for (int part = 0; part < mesh.part_count; ++part)
    for (const int face : nodes.faces[part])
      for (const int n : mesh.faces[face])
        if (std::exchange(last[n], part) != part) {
          nodes.of_part[part].push_back(n);
          ++nodes.parts[n];
        }
  return nodes;
}

/// A joined part with all that grows out of it.
struct Limb {
  std::vector<int> nodes;  ///< the limb's own first, then those of what grows out of it alone
  size_t own = 0;          ///< how many are its own
  std::vector<std::array<int, 2>> edges;  ///< its own, places in `nodes`, some twice
  std::vector<double> height;             ///< of each node, f, scene units
  std::vector<double> distance;           ///< of each node to the root, scene units
  std::vector<double> reach;              ///< the same without ridges
  double width = 0;                       ///< of the root
  double top = 0;                         ///< largest height there
};

/// A point of a root with the length of it that the point stands for.
struct RootPoint {
  Point2 at;
  double length = 0;
};

/// Points in runs of about the square root of their number, each run with its box.
class PointRuns {
 public:
  explicit PointRuns(std::vector<RootPoint> points, const Box2& box) : points_(std::move(points)) {
    const bool wide = box.max.x - box.min.x > box.max.y - box.min.y;
    std::sort(points_.begin(), points_.end(), [&](const RootPoint& a, const RootPoint& b) {
      const Point2 p = a.at;
      const Point2 q = b.at;
      return wide ? std::tie(p.x, p.y) < std::tie(q.x, q.y)
                  : std::tie(p.y, p.x) < std::tie(q.y, q.x);
    });
    run_ = static_cast<size_t>(std::ceil(std::sqrt(static_cast<double>(points_.size()))));
    for (size_t i = 0; i < points_.size(); ++i) {
      if (i % run_ == 0) boxes_.emplace_back();
      boxes_.back().add(points_[i].at);
      length_ += points_[i].length;
    }
  }

  double distance_to(Point2 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < boxes_.size(); ++k) {
      const Box2& box = boxes_[k];
      const Point2 out{std::max({box.min.x - p.x, p.x - box.max.x, 0.0}),
                       std::max({box.min.y - p.y, p.y - box.max.y, 0.0})};
      if (dot(out, out) > least) continue;
      const size_t end = std::min(points_.size(), (k + 1) * run_);
      for (size_t i = k * run_; i < end; ++i)
        least = std::min(least, dot(points_[i].at - p, points_[i].at - p));
    }
    return std::sqrt(least);
  }

  /// A distance without ridges where two points are equally near: that of the straight line which
  /// would make the integral of distance^-5 along it as large. `distance`: the least one, not 0.
  double smooth_distance_to(Point2 p, double distance) const {
    // An odd stride takes both arms of a bent root. From so far on it makes little difference.
    const size_t stride = points_.size() / most_points * 2 + 1;
    const double gap = length_ / static_cast<double>(points_.size()) * static_cast<double>(stride);
    const double far = smooth_step(far_steps * gap, 2 * far_steps * gap, distance);
    double sum = 0;
    if (far < 1) sum += (1 - far) * integral_to(p, 1);
    if (far > 0) sum += far * integral_to(p, stride);
    // Roots have the same bits everywhere, powers have not.
    return 1 / std::sqrt(std::sqrt(0.75 * sum));
  }

 private:
  /// Of distance^-5, by every stride-th point.
  double integral_to(Point2 p, size_t stride) const {
    double sum = 0;
    double length = 0;
    for (size_t i = stride / 2; i < points_.size(); i += stride) {
      const double square = dot(points_[i].at - p, points_[i].at - p);
      sum += points_[i].length / (square * square * std::sqrt(square));
      length += points_[i].length;
    }
    return length_ / length * sum;
  }

  std::vector<RootPoint> points_;
  double length_ = 0;
  std::vector<Box2> boxes_;
  size_t run_ = 1;
};

/// The edges between the limb and what it grows out of, ends ascending: those of one face of it.
/// `is_root`: #N flags.
std::vector<std::array<int, 2>> root_edges(const LayeredMesh& mesh, const PartNodes& nodes,
                                           const std::vector<int>& grown,
                                           const std::vector<uint8_t>& is_root) {
  std::vector<std::array<int, 2>> edges;
  for (const int part : grown)
    for (const int face : nodes.faces[part])
      for (int k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(mesh.faces[face][k], mesh.faces[face][(k + 1) % 3]);
        if (is_root[a] != 0 && is_root[b] != 0) edges.push_back({a, b});
      }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<int, 2>> once;
  for (size_t i = 0; i < edges.size(); ++i)
    if ((i == 0 || edges[i] != edges[i - 1]) && (i + 1 == edges.size() || edges[i] != edges[i + 1]))
      once.push_back(edges[i]);
  return once;
}

/// The edges of a part's faces, by the places of its nodes in `own`, which begins with them.
std::vector<std::array<int, 2>> own_edges(const LayeredMesh& mesh, const std::vector<int>& faces,
                                          const std::vector<int>& own) {
  std::vector<int> place(mesh.node_vertex.size(), -1);
  for (size_t i = 0; i < own.size(); ++i) place[own[i]] = static_cast<int>(i);
  std::vector<std::array<int, 2>> edges;
  for (const int face : faces)
    for (int k = 0; k < 3; ++k)
      edges.push_back({place[mesh.faces[face][k]], place[mesh.faces[face][(k + 1) % 3]]});
  return edges;
}

/// The largest value on the limb's edges where the level is at least `least`, both linear along
/// them: nodes are far apart in the middle of a limb. 0 where it is so nowhere.
double largest_where(const Limb& limb, const std::vector<double>& value,
                     const std::vector<double>& level, double least) {
  double largest = 0;
  for (const auto& [a, b] : limb.edges) {
    const bool reached[2] = {level[a] >= least, level[b] >= least};
    if (reached[0]) largest = std::max(largest, value[a]);
    if (reached[1]) largest = std::max(largest, value[b]);
    if (reached[0] == reached[1]) continue;
    const double share = (least - level[a]) / (level[b] - level[a]);
    largest = std::max(largest, value[a] + share * (value[b] - value[a]));
  }
  return largest;
}

/// Heights are in the direction in which the part is inflated.
Limb make_limb(const SurfaceInput& surface, const VectorXd& f, const PartNodes& nodes,
               const std::vector<int>& grown) {
  const LayeredMesh& mesh = surface.mesh;
  const double sign = surface.scene.parts[grown.front()].d < 0 ? -1 : 1;
  Limb limb;
  std::vector<int> in_limb(mesh.node_vertex.size(), 0);
  for (const int part : grown) {
    for (const int n : nodes.of_part[part])
      if (in_limb[n]++ == 0) limb.nodes.push_back(n);
    if (part == grown.front()) limb.own = limb.nodes.size();
  }
  std::vector<uint8_t> is_root(mesh.node_vertex.size(), 0);
  std::vector<RootPoint> root;
  Box2 box;
  const double scale = surface.discretisation.scale;
  const auto at = [&](int n) { return scale * mesh.vertices[mesh.node_vertex[n]]; };
  for (const int n : limb.nodes) {
    limb.height.push_back(sign * f[n]);
    if (in_limb[n] == nodes.parts[n]) continue;
    is_root[n] = 1;
    box.add(at(n));
    limb.top = std::max(limb.top, limb.height.back());
  }
  limb.edges = own_edges(mesh, nodes.faces[grown.front()], limb.nodes);
  for (const auto& [a, b] : root_edges(mesh, nodes, grown, is_root))
    root.push_back({0.5 * (at(a) + at(b)), distance(at(a), at(b))});
  if (root.empty()) return limb;
  limb.width = box.diagonal();
  const PointRuns runs(std::move(root), box);
  for (const int n : limb.nodes) {
    limb.distance.push_back(is_root[n] != 0 ? 0 : runs.distance_to(at(n)));
    const double least = limb.distance.back();
    limb.reach.push_back(least > 0 ? runs.smooth_distance_to(at(n), least) : 0);
  }
  return limb;
}

/// `sign`: of the part's inflation.
void add_rise(const Limb& limb, double sign, VectorXd& rise) {
  double reach = 0;
  for (size_t i = 0; i < limb.own; ++i) reach = std::max(reach, limb.distance[i]);
  const double crest = largest_where(limb, limb.height, limb.distance, far_share * reach);
  const double fall = limb.top - crest;
  const double amount =
      smooth_step(lump, slender, reach / limb.width) * std::min(fall, largest_rise * crest);
  if (!(amount > 0)) return;
  const double length =
      std::max(least_fade * limb.width,
               largest_where(limb, limb.distance, limb.height, crest + rest_of_fall * fall));
  std::vector<double> nearness = limb.distance;
  for (double& distance : nearness) distance = -distance;
  const double end = largest_where(limb, limb.reach, nearness, -length);
  // No node lies beside a root that is shorter than the edges.
  if (end == 0) return;
  for (size_t i = 0; i < limb.nodes.size(); ++i)
    rise[limb.nodes[i]] += sign * amount * smooth_step(0, end, limb.reach[i]);
}

}  // namespace

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

std::vector<Join> joins_by_upper(const Scene& scene) {
  std::vector<Join> joins = scene.joins;
  std::stable_sort(joins.begin(), joins.end(),
                   [](const Join& a, const Join& b) { return a.upper < b.upper; });
  return joins;
}

std::vector<int> grown_from(int part, const std::vector<Join>& by_upper, size_t parts) {
  std::vector<uint8_t> is_grown(parts, 0);
  is_grown[part] = 1;
  std::vector<int> grown = {part};
  for (const Join& join : by_upper)
    if (is_grown[join.lower] != 0 && std::exchange(is_grown[join.upper], 1) == 0)
      grown.push_back(join.upper);
  return grown;
}

VectorXd limb_rise(const SurfaceInput& surface, const Inflation& inflation) {
  const Scene& scene = surface.scene;
  VectorXd rise = VectorXd::Zero(static_cast<Index>(inflation.u.size()));
  const std::vector<Join> joins = joins_by_upper(scene);
  const VectorXd f = surface.discretisation.scale * inflated_heights(inflation.u);
  const PartNodes nodes = nodes_by_part(surface.mesh);
  for (size_t i = 0; i < joins.size(); ++i) {
    const int part = joins[i].upper;
    if (i > 0 && joins[i - 1].upper == part) continue;
    if (scene.parts[part].lean != Point2{}) continue;
    const Limb limb = make_limb(surface, f, nodes, grown_from(part, joins, scene.parts.size()));
    if (limb.width > 0) add_rise(limb, scene.parts[part].d < 0 ? -1 : 1, rise);
  }
  return rise;
}

}  // namespace relievo::relief
