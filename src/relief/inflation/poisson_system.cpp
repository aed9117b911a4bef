#include "relief/inflation/poisson_system.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "kernel/base/stopwatch.h"
#include "kernel/geometry/polygon.h"
#include "kernel/operators/laplacian.h"
#include "relief/cues/cue_fields.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

/// k of a part with flat = 1.
constexpr double flattest = 8;
/// Below, the profile is round to all digits that count.
constexpr double roundest = 1e-3;

}  // namespace

using Eigen::Index;
using Eigen::VectorXd;

PoissonSystem::PoissonSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                             Refactorisation refactorisation, const RunContext& context)
    : unknown_(mesh.node_role.size(), -1) {
  for (size_t n = 0; n < unknown_.size(); ++n) {
    const bool takes_part = discretisation.mass[static_cast<Index>(n)] > 0;
    if (mesh.node_role[n] == NodeRole::outline || !takes_part) continue;
    unknown_[n] = static_cast<int>(node_.size());
    node_.push_back(static_cast<int>(n));
  }
  L_ = lower_block(discretisation.L, unknown_, static_cast<int>(node_.size()));
  collect_links(mesh);
  A_ = L_;
  const PieceTimer analysing(context, "analyse");
  factor_.analyse(L_, refactorisation, order_of_places(discretisation.elimination, unknown_),
                  context);
}

void PoissonSystem::collect_links(const LayeredMesh& mesh) {
  SparseMatrix pattern(L_.rows(), L_.cols());
  std::vector<Eigen::Triplet<double>> entries;
  for (size_t i = 0; i < mesh.ramp_nodes.size(); ++i) {
    const RampNode& ramp = mesh.ramp_nodes[i];
    if (ramp.below < 0 || unknown_[ramp.below] < 0 || unknown_[ramp.node] < 0) continue;
    const auto [column, row] = std::minmax(unknown_[ramp.below], unknown_[ramp.node]);
    links_.push_back({static_cast<int>(i), row, column});
    entries.emplace_back(row, column, 0.0);
  }
  pattern.setFromTriplets(entries.begin(), entries.end());
  if (!links_.empty()) L_ = SparseMatrix(L_ + pattern);
}

void PoissonSystem::set_values(const PoissonBoundary& boundary) {
  A_ = L_;
  for (size_t i = 0; i < node_.size(); ++i)
    A_.valuePtr()[A_.outerIndexPtr()[i]] += boundary.spring[node_[i]];
  for (const Link& link : links_) {
    const double stiffness = boundary.link[link.ramp_node];
    A_.coeffRef(link.row, link.row) += stiffness;
    A_.coeffRef(link.column, link.column) += stiffness;
    A_.coeffRef(link.row, link.column) -= stiffness;
  }
}

std::optional<VectorXd> PoissonSystem::solve(const PoissonBoundary& boundary, const VectorXd& load,
                                             const RunContext& context) {
  if (context.cancelled()) return std::nullopt;
  const auto unknowns = static_cast<Index>(node_.size());
  VectorXd b(unknowns);
  std::vector<uint8_t> held(node_.size());
  for (Index i = 0; i < unknowns; ++i) {
    held[i] = boundary.fixed[node_[i]];
    b[i] = held[i] != 0 ? 0 : load[node_[i]];
  }
  if (!last_ || !(*last_ == boundary)) {
    last_.reset();
    set_values(boundary);
    if (!factor_.refactorise(A_, held, context)) return std::nullopt;
    last_ = boundary;
  }
  const VectorXd x = factor_.solve(b);
  if (!x.allFinite()) return std::nullopt;
  VectorXd u = VectorXd::Zero(load.size());
  for (Index i = 0; i < unknowns; ++i) u[node_[i]] = x[i];
  return u;
}

PartSource source_of(const Part& part, double scale) {
  PartSource source{part.c * part.d * std::abs(part.d), 0};
  double area = 0;
  double length = 0;
  for (const Ring& ring : part.outline) {
    area += signed_area(ring);
    length += perimeter(ring);
  }
  const double k = flattest * part.flat;
  if (k < roundest || area == 0) return source;
  const double decay = k * length / (scale * std::abs(area));
  source.screening = decay * decay;
  source.density *= k * k / (2 - 2 / std::cosh(k));
  return source;
}

InflationTerms inflation_terms(const LayeredMesh& mesh, const Scene& scene, double scale) {
  std::vector<PartSource> sources;
  for (const Part& part : scene.parts) sources.push_back(source_of(part, scale));
  const std::vector<Point2> positions = node_positions(mesh, scale);
  const std::vector<double> factors = bulge_factors(mesh, scene);
  std::vector<double> density(mesh.faces.size(), 0);
  std::vector<double> screening(mesh.faces.size(), 0);
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.is_flap(f)) continue;
    const int part = mesh.source(f);
    const bool bulges = !factors.empty() && part == mesh.face_part[f];
    density[f] = bulges ? factors[f] * sources[part].density : sources[part].density;
    screening[f] = sources[part].screening;
  }
  const bool round = std::all_of(sources.begin(), sources.end(),
                                 [](const PartSource& source) { return source.screening == 0; });
  InflationTerms terms;
  terms.load = load_vector({positions, mesh.faces}, density);
  terms.screening = round ? Eigen::VectorXd::Zero(terms.load.size())
                          : load_vector({positions, mesh.faces}, screening);
  return terms;
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

Inflation make_inflation(const GradientStencils& gradients, const Eigen::VectorXd& u,
                         double scale) {
  Inflation inflation;
  inflation.u.reserve(static_cast<size_t>(u.size()));
  for (const double value : u) inflation.u.push_back(value / (scale * scale));
  inflation.grad_u = node_gradients(gradients, inflation.u);
  return inflation;
}

}  // namespace relievo::relief
