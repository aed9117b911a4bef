#include "relief/discretisation/discretise.h"

#include <array>
#include <functional>

#include "kernel/base/stopwatch.h"
#include "kernel/base/workers.h"
#include "kernel/operators/dissection.h"
#include "kernel/operators/laplacian.h"
#include "relief/layers/joined_surface.h"

namespace relievo {
namespace {

/// Dissects the base triangulation: what lies at one place is eliminated together.
std::vector<int> elimination_order(const LayeredMesh& mesh, const RunContext& context) {
  std::vector<int> weights(mesh.vertices.size(), 0);
  for (const int v : mesh.node_vertex) ++weights[v];
  const std::vector<int> order =
      dissection_order({mesh.vertices, mesh.triangles}, weights, context);
  std::vector<int> place(mesh.vertices.size());
  int next = 0;
  for (const int v : order) {
    place[v] = next;
    next += weights[v];
  }
  std::vector<int> nodes(mesh.node_vertex.size());
  for (size_t n = 0; n < nodes.size(); ++n)
    nodes[place[mesh.node_vertex[n]]++] = static_cast<int>(n);
  return nodes;
}

}  // namespace

Discretisation discretise(const LayeredMesh& mesh, const RunContext& context) {
  Discretisation result;
  result.scale = scene_scale(mesh);
  const std::vector<Point2> in_px = node_positions(mesh);
  const std::vector<Point2> in_units = node_positions(mesh, result.scale);
  const std::vector<std::array<int, 3>> faces = shaping_faces(mesh);
  const FlatMesh flat{in_units, faces};
  result.surface = joined_surfaces(mesh);
  if (context.cancelled()) return result;
  const Stopwatch all;
  double analysing = 0;
  const std::array<std::function<void()>, 3> work = {
      [&] {
        const Stopwatch own;
        result.elimination = elimination_order(mesh, context);
        analysing = own.milliseconds();
      },
      [&] {
        result.L = stiffness_matrix(flat);
        result.mass = lumped_mass(flat);
      },
      [&] {
        result.gradients = gradient_stencils({in_px, faces});
        result.creases = crease_stencils(mesh);
      },
  };
  run_tasks(3, [&](int i) { work[i](); });
  if (!context.timed) return result;
  context.timed("analyse", analysing);
  context.timed("assemble", all.milliseconds() - analysing);
  return result;
}

}  // namespace relievo
