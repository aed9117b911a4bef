// The linear system of the inflation, in scene units [P eq 7]:
//
//   A u = M c,    A = L + B + K,    u = 0 where fixed
//
// On a flat part the equation is
//
//   -div grad u + (k/w)^2 u = c d|d| k^2 / (2 - 2 / cosh k),    k = 8 flat,  w = area / perimeter
//
//   letter     in the code
//   L          L_, on the unknowns
//   B + K      PoissonBoundary::diagonal and coupling
//   A          A_
//   M c        inflation_load
//   (k/w)^2    screening_density; K is its integral against the hat functions
//   k          flatness

#include "relief/inflation/poisson_system.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/stopwatch.h"
#include "kernel/operators/laplacian.h"
#include "relief/cues/cue_fields.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// k of a part with flat = 1.
constexpr double flattest = 8;
/// The profile is round to all significant digits if k is smaller.
constexpr double roundest = 1e-3;

double area_of(const Part& part) {
  double area = 0;
  for (const Ring& ring : part.outline) area += signed_area(ring);
  return area;
}

/// Returns k, or 0 for a part that is round or has no area.
double flatness(const Part& part) {
  const double k = flattest * part.flat;
  return k < roundest || area_of(part) == 0 ? 0 : k;
}

/// Integrates a density, constant on each face, against the hat functions of the nodes.
VectorXd integrate(const LayeredMesh& mesh, double scale, const std::vector<double>& density) {
  const std::vector<Point2> positions = node_positions(mesh, scale);
  return load_vector({positions, mesh.faces}, density);
}

}  // namespace

PoissonSystem::PoissonSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                             Refactorisation refactorisation, const RunContext& context)
    : unknown_(mesh.node_role.size(), -1), ramp_nodes_(mesh.ramp_nodes) {
  for (size_t n = 0; n < unknown_.size(); ++n) {
    const bool takes_part = discretisation.mass[static_cast<Index>(n)] > 0;
    if (mesh.node_role[n] == NodeRole::outline || !takes_part) continue;
    unknown_[n] = static_cast<int>(node_.size());
    node_.push_back(static_cast<int>(n));
  }
  L_ = lower_block(discretisation.L, unknown_, static_cast<int>(node_.size()));
  add_couplings();
  A_ = L_;
  const PieceTimer analysing(context, "analyse");
  factor_.analyse(L_, refactorisation, order_of_places(discretisation.elimination, unknown_),
                  context);
}

bool PoissonSystem::is_coupled(const RampNode& ramp) const {
  return ramp.below >= 0 && unknown_[ramp.below] >= 0 && unknown_[ramp.node] >= 0;
}

/// Adds the couplings to the pattern of L, with the value 0.
void PoissonSystem::add_couplings() {
  SparseMatrix pattern(L_.rows(), L_.cols());
  std::vector<Eigen::Triplet<double>> entries;
  for (const RampNode& ramp : ramp_nodes_) {
    if (!is_coupled(ramp)) continue;
    const auto [column, row] = std::minmax(unknown_[ramp.below], unknown_[ramp.node]);
    entries.emplace_back(row, column, 0.0);
  }
  pattern.setFromTriplets(entries.begin(), entries.end());
  if (!entries.empty()) L_ = SparseMatrix(L_ + pattern);
}

void PoissonSystem::set_values(const PoissonBoundary& boundary) {
  A_ = L_;
  for (size_t i = 0; i < node_.size(); ++i)
    A_.valuePtr()[A_.outerIndexPtr()[i]] += boundary.diagonal[node_[i]];
  for (size_t i = 0; i < ramp_nodes_.size(); ++i) {
    if (!is_coupled(ramp_nodes_[i])) continue;
    const auto [column, row] =
        std::minmax(unknown_[ramp_nodes_[i].below], unknown_[ramp_nodes_[i].node]);
    A_.coeffRef(row, row) += boundary.coupling[i];
    A_.coeffRef(column, column) += boundary.coupling[i];
    A_.coeffRef(row, column) -= boundary.coupling[i];
  }
}

