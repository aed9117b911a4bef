#include "relief/inflation/poisson_terms.h"

#include <cmath>
#include <cstdint>

#include "kernel/operators/laplacian.h"
#include "relief/layers/joined_surface.h"

namespace relievo {

Eigen::VectorXd inflation_load(const FlatMesh& flat, const LayeredMesh& mesh, const Scene& scene) {
  std::vector<double> density;
  density.reserve(mesh.faces.size());
  for (const int part : mesh.face_part) {
    const double d = scene.parts[part].d;
    density.push_back(scene.parts[part].c * d * std::abs(d));
  }
  return load_vector(flat, density);
}

DisjointSets connected_surfaces(const LayeredMesh& mesh) {
  DisjointSets surfaces(static_cast<int>(mesh.node_vertex.size()));
  for (const auto& [a, b, c] : mesh.faces) {
    surfaces.unite(a, b);
    surfaces.unite(a, c);
  }
  return surfaces;
}

std::vector<int> surface_signs(const LayeredMesh& mesh, const Scene& scene) {
  DisjointSets surfaces = connected_surfaces(mesh);
  std::vector<uint8_t> raised(mesh.node_vertex.size(), 0);
  std::vector<uint8_t> sunk(raised);
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const int surface = surfaces.find(mesh.faces[f][0]);
    (scene.parts[mesh.face_part[f]].d > 0 ? raised : sunk)[surface] = 1;
  }
  std::vector<int> signs;
  signs.reserve(raised.size());
  for (size_t n = 0; n < raised.size(); ++n) {
    const int surface = surfaces.find(static_cast<int>(n));
    signs.push_back(raised[surface] - sunk[surface]);
  }
  return signs;
}

SparseMatrix lower_block(const SparseMatrix& A, const std::vector<int>& place, int size) {
  SparseMatrix block(size, size);
  block.reserve(A.nonZeros() / 2 + size);
  for (int j = 0; j < A.outerSize(); ++j) {
    if (place[j] < 0) continue;
    block.startVec(place[j]);
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry) {
      const int i = static_cast<int>(entry.row());
      if (i >= j && place[i] >= 0) block.insertBack(place[i], place[j]) = entry.value();
    }
  }
  block.finalize();
  return block;
}

Inflation make_inflation(const GradientStencils& gradients, const Eigen::VectorXd& u,
                         double scale) {
  Inflation inflation;
  inflation.u.reserve(static_cast<size_t>(u.size()));
  for (const double value : u) inflation.u.push_back(value / (scale * scale));
  inflation.grad_u = node_gradients(gradients, inflation.u);
  return inflation;
}

Inflation make_inflation(const LayeredMesh& mesh, const Eigen::VectorXd& u, double scale) {
  const std::vector<Point2> positions = node_positions(mesh);
  return make_inflation(gradient_stencils({positions, mesh.faces}), u, scale);
}

}  // namespace relievo
