#include "relief/hiding/hide_sheets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/operators/laplacian.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Face = std::array<int, 3>;

/// Barycentric coordinates.
using Weights = std::array<double, 3>;

constexpr std::array<Weights, 6> inner_points = {{{0.6, 0.2, 0.2},
                                                  {0.2, 0.6, 0.2},
                                                  {0.2, 0.2, 0.6},
                                                  {0.4, 0.4, 0.2},
                                                  {0.4, 0.2, 0.4},
                                                  {0.2, 0.4, 0.4}}};

/// Distances from corners and edges at which rim_dip samples, as shares of the face.
constexpr std::array<double, 2> rim_distances = {0.05, 0.01};

double height_at(const Face& face, const Weights& weight, const std::vector<double>& u,
                 const std::vector<double>& g) {
  double u_here = 0;
  double g_here = 0;
  for (int k = 0; k < 3; ++k) {
    u_here += weight[k] * u[face[k]];
    g_here += weight[k] * g[face[k]];
  }
  return g_here + signed_root(u_here);
}

double dip_at(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
              const Ordering& ordering, const Weights& weight) {
  return height_at(mesh.faces[pair.lower], weight, inflation.u, ordering.g) -
         height_at(mesh.faces[pair.upper], weight, inflation.u, ordering.g);
}

/// Distance of hidden sheets behind what hides them, in scene units.
constexpr double margin = 4e-4;
/// A smaller share of the margin is round-off.
constexpr double settled = 1e-6;
/// A visible node this many margins in front of a hidden one above it is not an error of the mesh.
constexpr double tear = 10;
/// A face stays in the model if it comes out by less than this share of the margin.
constexpr double slight = 0.25;
/// Rounds of lowering nodes and then faces: a lowered sheet may meet the next one.
constexpr int rounds = 10;

/// Lowers hidden nodes below those in front of them.
class Lowering {
 public:
  Lowering(const SurfaceInput& surface, const Inflation& inflation, Ordering& ordering)
      : mesh_(surface.mesh),
        scene_(surface.scene),
        inflation_(inflation),
        ordering_(ordering),
        seen_(seen_nodes(surface.mesh)),
        pairs_(stacked_faces(surface.mesh, surface.scene)),
        margin_(margin / surface.discretisation.scale),
        lowered_(mesh_.node_vertex.size(), 0) {
    ordering.lowered.assign(mesh_.node_vertex.size(), 0);
  }

  void run() {
    for (int round = 1; round <= rounds; ++round) {
      lower_nodes(round);
      lower_faces(round);
    }
    measure();
    find_crossing();
  }

  bool is_lowered(size_t node) const { return lowered_[node] > 0; }

 private:
  void lower(int node, double by, int round) {
    ordering_.h[node] -= by;
    ordering_.g[node] -= by;
    ordering_.lowered[node] += by;
    lowered_[node] = round;
  }

  /// Checks whether a node of the faces moved in the last round or this one, or it is the first.
  bool is_due(const FacePair& pair, int round) const {
    const auto moved = [&](int node) { return lowered_[node] >= round - 1; };
    return std::any_of(mesh_.faces[pair.lower].begin(), mesh_.faces[pair.lower].end(), moved) ||
           std::any_of(mesh_.faces[pair.upper].begin(), mesh_.faces[pair.upper].end(), moved);
  }

  void lower_nodes(int round) {
    const std::vector<double>& h = ordering_.h;
    for (const FacePair& pair : pairs_) {
      if (!is_due(pair, round)) continue;
      for (int k = 0; k < 3; ++k) {
        const int node = mesh_.faces[pair.lower][k];
        const int above = mesh_.faces[pair.upper][k];
        const double excess = h[node] - h[above] + margin_;
        if (seen_[node] == 0 && node != above && excess > settled * margin_)
          lower(node, excess, round);
      }
    }
  }

  /// Checks whether a visible node lies in front of the sheet above, which a third one hides there.
  /// No position of the other nodes mends that: lowering them would draw them out to spikes.
  bool is_torn(const FacePair& pair) const {
    for (int k = 0; k < 3; ++k) {
      const int node = mesh_.faces[pair.lower][k];
      const int above = mesh_.faces[pair.upper][k];
      if (seen_[node] != 0 && seen_[above] == 0 &&
          ordering_.h[node] > ordering_.h[above] + tear * margin_)
        return true;
    }
    return false;
  }