std::optional<VectorXd> PoissonSystem::solve(const PoissonBoundary& boundary, const VectorXd& load,
                                             const RunContext& context) {
  if (context.cancelled()) return std::nullopt;
  const auto unknowns = static_cast<Index>(node_.size());
  VectorXd b(unknowns);
  std::vector<uint8_t> fixed(node_.size());
  for (Index i = 0; i < unknowns; ++i) {
    fixed[i] = boundary.fixed[node_[i]];
    b[i] = fixed[i] != 0 ? 0 : load[node_[i]];
  }
  if (!last_ || !(*last_ == boundary)) {
    last_.reset();
    set_values(boundary);
    if (!factor_.refactorise(A_, fixed, context)) return std::nullopt;
    last_ = boundary;
  }
  const VectorXd x = factor_.solve(b);
  if (!x.allFinite()) return std::nullopt;
  VectorXd u = VectorXd::Zero(load.size());
  for (Index i = 0; i < unknowns; ++i) u[node_[i]] = x[i];
  return u;
}

double source_density(const Part& part) {
  const double density = part.c * part.d * std::abs(part.d);
  const double k = flatness(part);
  return k == 0 ? density : density * (k * k / (2 - 2 / std::cosh(k)));
}

double screening_density(const Part& part, double scale) {
  const double k = flatness(part);
  if (k == 0) return 0;
  double length = 0;
  for (const Ring& ring : part.outline) length += perimeter(ring);
  const double decay = k * length / (scale * std::abs(area_of(part)));
  return decay * decay;
}

VectorXd inflation_load(const LayeredMesh& mesh, const Scene& scene, double scale) {
  const std::vector<double> factors = bulge_factors(mesh, scene);
  std::vector<double> density(mesh.faces.size(), 0);
  std::vector<double> of_part;
  for (const Part& part : scene.parts) of_part.push_back(source_density(part));
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.is_flap(f)) continue;
    const int part = mesh.source(f);
    const bool bulges = !factors.empty() && part == mesh.face_part[f];
    density[f] = bulges ? factors[f] * of_part[part] : of_part[part];
  }
  return integrate(mesh, scale, density);
}

VectorXd inflation_screening(const LayeredMesh& mesh, const Scene& scene, double scale) {
  const auto is_round = [](double density) { return density == 0; };
  std::vector<double> of_part;
  for (const Part& part : scene.parts) of_part.push_back(screening_density(part, scale));
  if (std::all_of(of_part.begin(), of_part.end(), is_round))
    return VectorXd::Zero(static_cast<Index>(mesh.node_vertex.size()));
  std::vector<double> density(mesh.faces.size(), 0);
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (!mesh.is_flap(f)) density[f] = of_part[mesh.source(f)];
  return integrate(mesh, scale, density);
}

std::vector<int> surface_signs(const LayeredMesh& mesh, const std::vector<int>& surface,
                               const Scene& scene) {
  std::vector<uint8_t> raised(mesh.node_vertex.size(), 0);
  std::vector<uint8_t> sunk(raised);
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    (scene.parts[mesh.source(f)].d > 0 ? raised : sunk)[surface[mesh.faces[f][0]]] = 1;
  std::vector<int> signs;
  signs.reserve(raised.size());
  for (const int s : surface) signs.push_back(raised[s] - sunk[s]);
  return signs;
}

Inflation make_inflation(const GradientStencils& gradients, const VectorXd& u, double scale) {
  Inflation inflation;
  inflation.u.reserve(static_cast<size_t>(u.size()));
  for (const double value : u) inflation.u.push_back(value / (scale * scale));
  inflation.grad_u = node_gradients(gradients, inflation.u);
  return inflation;
}

}  // namespace relievo::relief
