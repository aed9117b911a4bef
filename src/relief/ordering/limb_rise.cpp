#include "relief/ordering/limb_rise.h"

#include <algorithm>
#include <cstdint>
#include <limits>

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

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A node of a limb.
struct LimbNode {
  int node = -1;
  bool own = false;     ///< of the limb itself, not of what grows out of it alone
  double distance = 0;  ///< to the root, scene units
  double height = 0;    ///< f, scene units
};

/// A joined part with all that grows out of it.
struct Limb {
  std::vector<LimbNode> nodes;
  std::vector<Point2> root;  ///< nodes that it shares with the rest, scene units
  double width = 0;          ///< of the root
  double top = 0;            ///< largest height there
};

/// Flags of the part and of what grows out of it, by part.
std::vector<uint8_t> grown_from(int part, const std::vector<Join>& by_upper, size_t parts) {
  std::vector<uint8_t> grown(parts, 0);
  grown[part] = 1;
  for (const Join& join : by_upper)
    if (grown[join.lower] != 0) grown[join.upper] = 1;
  return grown;
}

/// Heights are in the direction in which the part is inflated.
Limb make_limb(const SurfaceInput& surface, const VectorXd& f, int part,
               const std::vector<uint8_t>& grown) {
  const LayeredMesh& mesh = surface.mesh;
  const double sign = surface.scene.parts[part].d < 0 ? -1 : 1;
  enum : uint8_t { own = 1, carried = 2, rest = 4 };
  std::vector<uint8_t> used(mesh.node_vertex.size(), 0);
  for (size_t face = 0; face < mesh.faces.size(); ++face) {
    if (mesh.is_flap(face)) continue;
    const int of = mesh.face_part[face];
    for (const int n : mesh.faces[face]) used[n] |= of == part ? own : grown[of] ? carried : rest;
  }
  Limb limb;
  Box2 box;
  const double scale = surface.discretisation.scale;
  const auto at = [&](size_t n) { return scale * mesh.vertices[mesh.node_vertex[n]]; };
  for (size_t n = 0; n < used.size(); ++n) {
    if ((used[n] & (own | carried)) == 0) continue;
    const double height = sign * f[static_cast<Index>(n)];
    limb.nodes.push_back({static_cast<int>(n), (used[n] & own) != 0, 0, height});
    if ((used[n] & rest) == 0) continue;
    limb.root.push_back(at(n));
    box.add(at(n));
    limb.top = std::max(limb.top, height);
  }
  if (limb.root.empty()) return limb;
  limb.width = box.diagonal();
  for (LimbNode& node : limb.nodes) {
    node.distance = std::numeric_limits<double>::infinity();
    for (const Point2 p : limb.root)
      node.distance = std::min(node.distance, norm(p - at(static_cast<size_t>(node.node))));
  }
  return limb;
}

/// `sign`: of the part's inflation.
void add_rise(const Limb& limb, double sign, VectorXd& rise) {
  double reach = 0;
  for (const LimbNode& node : limb.nodes)
    if (node.own) reach = std::max(reach, node.distance);
  double crest = 0;
  for (const LimbNode& node : limb.nodes)
    if (node.own && node.distance > far_share * reach) crest = std::max(crest, node.height);
  const double fall = limb.top - crest;
  const double amount =
      smooth_step(lump, slender, reach / limb.width) * std::min(fall, largest_rise * crest);
  if (!(amount > 0)) return;
  double length = least_fade * limb.width;
  for (const LimbNode& node : limb.nodes)
    if (node.own && node.height > crest + rest_of_fall * fall)
      length = std::max(length, node.distance);
  for (const LimbNode& node : limb.nodes)
    rise[node.node] += sign * amount * smooth_step(0, length, node.distance);
}

}  // namespace

VectorXd limb_rise(const SurfaceInput& surface, const Inflation& inflation) {
  const Scene& scene = surface.scene;
  VectorXd rise = VectorXd::Zero(static_cast<Index>(inflation.u.size()));
  std::vector<Join> joins = scene.joins;
  std::stable_sort(joins.begin(), joins.end(),
                   [](const Join& a, const Join& b) { return a.upper < b.upper; });
  const VectorXd f = surface.discretisation.scale * inflated_heights(inflation.u);
  for (size_t i = 0; i < joins.size(); ++i) {
    const int part = joins[i].upper;
    if (i > 0 && joins[i - 1].upper == part) continue;
    if (scene.parts[part].lean != Point2{}) continue;
    const Limb limb = make_limb(surface, f, part, grown_from(part, joins, scene.parts.size()));
    if (limb.width > 0) add_rise(limb, scene.parts[part].d < 0 ? -1 : 1, rise);
  }
  return rise;
}

}  // namespace relievo
