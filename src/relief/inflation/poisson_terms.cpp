#include "relief/inflation/poisson_terms.h"

#include <cmath>
#include <cstdint>

#include "kernel/operators/laplacian.h"

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

std::vector<int> surface_signs(const LayeredMesh& mesh, const std::vector<int>& surface,
                               const Scene& scene) {
  std::vector<uint8_t> raised(mesh.node_vertex.size(), 0);
  std::vector<uint8_t> sunk(raised);
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    (scene.parts[mesh.face_part[f]].d > 0 ? raised : sunk)[surface[mesh.faces[f][0]]] = 1;
  std::vector<int> signs;
  signs.reserve(raised.size());
  for (const int s : surface) signs.push_back(raised[s] - sunk[s]);
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

std::vector<int> order_of_places(const std::vector<int>& order, const std::vector<int>& place) {
  std::vector<int> places;
  places.reserve(order.size());
  for (const int n : order)
    if (place[n] >= 0) places.push_back(place[n]);
  return places;
}

Inflation make_inflation(const GradientStencils& gradients, const Eigen::VectorXd& u,
                         double scale) {
  Inflation inflation;
  inflation.u.reserve(static_cast<size_t>(u.size()));
  for (const double value : u) inflation.u.push_back(value / (scale * scale));
  inflation.grad_u = node_gradients(gradients, inflation.u);
  return inflation;
}

}  // namespace relievo