  /// Returns the pair, or if it is torn the lower face with the next one above that it is not torn
  /// from.
  FacePair whole_pair(FacePair pair) const {
    const int end = mesh_.stack_begin[mesh_.face_triangle[pair.lower] + 1];
    for (int upper = pair.upper; upper < end; ++upper)
      if (!is_torn({pair.lower, upper})) return {pair.lower, upper};
    return pair;
  }

  void lower_faces(int round) {
    for (const FacePair& stacked : pairs_) {
      if (!is_due(stacked, round)) continue;
      const FacePair pair = whole_pair(stacked);
      const Dip dip = worst_dip(mesh_, pair, inflation_, ordering_);
      const double excess = dip.depth + margin_;
      if (excess <= settled * margin_) continue;
      const std::array<int, 3>& nodes = mesh_.faces[pair.lower];
      double share = 0;  // weight of the movable nodes at the point
      for (int k = 0; k < 3; ++k) share += seen_[nodes[k]] == 0 ? dip.weight[k] : 0;
      for (const int node : nodes)
        if (seen_[node] == 0) lower(node, excess / share, round);
    }
  }

  /// Counts and measures the faces that are still in front of the next one.
  void measure() {
    ordering_.overlap_samples = 0;
    ordering_.overlap_worst = 0;
    for (const FacePair& pair : pairs_) {
      const double dip = worst_dip(mesh_, pair, inflation_, ordering_).depth;
      if (dip <= 0.01 * margin_) continue;
      ++ordering_.overlap_samples;
      ordering_.overlap_worst = std::max(ordering_.overlap_worst, dip);
    }
  }

  /// Lists the faces at visible nodes that come out. Beside an outline the surface in front can
  /// fall as steeply as a root and cut any face that ends there, and slivers between two outlines
  /// have no nodes that could be lowered.
  void find_crossing() {
    ordering_.crossing.clear();
    for (const FacePair& pair : covered_faces(mesh_, scene_)) {
      const std::array<int, 3>& nodes = mesh_.faces[pair.lower];
      if (std::none_of(nodes.begin(), nodes.end(), [this](int n) { return seen_[n] != 0; }))
        continue;
      const double dip = std::max(worst_dip(mesh_, pair, inflation_, ordering_).depth,
                                  rim_dip(mesh_, pair, inflation_, ordering_));
      if (dip > slight * margin_) ordering_.crossing.push_back(pair.lower);
    }
  }

  const LayeredMesh& mesh_;
  const Scene& scene_;
  const Inflation& inflation_;
  Ordering& ordering_;
  std::vector<uint8_t> seen_;
  std::vector<FacePair> pairs_;
  double margin_;             ///< px
  std::vector<int> lowered_;  ///< #N, last round in which the node was lowered, or 0
};

/// Weight of a pull of u and g to 0, for flaps without a fixed edge; in 1 / scene unit^2.
constexpr double weakest = 1e-4;

}  // namespace

std::vector<FacePair> stacked_faces(const LayeredMesh& mesh, const Scene& scene) {
  const std::vector<std::pair<int, int>> free = free_parts(scene);
  std::vector<FacePair> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int lower = mesh.stack_begin[t + 1] - 2; lower >= mesh.stack_begin[t]; --lower) {
      int upper = lower + 1;
      while (upper < mesh.stack_begin[t + 1] && may_cross(mesh, free, upper, lower)) ++upper;
      if (upper < mesh.stack_begin[t + 1]) pairs.push_back({lower, upper});
    }
  return pairs;
}

std::vector<FacePair> covered_faces(const LayeredMesh& mesh, const Scene& scene) {
  const std::vector<std::pair<int, int>> free = free_parts(scene);
  std::vector<FacePair> pairs;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int front = mesh.stack_begin[t + 1] - 1;
    for (int lower = mesh.stack_begin[t]; lower < front; ++lower)
      if (!may_cross(mesh, free, front, lower)) pairs.push_back({lower, front});
  }
  return pairs;
}

Dip worst_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
              const Ordering& ordering) {
  Dip worst{-std::numeric_limits<double>::infinity(), {}};
  for (const Weights& weight : inner_points) {
    const double depth = dip_at(mesh, pair, inflation, ordering, weight);
    if (depth > worst.depth) worst = {depth, weight};
  }
  return worst;
}

