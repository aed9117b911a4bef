#include "relief/ordering/lean_term.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/operators/laplacian.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/layers/joined_surface.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// How little the size of the constants counts against their differences.
constexpr double weakest = 1e-6;

/// A piece of the plane: its area, and the integral of the position over it.
struct Piece {
  double area = 0;
  Point2 moment;

  void add(double piece, Point2 centre) {
    area += piece;
    moment = moment + piece * centre;
  }
  Point2 centre() const { return 1 / area * moment; }
};

/// The faces of each part, and where parts are next to each other in the stack.
struct Cover {
  std::vector<Piece> parts;
  std::map<std::pair<int, int>, Piece> overlaps;  ///< of the lower and the upper part
};

Cover cover_of(const LayeredMesh& mesh, const FlatMesh& flat, const std::vector<double>& areas) {
  Cover cover{std::vector<Piece>(static_cast<size_t>(mesh.part_count)), {}};
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f) {
      Point2 centre;
      for (const int n : mesh.faces[f]) centre = centre + 1.0 / 3 * flat.positions[n];
      cover.parts[mesh.source(f)].add(areas[f], centre);
      if (f > mesh.stack_begin[t])
        cover.overlaps[{mesh.source(f - 1), mesh.source(f)}].add(areas[f], centre);
    }
  return cover;
}

/// The constant of each part, #parts.
VectorXd constants_of(const Cover& cover, const Scene& scene) {
  const auto count = static_cast<int>(cover.parts.size());
  std::vector<Eigen::Triplet<double>> entries;
  VectorXd force = VectorXd::Zero(count);
  for (int part = 0; part < count; ++part) {
    const Piece& piece = cover.parts[part];
    const double weight = piece.area > 0 ? weakest * piece.area : 1;
    entries.emplace_back(part, part, weight);
    force[part] -= weight * dot(scene.parts[part].lean, piece.area > 0 ? piece.centre() : Point2{});
  }
  for (const auto& [parts, overlap] : cover.overlaps) {
    const auto [lower, upper] = parts;
    entries.emplace_back(lower, lower, overlap.area);
    entries.emplace_back(upper, upper, overlap.area);
    entries.emplace_back(std::max(lower, upper), std::min(lower, upper), -overlap.area);
    const double step = dot(scene.parts[upper].lean - scene.parts[lower].lean, overlap.moment);
    force[upper] -= step;
    force[lower] += step;
  }
  SparseMatrix K(count, count);
  K.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky factor;
  factor.analyse(K);
  return factor.factorise(K) ? factor.solve(force) : VectorXd::Zero(count);
}

}  // namespace

LeanTerm lean_term(const LayeredMesh& mesh, const Scene& scene, double scale, double epsilon) {
  const auto upright = [](const Part& part) { return part.lean == Point2{}; };
  if (std::all_of(scene.parts.begin(), scene.parts.end(), upright))
    return {VectorXd::Zero(static_cast<Eigen::Index>(mesh.node_vertex.size())), 0};
  const std::vector<Point2> positions = node_positions(mesh, scale);
  const FlatMesh flat{positions, mesh.faces};
  const std::vector<double> areas = triangle_areas(flat);
  const VectorXd constants = constants_of(cover_of(mesh, flat, areas), scene);
  std::vector<Point2> leans;
  leans.reserve(mesh.faces.size());
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    leans.push_back(mesh.is_flap(f) ? Point2{} : scene.parts[mesh.source(f)].lean);
  LeanTerm term{divergence_load(flat, leans), 0};
  for (size_t f = 0; f < areas.size(); ++f) {
    if (mesh.is_flap(f)) continue;
    term.constant += areas[f] * dot(leans[f], leans[f]) / 2;
    const double mass = epsilon * areas[f] / 3;
    for (const int n : mesh.faces[f]) {
      const double target = dot(leans[f], positions[n]) + constants[mesh.source(f)];
      term.pull[n] += mass * target;
      term.constant += mass * target * target / 2;
    }
  }
  return term;
}

}  // namespace relievo
