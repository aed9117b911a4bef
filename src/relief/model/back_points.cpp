#include "relief/model/back_points.h"

#include <cmath>
#include <limits>

namespace relievo {
namespace {

constexpr BackPoint nothing{std::numeric_limits<double>::infinity(), 0};

class BackFinder {
 public:
  BackFinder(const CutSurface& surface, const Inflation& inflation, const Ordering& ordering)
      : mesh_(surface.mesh),
        sheets_(surface.sheets),
        cuts_(surface.cuts),
        u_(inflation.u),
        g_(ordering.g) {
    for (size_t n = 0; n < ordering.lowered.size(); ++n) g_[n] += ordering.lowered[n];
  }

  std::vector<BackPoint> find() const {
    const std::vector<BackPoint> below = behind_base_vertices();
    std::vector<BackPoint> back;
    for (const int node : sheets_.vertex_node) back.push_back(below[mesh_.node_vertex[node]]);
    const size_t edges = sheets_.edge_owner.size();
    for (size_t e = 0; e < edges; ++e) append_cuts(e, back);
    for (size_t e = 0; e < edges; ++e)
      if (cuts_.twin[e] >= 0) append_cuts(e, back);
    return back;
  }

 private:
  /// A hollow has no back: it counts only where nothing else does.
  static void lower(double u, double g, int part, BackPoint& least) {
    const double z = g - std::sqrt(std::abs(u));
    if (u < 0 ? least.z == nothing.z : z < least.z) least = {z, part};
  }

  std::vector<BackPoint> behind_base_vertices() const {
    std::vector<BackPoint> below(mesh_.vertices.size(), nothing);
    for (size_t f = 0; f < mesh_.faces.size(); ++f)
      for (const int n : mesh_.faces[f])
        lower(u_[n], g_[n], mesh_.face_part[f], below[mesh_.node_vertex[n]]);
    return below;
  }

  void append_cuts(size_t e, std::vector<BackPoint>& back) const {
    const auto [face, corner] = sheets_.edge_owner[e];
    const int triangle = mesh_.face_triangle[face];
    const int from = mesh_.node_vertex[mesh_.faces[face][next_place(corner)]];
    const int to = mesh_.node_vertex[mesh_.faces[face][last_place(corner)]];
    for (int i = cuts_.begin[e]; i < cuts_.begin[e + 1]; ++i) {
      BackPoint least = nothing;
      for (const int beside : {triangle, mesh_.neighbours[triangle][corner]})
        if (beside >= 0) lower_on_edge(beside, from, to, cuts_.t[i], least);
      back.push_back(least);
    }
  }

  /// The sheets of a triangle at (1 - t) from + t to, base vertices of its own.
  void lower_on_edge(int triangle, int from, int to, double t, BackPoint& least) const {
    for (int f = mesh_.stack_begin[triangle]; f < mesh_.stack_begin[triangle + 1]; ++f) {
      double u = 0;
      double g = 0;
      for (const int n : mesh_.faces[f]) {
        const int v = mesh_.node_vertex[n];
        const double weight = v == from ? 1 - t : (v == to ? t : 0);
        u += weight * u_[n];
        g += weight * g_[n];
      }
      lower(u, g, mesh_.face_part[f], least);
    }
  }

  const LayeredMesh& mesh_;
  const SheetSurface& sheets_;
  const EdgeCuts& cuts_;
  const std::vector<double>& u_;
  std::vector<double> g_;  ///< as if nothing had been hidden, which is of the front alone
};

}  // namespace

std::vector<BackPoint> back_points(const CutSurface& surface, const Inflation& inflation,
                                   const Ordering& ordering) {
  return BackFinder(surface, inflation, ordering).find();
}

}  // namespace relievo
