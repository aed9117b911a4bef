#include "relief/ordering/limb_rise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "kernel/geometry/polygon.h"

namespace relievo {
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

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Nodes by part, each once, of faces that no part grows out of.
struct PartNodes {
  std::vector<std::vector<int>> of_part;
  std::vector<int> parts;  ///< #N how many parts share the node
};

PartNodes nodes_by_part(const LayeredMesh& mesh) {
  std::vector<std::vector<int>> faces(mesh.part_count);
  for (size_t face = 0; face < mesh.faces.size(); ++face)
    if (!mesh.is_flap(face)) faces[mesh.face_part[face]].push_back(static_cast<int>(face));
  PartNodes nodes{std::vector<std::vector<int>>(mesh.part_count),
                  std::vector<int>(mesh.node_vertex.size(), 0)};
  std::vector<int> last(mesh.node_vertex.size(), -1);
  for (int part = 0; part < mesh.part_count; ++part)
    for (const int face : faces[part])
      for (const int n : mesh.faces[face])
        if (std::exchange(last[n], part) != part) {
          nodes.of_part[part].push_back(n);
          ++nodes.parts[n];
        }
  return nodes;
}

/// A joined part with all that grows out of it.
struct Limb {
  std::vector<int> nodes;        ///< the limb's own first, then those of what grows out of it alone
  size_t own = 0;                ///< how many are its own
  std::vector<double> height;    ///< of each node, f, scene units
  std::vector<double> distance;  ///< of each node to the root, scene units
  std::vector<double> reach;     ///< the same without ridges
  double width = 0;              ///< of the root
  double top = 0;                ///< largest height there
};

/// The part, then what grows out of it.
std::vector<int> grown_from(int part, const std::vector<Join>& by_upper, size_t parts) {
  std::vector<uint8_t> is_grown(parts, 0);
  is_grown[part] = 1;
  std::vector<int> grown = {part};
  for (const Join& join : by_upper)
    if (is_grown[join.lower] != 0 && std::exchange(is_grown[join.upper], 1) == 0)
      grown.push_back(join.upper);
  return grown;
}

/// Points in runs of about the square root of their number, each run with its box.
class PointRuns {
 public:
  explicit PointRuns(std::vector<Point2> points, const Box2& box) : points_(std::move(points)) {
    const bool wide = box.max.x - box.min.x > box.max.y - box.min.y;
    std::sort(points_.begin(), points_.end(), [&](Point2 p, Point2 q) {
      return wide ? std::tie(p.x, p.y) < std::tie(q.x, q.y)
                  : std::tie(p.y, p.x) < std::tie(q.y, q.x);
    });
    run_ = static_cast<size_t>(std::ceil(std::sqrt(static_cast<double>(points_.size()))));
    for (size_t i = 0; i < points_.size(); ++i) {
      if (i % run_ == 0) boxes_.emplace_back();
      boxes_.back().add(points_[i]);
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
        least = std::min(least, dot(points_[i] - p, points_[i] - p));
    }
    return std::sqrt(least);
  }

  /// A distance without ridges where two points are equally near, of points along a curve `step`
  /// apart: that of the straight line which would make the integral of distance^-5 as large.
  /// `distance`: the least one, not 0.
  double smooth_distance_to(Point2 p, double distance, double step) const {
    // An odd stride takes both arms of a bent root. From so far on it makes little difference.
    const size_t stride = points_.size() / most_points * 2 + 1;
    const double gap = step * static_cast<double>(stride);
    const double far = smooth_step(far_steps * gap, 2 * far_steps * gap, distance);
    double sum = 0;
    if (far < 1) sum += (1 - far) * step * sum_to(p, 1);
    if (far > 0) sum += far * gap * sum_to(p, stride);
    // Roots have the same bits everywhere, powers have not.
    return 1 / std::sqrt(std::sqrt(0.75 * sum));
  }

 private:
  /// Of distance^-5 to every stride-th point.
  double sum_to(Point2 p, size_t stride) const {
    double sum = 0;
    for (size_t i = stride / 2; i < points_.size(); i += stride) {
      const double square = dot(points_[i] - p, points_[i] - p);
      sum += 1 / (square * square * std::sqrt(square));
    }
    return sum;
  }

  std::vector<Point2> points_;
  std::vector<Box2> boxes_;
  size_t run_ = 1;
};

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
  std::vector<Point2> root;
  Box2 box;
  const double scale = surface.discretisation.scale;
  const auto at = [&](int n) { return scale * mesh.vertices[mesh.node_vertex[n]]; };
  for (const int n : limb.nodes) {
    limb.height.push_back(sign * f[n]);
    if (in_limb[n] == nodes.parts[n]) continue;
    root.push_back(at(n));
    box.add(at(n));
    limb.top = std::max(limb.top, limb.height.back());
  }
  if (root.empty()) return limb;
  limb.width = box.diagonal();
  const PointRuns runs(std::move(root), box);
  const double step = scale * mesh.edge_length;
  for (const int n : limb.nodes) {
    limb.distance.push_back(runs.distance_to(at(n)));
    const double distance = limb.distance.back();
    limb.reach.push_back(distance > 0 ? runs.smooth_distance_to(at(n), distance, step) : 0);
  }
  return limb;
}

/// `sign`: of the part's inflation.
void add_rise(const Limb& limb, double sign, VectorXd& rise) {
  double reach = 0;
  for (size_t i = 0; i < limb.own; ++i) reach = std::max(reach, limb.distance[i]);
  double crest = 0;
  for (size_t i = 0; i < limb.own; ++i)
    if (limb.distance[i] > far_share * reach) crest = std::max(crest, limb.height[i]);
  const double fall = limb.top - crest;
  const double amount =
      smooth_step(lump, slender, reach / limb.width) * std::min(fall, largest_rise * crest);
  if (!(amount > 0)) return;
  double length = least_fade * limb.width;
  for (size_t i = 0; i < limb.own; ++i)
    if (limb.height[i] > crest + rest_of_fall * fall) length = std::max(length, limb.distance[i]);
  double end = 0;
  for (size_t i = 0; i < limb.own; ++i)
    if (limb.distance[i] <= length) end = std::max(end, limb.reach[i]);
  // No node lies beside a root that is shorter than the edges.
  if (end == 0) return;
  for (size_t i = 0; i < limb.nodes.size(); ++i)
    rise[limb.nodes[i]] += sign * amount * smooth_step(0, end, limb.reach[i]);
}

}  // namespace

VectorXd limb_rise(const SurfaceInput& surface, const Inflation& inflation) {
  const Scene& scene = surface.scene;
  VectorXd rise = VectorXd::Zero(static_cast<Index>(inflation.u.size()));
  std::vector<Join> joins = scene.joins;
  std::stable_sort(joins.begin(), joins.end(),
                   [](const Join& a, const Join& b) { return a.upper < b.upper; });
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

}  // namespace relievo
