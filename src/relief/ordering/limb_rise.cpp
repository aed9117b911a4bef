// The wanted shift r of straight limbs (add_wanted), in scene units:
//
//   r = A smoothstep(x / e),    A = s min(F, largest_rise k),    F = top - k
//   x(p) = (3/4 integral over the root of |p - q|^-5 dq)^(-1/4)    a distance without ridges
//   e = the largest x of points at most l from the root
//   l = max(least_fade w, distance at which the crest has fallen to k + rest_of_fall F)
//   s = smoothstep of (reach / w) from `lump` to `slender`
//
//   letter    in the code
//   x         Limb::reach
//   k, top    crest in add_rise, Limb::top
//   w         Limb::width, of the root
//   e, l      end, length in add_rise

#include "relief/ordering/limb_rise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/shift_metric.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A part that reaches at most `lump` widths of its root is a lump, and one that reaches `slender`
/// widths a limb.
constexpr double lump = 1;
constexpr double slender = 1.75;
/// The outer part of a limb, where it has its own height, begins at this share of its reach.
constexpr double far_share = 0.6;
/// The crest has come down where this share of the fall is left.
constexpr double rest_of_fall = 0.1;
/// Least length of the rise, in widths of the root.
constexpr double least_fade = 1.5;
/// Largest rise relative to the limb's own height. Without the limit, a thin leg would hang in
/// front of a thick belly.
constexpr double largest_rise = 1.5;
/// Far from a root, the integral of a distance uses about this many of its points.
constexpr size_t most_points = 64;
/// Far begins here, in steps between those points, and the change is gradual up to twice as far.
constexpr double far_steps = 4;

/// Counts the parts that share each node, #N. `faces`: by part.
std::vector<int> sharing_parts(const LayeredMesh& mesh,
                               const std::vector<std::vector<int>>& faces) {
  std::vector<int> count(mesh.node_vertex.size(), 0);
  std::vector<int> last(mesh.node_vertex.size(), -1);
  for (int part = 0; part < mesh.part_count; ++part)
    for (const int face : faces[part])
      for (const int n : mesh.faces[face])
        if (std::exchange(last[n], part) != part) ++count[n];
  return count;
}

/// A joined part and the parts that grow out of it, in scene units.
struct Limb {
  std::vector<int> nodes;  ///< of the joined part first, then the other nodes of the grown parts
  size_t own = 0;          ///< number of nodes of the joined part
  std::vector<std::array<int, 2>> edges;  ///< of the joined part, indices in `nodes`, some twice
  std::vector<double> height;             ///< f of each node, in the direction of the inflation
  std::vector<double> distance;           ///< of each node to the root
  std::vector<double> reach;              ///< distance without ridges
  double width = 0;                       ///< of the root
  double top = 0;                         ///< largest height on the root
};

/// A point of a root and the length of root that it stands for.
struct RootPoint {
  Point2 at;
  double length = 0;
};

/// The points of a root, in runs of about the square root of their number. Each run has its box.
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

  /// Returns a distance that is smooth where two points are equally near: that of an infinite
  /// straight root with the same integral of distance^-5. `distance`: the least distance, not 0.
  double smooth_distance_to(Point2 p, double distance) const {
    // An odd stride takes points of both arms of a bent root.
    const size_t stride = points_.size() / most_points * 2 + 1;
    const double gap = length_ / static_cast<double>(points_.size()) * static_cast<double>(stride);
    const double far = smooth_step(far_steps * gap, 2 * far_steps * gap, distance);
    double sum = 0;
    if (far < 1) sum += (1 - far) * integral_to(p, 1);
    if (far > 0) sum += far * integral_to(p, stride);
    // std::sqrt has the same bits everywhere, std::pow has not.
    return 1 / std::sqrt(std::sqrt(0.75 * sum));
  }

 private:
  /// Integrates distance^-5 over the root by every stride-th point.
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

/// Returns the edges between the limb and what it grows out of, ends ascending. Only one face of
/// the limb has such an edge. `faces`: by part; `is_root`: #N flags.
std::vector<std::array<int, 2>> root_edges(const LayeredMesh& mesh,
                                           const std::vector<std::vector<int>>& faces,
                                           const std::vector<int>& grown,
                                           const std::vector<uint8_t>& is_root) {
  std::vector<std::array<int, 2>> edges;
  for (const int part : grown)
    for (const int face : faces[part])
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

/// Returns the edges of a part's faces as indices in `own`, which begins with the part's nodes.
std::vector<std::array<int, 2>> own_edges(const LayeredMesh& mesh, const std::vector<int>& faces,
                                          const std::vector<int>& own) {
  std::vector<int> index(mesh.node_vertex.size(), -1);
  for (size_t i = 0; i < own.size(); ++i) index[own[i]] = static_cast<int>(i);
  std::vector<std::array<int, 2>> edges;
  for (const int face : faces)
    for (int k = 0; k < 3; ++k)
      edges.push_back({index[mesh.faces[face][k]], index[mesh.faces[face][(k + 1) % 3]]});
  return edges;
}

/// Returns the largest value on the limb's edges at points whose level is at least `least`, or 0 if
/// there are none. Both are linear along edges: nodes are far apart in the middle of a limb.
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

/// `f`: #N, scene units; `faces`: by part; `sharing`: sharing_parts; `grown`: grown_from the part.
Limb make_limb(const SurfaceInput& surface, const VectorXd& f,
               const std::vector<std::vector<int>>& faces, const std::vector<int>& sharing,
               const std::vector<int>& grown) {
  const LayeredMesh& mesh = surface.mesh;
  const double sign = surface.scene.parts[grown.front()].d < 0 ? -1 : 1;
  Limb limb;
  std::vector<int> in_limb(mesh.node_vertex.size(), 0);  // parts of the limb that share the node
  std::vector<int> last(mesh.node_vertex.size(), -1);
  for (const int part : grown) {
    for (const int face : faces[part])
      for (const int n : mesh.faces[face])
        if (std::exchange(last[n], part) != part && in_limb[n]++ == 0) limb.nodes.push_back(n);
    if (part == grown.front()) limb.own = limb.nodes.size();
  }
  std::vector<uint8_t> is_root(mesh.node_vertex.size(), 0);
  std::vector<RootPoint> root;
  Box2 box;
  const double scale = surface.discretisation.scale;
  const auto at = [&](int n) { return scale * mesh.vertices[mesh.node_vertex[n]]; };
  for (const int n : limb.nodes) {
    limb.height.push_back(sign * f[n]);
    if (in_limb[n] == sharing[n]) continue;
    is_root[n] = 1;
    box.add(at(n));
    limb.top = std::max(limb.top, limb.height.back());
  }
  limb.edges = own_edges(mesh, faces[grown.front()], limb.nodes);
  for (const auto& [a, b] : root_edges(mesh, faces, grown, is_root))
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

/// `sign`: 1 or -1, that of the part's inflation.
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
  // A root that is shorter than the edges may have no node beside it.
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
  const std::vector<std::vector<int>> faces = faces_by_part(surface.mesh);
  const std::vector<int> sharing = sharing_parts(surface.mesh, faces);
  for (size_t i = 0; i < joins.size(); ++i) {
    const int part = joins[i].upper;
    if (i > 0 && joins[i - 1].upper == part) continue;
    if (scene.parts[part].lean != Point2{}) continue;
    const Limb limb =
        make_limb(surface, f, faces, sharing, grown_from(part, joins, scene.parts.size()));
    if (limb.width > 0) add_rise(limb, scene.parts[part].d < 0 ? -1 : 1, rise);
  }
  return rise;
}

}  // namespace relievo::relief