double rim_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
               const Ordering& ordering) {
  double worst = -std::numeric_limits<double>::infinity();
  for (const double near : rim_distances)
    for (int k = 0; k < 3; ++k) {
      Weights corner{near, near, near};
      corner[k] = 1 - 2 * near;
      Weights edge{(1 - near) / 2, (1 - near) / 2, (1 - near) / 2};
      edge[k] = near;
      for (const Weights& weight : {corner, edge})
        worst = std::max(worst, dip_at(mesh, pair, inflation, ordering, weight));
    }
  return worst;
}

void hide_sheets(const SurfaceInput& surface, std::optional<FlapSystem>& flaps,
                 Inflation& inflation, Ordering& ordering, const RunContext& context) {
  if (!flaps) flaps.emplace(surface.mesh, surface.discretisation, context);
  if (context.cancelled()) return flaps.reset();
  flaps->fill(surface, context, inflation, ordering);
  Lowering lowering(surface, inflation, ordering);
  lowering.run();
  const std::vector<Point2> gradients =
      node_gradients(surface.discretisation.gradients, ordering.g);
  for (size_t n = 0; n < gradients.size(); ++n)
    if (lowering.is_lowered(n)) ordering.grad_g[n] = gradients[n];
  flaps->set_gradients(ordering);
}

FlapSystem::FlapSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                       const RunContext& context) {
  std::vector<int> index(mesh.node_vertex.size(), -1);  // in nodes_
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!mesh.is_flap(f)) continue;
    flaps_.push_back(static_cast<int>(f));
    faces_.push_back(mesh.faces[f]);
    for (const int n : mesh.faces[f])
      if (discretisation.mass[n] == 0) index[n] = 0;
  }
  if (faces_.empty()) return;
  for (size_t n = 0; n < index.size(); ++n) {
    if (index[n] < 0) continue;
    index[n] = static_cast<int>(nodes_.size());
    nodes_.push_back(static_cast<int>(n));
  }
  positions_ = node_positions(mesh);
  const FlatMesh flat{positions_, faces_};
  gradients_ = gradient_stencils(flat);
  const double scale = discretisation.scale;
  L_ = stiffness_matrix(flat);
  L_.diagonal() += weakest * scale * scale * lumped_mass(flat);
  K_ = lower_block(L_, index, static_cast<int>(nodes_.size()));
  factor_.analyse(K_, Refactorisation::complete, order_of_places(discretisation.elimination, index),
                  context);
}

void FlapSystem::fill(const SurfaceInput& surface, const RunContext& context, Inflation& inflation,
                      Ordering& ordering) {
  if (nodes_.empty()) return;
  std::vector<double> density;
  for (const int f : flaps_) {
    const Part& part = surface.scene.parts[surface.mesh.source(f)];
    density.push_back(part.c * part.d * std::abs(part.d));
  }
  const VectorXd load = load_vector({positions_, faces_}, density);
  std::vector<uint8_t> outline;
  for (const int n : nodes_) outline.push_back(surface.mesh.node_role[n] == NodeRole::outline);
  const std::vector<uint8_t> none(outline.size(), 0);
  auto& [u, grad_u] = inflation;
  if (!solve(load, outline, context, u)) return;
  if (!solve(VectorXd::Zero(load.size()), none, context, ordering.g)) return;
  const std::vector<Point2> gradients = node_gradients(gradients_, u);
  for (const int n : nodes_) grad_u[n] = gradients[n];
  for (const int n : nodes_) ordering.h[n] = ordering.g[n] + signed_root(u[n]);
}

/// Solves for the values at nodes_, 0 where fixed, and stores them in `values` (#N). The other
/// values are given.
bool FlapSystem::solve(const VectorXd& load, const std::vector<uint8_t>& fixed,
                       const RunContext& context, std::vector<double>& values) {
  VectorXd known = VectorXd::Map(values.data(), static_cast<Index>(values.size()));
  for (const int n : nodes_) known[n] = 0;
  const VectorXd force = load - L_ * known;
  VectorXd b(K_.rows());
  for (Index i = 0; i < b.size(); ++i) b[i] = fixed[i] != 0 ? 0 : force[nodes_[i]];
  if (!factor_.factorise(K_, fixed, context)) return false;
  const VectorXd x = factor_.solve(b);
  for (Index i = 0; i < b.size(); ++i) values[nodes_[i]] = x[i];
  return true;
}

void FlapSystem::set_gradients(Ordering& ordering) const {
  if (nodes_.empty()) return;
  const std::vector<Point2> gradients = node_gradients(gradients_, ordering.g);
  for (const int n : nodes_) ordering.grad_g[n] = gradients[n];
}

}  // namespace relievo::relief
