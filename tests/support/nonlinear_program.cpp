#include "support/nonlinear_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "kernel/operators/laplacian.h"
#include "relief/layers/layered_mesh.h"
#include "support/enforced_pairs.h"
#include "support/shift_cost.h"

namespace relievo::testing {

using Eigen::VectorXd;

namespace {

/// The sign of d of a face at each node, 0 where faces differ.
VectorXd signs_by_flooding(const relief::LayeredMesh& mesh, const Scene& scene) {
  VectorXd sign = VectorXd::Constant(static_cast<Eigen::Index>(mesh.node_vertex.size()), 2);
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t f = 0; f < mesh.faces.size(); ++f) {
      double together = scene.parts[mesh.face_part[f]].d > 0 ? 1 : -1;
      for (const int n : mesh.faces[f])
        if (sign[n] < 2 && sign[n] != together) together = 0;
      for (const int n : mesh.faces[f]) {
        changed = changed || sign[n] != together;
        sign[n] = together;
      }
    }
  }
  return sign;
}

/// As documented for flat parts; half-widths in scene units.
double source_density(const Part& part) {
  const double k = 8 * part.flat;
  const double profile = k > 0 ? k * k / (2 * (1 - 1 / std::cosh(k))) : 1;
  return part.c * part.d * std::abs(part.d) * profile;
}

double source_screening(const Part& part, double scale) {
  double area = 0;
  double length = 0;
  for (const Ring& ring : part.outline) {
    area += signed_area(ring) * scale * scale;
    length += perimeter(ring) * scale;
  }
  return std::pow(8 * part.flat * length / area, 2);
}

/// Those that are glued, and those that pairs can hold against the pull to the drawing plane.
std::set<int> liftable_nodes(const relief::LayeredMesh& mesh, const VectorXd& sign) {
  std::set<int> nodes;
  for (const relief::DepthPair& pair : mesh.constraints) {
    if (pair.equal || sign[pair.upper] > 0) nodes.insert(pair.upper);
    if (pair.equal || sign[pair.lower] < 0) nodes.insert(pair.lower);
  }
  return nodes;
}

/// Half the derivative of the inflation energy with respect to u.
VectorXd inflation_force(const NonlinearProgram& program, const VectorXd& u) {
  VectorXd weighted = program.L * u - program.load;
  for (Eigen::Index n = 0; n < u.size(); ++n) {
    const bool free = program.row[n] >= 0 && program.bound_mass[n] == 0;
    weighted[n] = free ? weighted[n] / program.mass[n] : 0;
  }
  return program.L * weighted;
}

}  // namespace

NonlinearProgram make_nonlinear_program(const relief::LayeredMesh& mesh, const Scene& scene,
                                        const relief::NonlinearOptions& options,
                                        const relief::Inflation& inflation) {
  NonlinearProgram program;
  program.scale = relief::scene_scale(mesh);
  program.lambda_bnd = options.lambda_bnd;
  program.lambda_shift = options.lambda_shift;
  const std::vector<Point2> positions = relief::node_positions(mesh, program.scale);
  std::vector<std::array<int, 3>> faces;
  std::vector<double> density;
  std::vector<double> screening;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.is_flap(f)) continue;
    const Part& part = scene.parts[mesh.source(f)];
    faces.push_back(mesh.faces[f]);
    density.push_back(source_density(part));
    screening.push_back(source_screening(part, program.scale));
  }
  const FlatMesh flat{positions, faces};
  program.L = stiffness_matrix(flat);
  program.mass = lumped_mass(flat);
  program.A = program.L;
  program.A.diagonal() += options.ordering.epsilon * program.mass;
  const ShiftCost cost{mesh, scene, options.ordering.epsilon};
  const VectorXd still = VectorXd::Zero(program.mass.size());
  program.pull = -cost.slope(still);
  program.lean_constant = cost(still);
  program.load = load_vector(flat, density);
  program.L.diagonal() += load_vector(flat, screening);
  program.sign = signs_by_flooding(mesh, scene);
  program.bound_mass = VectorXd::Zero(program.mass.size());
  const std::set<int> liftable = liftable_nodes(mesh, program.sign);
  for (const relief::RampNode& node : mesh.ramp_nodes)
    if (liftable.count(node.node) > 0) program.bound_mass[node.node] += program.scale * node.mass;
  program.held = VectorXd::Zero(program.mass.size());
  for (int n = 0; n < static_cast<int>(mesh.node_role.size()); ++n) {
    const bool free = program.bound_mass[n] > 0 ||
                      (mesh.node_role[n] != relief::NodeRole::ramp && inflation.u[n] != 0);
    program.row.push_back(free ? static_cast<int>(program.node.size()) : -1);
    if (free) program.node.push_back(n);
    if (!free) program.held[n] = program.scale * program.scale * inflation.u[n];
  }
  program.pairs = enforced_pairs(mesh);
  return program;
}

