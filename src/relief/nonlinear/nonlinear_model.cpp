// The non-linear energy [P eq 3-6] in u = f|f| and g, and the response of its inflation term:
//
//   E = (M^-1 L u - c)'_I M_I (M^-1 L u - c)_I + lambda_bnd sum over B of m |u|
//       + lambda_shift (2 cost of g)
//
// With the excess s = M^-1 L u - c, half the slope of the first term with respect to u is L_II s on
// I and L_BI s on B. A load phi on I is therefore in balance for
//
//   L_II s = phi,    L_II u_I = (M c + M s)_I - L_IB u_B - (L fixed_u)_I
//
//   letter          in the code
//   L, M, M c       NonlinearModel::L, mass, load
//   I, B, m         NonlinearModel::inner, bound, bound_mass
//   cost of g       ShiftMetric
//   s, L_BI s       InflationResponse::excess, boundary_slope
//   u               InflationResponse::inflate
//
// The shift energy if f is unknown at the free nodes F:
//
//   h = T_0 z,   f_F = sign y,   g = h - f = T (z, y) - known f,   T = [ T_0 | -sign e_F ]
//   1/2 g'A g = 1/2 (z, y)' K (z, y) + linear terms,               K = T'A T
//
//   letter    in the code
//   T_0       DepthSystem::T
//   T, K      ShiftMatrix::T, K
//   F         `nodes`
//   A         ShiftMetric::A

#include "relief/nonlinear/nonlinear_model.h"

#include <cstdint>
#include <utility>

#include "kernel/operators/laplacian.h"
#include "relief/inflation/poisson_system.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// Returns #N flags: 1 for nodes where a pair ties f to another part or may lift it.
std::vector<uint8_t> lifted_nodes(const LayeredMesh& mesh, const std::vector<int>& sign) {
  std::vector<uint8_t> lifted(mesh.node_role.size(), 0);
  for (const DepthPair& pair : mesh.constraints) {
    if (pair.equal || sign[pair.upper] >= 0) lifted[pair.upper] = 1;
    if (pair.equal || sign[pair.lower] < 0) lifted[pair.lower] = 1;
  }
  return lifted;
}

/// Collects B and its masses. A node under two ranges has the sum of both masses.
void collect_bound(const LayeredMesh& mesh, NonlinearModel& model) {
  const std::vector<uint8_t> lifted = lifted_nodes(mesh, model.sign);
  for (const RampNode& node : mesh.ramp_nodes)
    if (lifted[node.node] != 0) model.bound.push_back(node.node);
  std::sort(model.bound.begin(), model.bound.end());
  model.bound.erase(std::unique(model.bound.begin(), model.bound.end()), model.bound.end());
  model.bound_mass = VectorXd::Zero(static_cast<Eigen::Index>(model.bound.size()));
  model.bound_ramp.assign(model.bound.size(), -1);
  for (const RampNode& node : mesh.ramp_nodes) {
    if (lifted[node.node] == 0) continue;
    const auto at = std::lower_bound(model.bound.begin(), model.bound.end(), node.node);
    model.bound_mass[at - model.bound.begin()] += model.metric.scale * node.mass;
    model.bound_ramp[at - model.bound.begin()] = node.ramp;
  }
  model.lifting_gap.assign(model.bound.size(), -1);
}

/// Returns #N flags: 1 for nodes that are seen from the front or in a pair.
std::vector<uint8_t> shown_nodes(const LayeredMesh& mesh) {
  std::vector<uint8_t> shown = seen_nodes(mesh);
  for (const DepthPair& pair : mesh.constraints) shown[pair.lower] = shown[pair.upper] = 1;
  return shown;
}

/// Fixes u at the nodes under ranges that are not on B. Where they are seen nothing acts against
/// lambda_bnd, so u is 0.
void fix_other_ranges(const LayeredMesh& mesh, const Inflation& start, NonlinearModel& model) {
  const double area = model.metric.scale * model.metric.scale;
  const std::vector<uint8_t> shown = shown_nodes(mesh);
  model.fixed_u = VectorXd::Zero(model.load.size());
  for (const RampNode& node : mesh.ramp_nodes)
    if (shown[node.node] == 0) model.fixed_u[node.node] = area * start.u[node.node];
  for (const int n : model.bound) model.fixed_u[n] = 0;
}

