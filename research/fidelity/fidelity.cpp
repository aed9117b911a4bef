#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "io/svg/read_svg.h"
#include "relief/inflation/inflate.h"
#include "relief/layers/layer_parts.h"
#include "relief/nonlinear/solve_nonlinear.h"
#include "relief/ordering/order_depth.h"
#include "understanding/marks/make_parts.h"

// Measures the difference between the approximate and the non-linear method on layered drawings.
// Usage: relievo-fidelity VERTICES DRAWING.svg...

namespace relievo::research {
namespace {

struct Surface {
  relief::Inflation inflation;
  relief::Ordering ordering;
};

/// Differences over the faces visible from the front.
struct Difference {
  double heights = 0;  ///< rms / standard deviation of the heights of the second surface
  double median = 0;   ///< of the angles between normals, degrees
  double p95 = 0;
};

Point3 normal(const Surface& surface, int node) {
  const double f = std::sqrt(std::abs(surface.inflation.u[node]));
  const Point2 u = surface.inflation.grad_u[node];
  const Point2 g = surface.ordering.grad_g[node];
  const Point3 n{-0.5 * u.x - f * g.x, -0.5 * u.y - f * g.y, f};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  return length > 0 ? (1 / length) * n : Point3{0, 0, 1};
}

double angle(Point3 a, Point3 b) {
  const double cosine = a.x * b.x + a.y * b.y + a.z * b.z;
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / 3.14159265358979323846;
}

/// Returns the angle below which a share of the area lies.
double quantile(const std::vector<std::pair<double, double>>& sorted, double share) {
  double total = 0;
  for (const auto& [value, area] : sorted) total += area;
  double sum = 0;
  for (const auto& [value, area] : sorted)
    if ((sum += area) >= share * total) return value;
  return 0;
}

Difference compare(const relief::LayeredMesh& mesh, const Surface& a, const Surface& b) {
  std::vector<std::pair<double, double>> angles;
  double area_sum = 0, square = 0, height = 0, height_square = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    const Point2 origin = mesh.vertices[corners[0]];
    const double area =
        cross(mesh.vertices[corners[1]] - origin, mesh.vertices[corners[2]] - origin) / 6;
    for (const int n : mesh.faces[mesh.stack_begin[t + 1] - 1]) {
      const double h = b.ordering.h[n];
      const double d = a.ordering.h[n] - h;
      area_sum += area;
      square += area * d * d;
      height += area * h;
      height_square += area * h * h;
      angles.push_back({angle(normal(a, n), normal(b, n)), area});
    }
  }
  std::sort(angles.begin(), angles.end());
  const double mean = height / area_sum;
  const double variance = height_square / area_sum - mean * mean;
  return {std::sqrt(square / area_sum / variance), quantile(angles, 0.5), quantile(angles, 0.95)};
}

struct Robin {
  double alpha0;
  double rho;
};

constexpr Robin robins[] = {{1, 0.25},    {0.1, 0.0625}, {0.1, 0.125}, {0.1, 0.25}, {0.1, 0.5},
                            {0.1, 1},     {0.1, 4},      {0.05, 0.25}, {0.2, 0.25}, {0.05, 0.5},
                            {0.02, 0.25}, {0.2, 0.5},    {0.5, 0.25}};
constexpr double lambdas[] = {100, 1, 0.1, 0.01};

std::string read_file(const char* name) {
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool study(const char* name, int vertices) {
  auto drawing = read_svg(read_file(name));
  if (!drawing || !understanding::make_parts(*drawing)) return false;
  relief::LayerOptions layer_options;
  layer_options.vertex_budget = vertices;
  layer_options.attach = false;  // as in the paper
  const auto mesh = relief::layer_parts(drawing->scene, layer_options);
  if (!mesh) return false;
  const relief::Discretisation operators = relief::discretise(*mesh);
  const relief::SurfaceInput surface{*mesh, operators, drawing->scene};
  relief::PoissonSystem poisson(*mesh, operators, Refactorisation::complete, {});
  std::vector<Surface> approximate;
  for (const Robin& robin : robins) {
    auto inflation = relief::inflate(surface, {robin.alpha0, robin.rho}, poisson);
    if (!inflation) return false;
    relief::OrderingOptions as_in_paper;
    as_in_paper.straight_limbs = as_in_paper.close_caps = false;
    relief::OrderingSystem system;
    auto ordering = relief::order_depth(surface, *inflation, as_in_paper, system);
    if (!ordering) return false;
    approximate.push_back({*inflation, *ordering});
  }
  const auto start = relief::inflate(surface, {}, poisson);
  for (const double lambda : lambdas) {
    relief::NonlinearOptions options;
    options.lambda_bnd = lambda;
    relief::OrderingSystem system;
    const auto solution = relief::solve_nonlinear(surface, *start, options, {}, system);
    if (!solution) return false;
    const Surface exact{solution->inflation, solution->ordering};
    for (size_t i = 0; i < approximate.size(); ++i) {
      const Difference d = compare(*mesh, approximate[i], exact);
      std::printf("%s,%g,%g,%g,%.4f,%.2f,%.2f\n", name, lambda, robins[i].alpha0, robins[i].rho,
                  d.heights, d.median, d.p95);
    }
  }
  return true;
}

}  // namespace
}  // namespace relievo::research

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: relievo-fidelity VERTICES DRAWING.svg...\n");
    return 2;
  }
  std::printf("drawing,lambda_bnd,alpha0,rho,heights,normals_median,normals_p95\n");
  for (int i = 2; i < argc; ++i)
    if (!relievo::research::study(argv[i], std::stoi(argv[1]))) {
      std::fprintf(stderr, "%s cannot be reconstructed\n", argv[i]);
      return 1;
    }
  return 0;
}