bool has_pure_surfaces(const relief::LayeredMesh& mesh, const Scene& scene) {
  const VectorXd sign = signs_by_flooding(mesh, scene);
  return sign.size() > 0 && sign.cwiseAbs().minCoeff() > 0;
}

bool on_bound(const NonlinearProgram& program, int unknown) {
  return program.bound_mass[program.node[unknown]] > 0;
}

NonlinearPoint point_of(const NonlinearProgram& program, const relief::Inflation& inflation,
                        const relief::Ordering& ordering) {
  NonlinearPoint point{VectorXd(program.node.size()), VectorXd(program.row.size())};
  for (int i = 0; i < point.p.size(); ++i) {
    const double u = program.scale * program.scale * std::abs(inflation.u[program.node[i]]);
    point.p[i] = on_bound(program, i) ? std::sqrt(u) : u;
  }
  for (Eigen::Index n = 0; n < point.g.size(); ++n) point.g[n] = program.scale * ordering.g[n];
  return point;
}

VectorXd squares(const NonlinearProgram& program, const VectorXd& p) {
  VectorXd u = program.held;
  for (int i = 0; i < p.size(); ++i) {
    const int n = program.node[i];
    u[n] = program.sign[n] * (on_bound(program, i) ? p[i] * p[i] : p[i]);
  }
  return u;
}

double energy(const NonlinearProgram& program, const NonlinearPoint& point) {
  const VectorXd excess = program.L * squares(program, point.p) - program.load;
  const double shift = point.g.dot(program.A * point.g) / 2 - point.g.dot(program.pull);
  double sum = 2 * program.lambda_shift * (shift + program.lean_constant);
  for (int i = 0; i < point.p.size(); ++i) {
    const int n = program.node[i];
    sum += on_bound(program, i)
               ? program.lambda_bnd * program.bound_mass[n] * point.p[i] * point.p[i]
               : excess[n] * excess[n] / program.mass[n];
  }
  return sum;
}

NonlinearPoint gradient(const NonlinearProgram& program, const NonlinearPoint& point) {
  const VectorXd force = inflation_force(program, squares(program, point.p));
  NonlinearPoint gradient{VectorXd(point.p.size()),
                          2 * program.lambda_shift * (program.A * point.g - program.pull)};
  for (int i = 0; i < point.p.size(); ++i) {
    const int n = program.node[i];
    gradient.p[i] = 2 * program.sign[n] * force[n];
    if (on_bound(program, i))
      gradient.p[i] = 2 * point.p[i] * (gradient.p[i] + program.lambda_bnd * program.bound_mass[n]);
  }
  return gradient;
}

VectorXd heights(const NonlinearProgram& program, const NonlinearPoint& point) {
  VectorXd h = point.g;
  for (Eigen::Index n = 0; n < h.size(); ++n)
    h[n] += program.sign[n] * std::sqrt(std::abs(program.held[n]));
  for (int i = 0; i < point.p.size(); ++i) {
    const int n = program.node[i];
    h[n] += program.sign[n] * (on_bound(program, i) ? point.p[i] : std::sqrt(point.p[i]));
  }
  return h;
}

double root_slope(const NonlinearProgram& program, const NonlinearPoint& point, int unknown) {
  const double sign = program.sign[program.node[unknown]];
  return on_bound(program, unknown) ? sign : sign / (2 * std::sqrt(point.p[unknown]));
}

double violation(const NonlinearProgram& program, const NonlinearPoint& point) {
  const VectorXd h = heights(program, point);
  double worst = 0;
  for (const relief::DepthPair& pair : program.pairs) {
    const double excess = h[pair.lower] - h[pair.upper];
    worst = std::max(worst, pair.equal ? std::abs(excess) : excess);
  }
  return worst;
}

}  // namespace relievo::testing