void number_inner(NonlinearModel& model) {
  model.inner_index.assign(static_cast<size_t>(model.load.size()), -1);
  for (size_t i = 0; i < model.inner.size(); ++i)
    model.inner_index[model.inner[i]] = static_cast<int>(i);
}

/// Appends a column for each free node to T.
SparseMatrix with_free_columns(const SparseMatrix& T, const std::vector<int>& nodes,
                               const Eigen::VectorXd& sign) {
  const auto heights = static_cast<int>(T.cols());
  SparseMatrix wide(static_cast<int>(T.rows()), heights + static_cast<int>(nodes.size()));
  wide.reserve(T.nonZeros() + static_cast<Eigen::Index>(nodes.size()));
  for (int j = 0; j < heights; ++j) {
    wide.startVec(j);
    for (SparseMatrix::InnerIterator entry(T, j); entry; ++entry)
      wide.insertBack(static_cast<int>(entry.row()), j) = entry.value();
  }
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    wide.startVec(heights + i);
    wide.insertBack(nodes[i], heights + i) = -sign[i];
  }
  wide.finalize();
  return wide;
}

/// Orders the unknowns as the model orders nodes, y of a node directly after its height or gap.
std::vector<int> order_of_unknowns(const NonlinearModel& model, const std::vector<int>& nodes) {
  std::vector<int> free_unknown(model.elimination.size(), -1);
  auto unknowns = static_cast<int>(model.elimination.size());
  for (const int n : nodes) free_unknown[n] = unknowns++;
  std::vector<int> order;
  order.reserve(static_cast<size_t>(unknowns));
  for (const int n : model.elimination) {
    order.push_back(n);
    if (free_unknown[n] >= 0) order.push_back(free_unknown[n]);
  }
  return order;
}

}  // namespace

NonlinearModel make_joint_model(const SurfaceInput& surface, const Inflation& start,
                                const ShiftMetric& metric) {
  const auto& [mesh, discretisation, scene] = surface;
  NonlinearModel model;
  model.metric = metric;
  model.L = discretisation.L;
  model.mass = discretisation.mass;
  model.elimination = discretisation.elimination;
  model.load = inflation_load(mesh, scene, metric.scale);
  model.L.diagonal() += inflation_screening(mesh, scene, metric.scale);
  model.sign = surface_signs(mesh, discretisation.surface, scene);
  collect_bound(mesh, model);
  fix_other_ranges(mesh, start, model);
  for (size_t n = 0; n < mesh.node_role.size(); ++n) {
    const bool bound = mesh.node_role[n] == NodeRole::ramp;
    const bool takes_part = model.mass[static_cast<Eigen::Index>(n)] > 0;
    if (takes_part && !bound && mesh.node_role[n] != NodeRole::outline && start.u[n] != 0)
      model.inner.push_back(static_cast<int>(n));
  }
  number_inner(model);
  return model;
}

/// An equality overrules all inequalities of a node.
void find_lifting_gaps(const DepthForest& forest, NonlinearModel& model) {
  std::vector<int> lifted(model.sign.size(), -1);
  for (const DepthGap& gap : forest.gaps) {
    const auto [lower, upper] =
        gap.sign > 0 ? std::pair(gap.parent, gap.child) : std::pair(gap.child, gap.parent);
    if (model.sign[upper] >= 0 && lifted[upper] < 0) lifted[upper] = gap.child;
    if (model.sign[lower] < 0 && lifted[lower] < 0) lifted[lower] = gap.child;
  }
  for (const DepthGap& gap : forest.gaps)
    if (gap.equal) lifted[gap.parent] = lifted[gap.child] = -1;
  for (size_t i = 0; i < model.bound.size(); ++i) model.lifting_gap[i] = lifted[model.bound[i]];
}

bool is_mixed(const NonlinearModel& model) {
  return std::count(model.sign.begin(), model.sign.end(), 0) > 0;
}

