#include "relief/ordering/shift_metric.h"

#include <algorithm>

#include "kernel/operators/laplacian.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/joined_surface.h"

namespace relievo {
namespace {

/// The centroid of each part's faces; the origin where it has none.
std::vector<Point2> middles(const LayeredMesh& mesh, const FlatMesh& flat,
                            const std::vector<double>& areas) {
  std::vector<Point2> middle(static_cast<size_t>(mesh.part_count));
  std::vector<double> area(middle.size(), 0);
  for (size_t f = 0; f < areas.size(); ++f) {
    const int part = mesh.face_part[f];
    area[part] += areas[f];
    for (const int n : mesh.faces[f])
      middle[part] = middle[part] + areas[f] / 3 * flat.positions[n];
  }
  for (size_t part = 0; part < middle.size(); ++part)
    if (area[part] > 0) middle[part] = 1 / area[part] * middle[part];
  return middle;
}

}  // namespace

ShiftMetric make_shift_metric(const Discretisation& discretisation, double epsilon) {
  ShiftMetric metric{discretisation.scale, discretisation.L, {}};
  metric.A.diagonal() += epsilon * discretisation.mass;
  metric.lean.pull = Eigen::VectorXd::Zero(discretisation.mass.size());
  return metric;
}

LeanTerm lean_term(const LayeredMesh& mesh, const Scene& scene, double scale, double epsilon) {
  const auto upright = [](const Part& part) { return part.lean == Point2{}; };
  if (std::all_of(scene.parts.begin(), scene.parts.end(), upright))
    return {Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.node_vertex.size())), 0};
  const std::vector<Point2> positions = node_positions(mesh, scale);
  const FlatMesh flat{positions, mesh.faces};
  const std::vector<double> areas = triangle_areas(flat);
  const std::vector<Point2> middle = middles(mesh, flat, areas);
  std::vector<Point2> leans;
  leans.reserve(mesh.faces.size());
  for (const int part : mesh.face_part) leans.push_back(scene.parts[part].lean);
  LeanTerm term{divergence_load(flat, leans), 0};
  for (size_t f = 0; f < areas.size(); ++f) {
    term.constant += areas[f] * dot(leans[f], leans[f]) / 2;
    for (const int n : mesh.faces[f]) {
      const double mass = epsilon * areas[f] / 3;
      const double target = dot(leans[f], positions[n] - middle[mesh.face_part[f]]);
      term.pull[n] += mass * target;
      term.constant += mass * target * target / 2;
    }
  }
  return term;
}

Eigen::VectorXd inflated_heights(const std::vector<double>& u) {
  Eigen::VectorXd f(static_cast<Eigen::Index>(u.size()));
  for (Eigen::Index n = 0; n < f.size(); ++n) f[n] = signed_root(u[n]);
  return f;
}

}  // namespace relievo
