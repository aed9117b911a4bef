#include "kernel/operators/gradient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/structured_meshes.h"

namespace relievo {
namespace {

using testing::PlanarMesh;

std::vector<double> sampled(const PlanarMesh& mesh, const std::function<double(Point2)>& value) {
  std::vector<double> values;
  for (const Point2 p : mesh.vertices) values.push_back(value(p));
  return values;
}

double smooth(Point2 p) { return std::sin(2 * p.x) * std::exp(p.y) + p.x * p.x * p.x; }

Point2 smooth_gradient(Point2 p) {
  return {2 * std::cos(2 * p.x) * std::exp(p.y) + 3 * p.x * p.x, std::sin(2 * p.x) * std::exp(p.y)};
}

double worst_error(int rings) {
  const PlanarMesh mesh = testing::jittered(testing::disc_mesh(1, rings), 0.25 / rings);
  const std::vector<Point2> gradients = node_gradients(mesh.flat(), sampled(mesh, smooth));
  double worst = 0;
  for (size_t v = 0; v < gradients.size(); ++v)
    worst = std::max(worst, norm(gradients[v] - smooth_gradient(mesh.vertices[v])));
  return worst;
}

TEST(FaceGradients, AreExactForLinearFunctions) {
  const PlanarMesh mesh = testing::jittered(testing::grid_mesh(6, 5, 2), 0.6);
  const auto linear = [](Point2 p) { return 4 - 3 * p.x + 0.25 * p.y; };
  for (const Point2 g : face_gradients(mesh.flat(), sampled(mesh, linear)))
    EXPECT_LE(norm(g - Point2{-3, 0.25}), 1e-12);
}

TEST(NodeGradients, AreExactForQuadraticFunctionsOnTheBoundaryToo) {
  const PlanarMesh mesh = testing::jittered(testing::disc_mesh(3, 8), 0.1);
  const auto quadratic = [](Point2 p) {
    return 1 + p.x - 2 * p.y + p.x * p.x + 0.5 * p.x * p.y - 3 * p.y * p.y;
  };
  const std::vector<Point2> gradients = node_gradients(mesh.flat(), sampled(mesh, quadratic));
  for (size_t v = 0; v < gradients.size(); ++v) {
    const Point2 p = mesh.vertices[v];
    const Point2 exact{1 + 2 * p.x + 0.5 * p.y, -2 + 0.5 * p.x - 6 * p.y};
    EXPECT_LE(norm(gradients[v] - exact), 1e-10);
  }
}

TEST(NodeGradients, AreSecondOrderForSmoothFunctions) {
  const double coarse = worst_error(10);
  const double middle = worst_error(20);
  const double fine = worst_error(40);
  EXPECT_GE(std::log2(coarse / middle), 1.7);
  EXPECT_GE(std::log2(middle / fine), 1.7);
}

TEST(NodeGradients, FallBackToTheMeanWhereAFitIsImpossible) {
  PlanarMesh triangle{{{0, 0}, {2, 0}, {0, 1}, {5, 5}}, {{0, 1, 2}}};
  const auto linear = [](Point2 p) { return 2 * p.x - p.y; };
  const std::vector<Point2> gradients = node_gradients(triangle.flat(), sampled(triangle, linear));
  for (int v = 0; v < 3; ++v) EXPECT_LE(norm(gradients[v] - Point2{2, -1}), 1e-14);
  EXPECT_EQ(gradients[3], Point2{});
}

}  // namespace
}  // namespace relievo