bool fix_wrong_signs(const VectorXd& u, NonlinearModel& model) {
  const size_t before = model.inner.size();
  const auto wrong = [&](int n) { return model.sign[n] * u[n] < 0; };
  model.inner.erase(std::remove_if(model.inner.begin(), model.inner.end(), wrong),
                    model.inner.end());
  number_inner(model);
  return model.inner.size() < before;
}

NonlinearEnergy nonlinear_energy(const NonlinearModel& model, const VectorXd& u,
                                 const VectorXd& g) {
  NonlinearEnergy energy;
  const VectorXd excess = model.L * u - model.load;
  for (const int n : model.inner) energy.inflation += excess[n] * excess[n] / model.mass[n];
  for (size_t i = 0; i < model.bound.size(); ++i)
    energy.boundary += model.lambda_bnd * model.bound_mass[static_cast<Eigen::Index>(i)] *
                       std::abs(u[model.bound[i]]);
  const ShiftMetric& metric = model.metric;
  energy.shift = model.lambda_shift * (g.dot(metric.A * g - metric.b) + metric.rest(g));
  return energy;
}

InflationResponse::InflationResponse(const NonlinearModel& model)
    : model_(model), fixed_load_(model.load - model.L * model.fixed_u) {
  const auto size = static_cast<int>(model.inner.size());
  const SparseMatrix L_inner = lower_block(model.L, model.inner_index, size);
  const std::vector<int> order = order_of_places(model.elimination, model.inner_index);
  factor_.analyse(L_inner, Refactorisation::complete, order);
  is_solvable_ = factor_.factorise(L_inner);
}

/// Solves L_II x = load_I. Returns x on all nodes, 0 off I.
VectorXd InflationResponse::solve_poisson(const VectorXd& load) const {
  VectorXd b(static_cast<Eigen::Index>(model_.inner.size()));
  for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = load[model_.inner[i]];
  const VectorXd x = factor_.solve(b);
  VectorXd solution = VectorXd::Zero(load.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) solution[model_.inner[i]] = x[i];
  return solution;
}

VectorXd InflationResponse::boundary_slope(const VectorXd& s) const {
  VectorXd slope(static_cast<Eigen::Index>(model_.bound.size()));
  for (Eigen::Index i = 0; i < slope.size(); ++i) slope[i] = model_.L.col(model_.bound[i]).dot(s);
  return slope;
}

VectorXd InflationResponse::inflate(const VectorXd& s, const VectorXd& u_bound) const {
  VectorXd load = fixed_load_ + model_.mass.cwiseProduct(s);
  for (Eigen::Index i = 0; i < u_bound.size(); ++i)
    load -= u_bound[i] * model_.L.col(model_.bound[i]);
  VectorXd u = solve_poisson(load) + model_.fixed_u;
  for (Eigen::Index i = 0; i < u_bound.size(); ++i) u[model_.bound[i]] = u_bound[i];
  return u;
}

VectorXd InflationResponse::compliance(const VectorXd& phi) const {
  return solve_poisson(model_.mass.cwiseProduct(solve_poisson(phi)));
}

ShiftMatrix make_shift_matrix(const NonlinearModel& model, const DepthSystem& depth,
                              const std::vector<int>& nodes) {
  ShiftMatrix matrix;
  const auto count = static_cast<Eigen::Index>(nodes.size());
  matrix.sign.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) matrix.sign[i] = model.sign[nodes[i]] < 0 ? -1 : 1;
  matrix.T = with_free_columns(depth.T, nodes, matrix.sign);
  matrix.K = galerkin_lower(model.metric.A, matrix.T);
  matrix.diagonal = matrix.K.diagonal().tail(count);
  matrix.elimination = order_of_unknowns(model, nodes);
  return matrix;
}

void set_stiffness(const ShiftMatrix& matrix, const Eigen::VectorXd& stiffness, SparseMatrix& K) {
  const Eigen::Index heights = matrix.heights();
  for (Eigen::Index i = 0; i < stiffness.size(); ++i) {
    const auto j = static_cast<int>(heights + i);
    K.coeffRef(j, j) = matrix.diagonal[i] + stiffness[i];
  }
}

}  // namespace relievo::relief
