#include "relief/inflation/poisson_terms.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernel/geometry/polygon.h"
#include "kernel/operators/laplacian.h"
#include "relief/cues/bulge_field.h"
#include "relief/layers/joined_surface.h"

namespace relievo {

namespace {

/// k of a part with flat = 1.
constexpr double flattest = 8;
/// Below, the profile is round to all digits that count.
constexpr double roundest = 1e-3;

}  // namespace

Source source_of(const Part& part, double scale) {
  Source source{part.c * part.d * std::abs(part.d), 0};
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
  std::vector<Source> sources;
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
                                 [](const Source& source) { return source.screening == 0; });
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
