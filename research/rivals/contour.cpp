#include "research/rivals/contour.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace relievo::research {
namespace {

using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Kernel = Triangulation::Geom_traits;
using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Function = std::function<double(Kernel::Point_3)>;
using Surface = CGAL::Implicit_surface_3<Kernel, Function>;

constexpr size_t most_triangles = 2000000;
/// Spacing of the points where refinement begins / the radius there.
constexpr double first_spacing = 0.15;
/// Minimum of the squared sine of a triangle's smallest angle: 25 degrees.
constexpr double least_squared_sine = 0.1786;

Point3 from_cgal(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }
Kernel::Point_3 to_cgal(Point3 p) { return {p.x, p.y, p.z}; }

struct Stopped {};

/// The criterion of refinement: a triangle is too large for its place, or a sliver.
class Sizes {
 public:
  using Facet = Triangulation::Facet;
  using Quality = double;

  Sizes(const Convolution& convolution, double cell, double smallest, const RunContext& context)
      : convolution_(convolution), cell_(cell), smallest_(smallest), context_(context) {}

  bool is_bad(const Facet& facet, Quality& quality) const {
    if (context_.cancelled()) throw Stopped();
    const Kernel::Point_3& centre = facet.first->get_facet_surface_center(facet.second);
    std::array<Point3, 3> p;
    for (int k = 0; k < 3; ++k)
      p[k] = from_cgal(facet.first->vertex((facet.second + k + 1) % 4)->point());
    const Point3 middle = from_cgal(centre);
    const double most = std::max(smallest_, cell_ * convolution_.radius(middle));
    const double size = norm(p[0] - middle) / most;
    const double thinness = least_squared_sine / squared_sine(p);
    // Sizes come first, since only the angles of final triangles matter.
    quality = size > 1 ? 1 / (1 + size) : 1 / thinness;
    return size > 1 || thinness > 1;
  }

 private:
  /// The squared sine of the smallest angle, which is opposite to the shortest edge.
  static double squared_sine(const std::array<Point3, 3>& p) {
    std::array<double, 3> squares{};
    for (int k = 0; k < 3; ++k) {
      const Point3 edge = p[(k + 2) % 3] - p[(k + 1) % 3];
      squares[k] = dot(edge, edge);
    }
    std::sort(squares.begin(), squares.end());
    const Point3 normal = cross(p[1] - p[0], p[2] - p[0]);
    return dot(normal, normal) / (squares[1] * squares[2]);
  }

  const Convolution& convolution_;
  double cell_;
  double smallest_;
  const RunContext& context_;
};

/// Returns the point where a ray from inside leaves the surface, or nothing.
std::optional<Point3> leave(const Convolution& convolution, Point3 from, Point3 step) {
  if (convolution.value(from) <= 1) return std::nullopt;
  Point3 inside = from;
  while (convolution.value(inside + step) > 1) inside = inside + step;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (convolution.value(inside + middle * step) > 1 ? low : high) = middle;
  }
  return inside + low * step;
}

bool is_apart(const std::vector<Point3>& points, Point3 p, double least) {
  return std::none_of(points.begin(), points.end(),
                      [&](Point3 other) { return norm(other - p) < least; });
}

/// Directions of the corners and faces of a cube, slightly rotated.
std::vector<Point3> first_points(const Convolution& convolution) {
  std::vector<Point3> points;
  for (const Bone& bone : convolution.bones()) {
    const double radius = 0.5 * (bone.radius_a + bone.radius_b);
    const Point3 middle = 0.5 * (bone.a + bone.b);
    for (const Point3 d : {Point3{1, 0.03, 0.02}, {0.02, 1, 0.03}, {0.03, 0.02, 1}})
      for (const double sign : {1.0, -1.0})
        if (const auto p = leave(convolution, middle, (0.25 * sign * radius) * d))
          if (is_apart(points, *p, first_spacing * radius)) points.push_back(*p);
  }
  return points;
}

/// Sorts the vertices and triangles, so that their order depends on the surface alone.
TriangleSurface sorted(const TriangleSurface& surface) {
  std::vector<int> order(surface.positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) {
    const Point3 p = surface.positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  TriangleSurface result;
  std::vector<int> number(order.size());
  for (const int i : order) {
    number[i] = static_cast<int>(result.positions.size());
    result.positions.push_back(surface.positions[i]);
  }
  for (std::array<int, 3> triangle : surface.triangles) {
    for (int& corner : triangle) corner = number[corner];
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    result.triangles.push_back(triangle);
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  return result;
}

TriangleSurface triangles_of(const Complex& complex, const Convolution& convolution) {
  TriangleSurface surface;
  std::map<Triangulation::Vertex_handle, int> number;
  for (auto facet = complex.facets_begin(); facet != complex.facets_end(); ++facet) {
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      const auto vertex = facet->first->vertex((facet->second + k + 1) % 4);
      const auto [place, is_new] =
          number.insert({vertex, static_cast<int>(surface.positions.size())});
      if (is_new) surface.positions.push_back(from_cgal(vertex->point()));
      corners[k] = place->second;
    }
    surface.triangles.push_back(corners);
  }
  // The field decreases outwards.
  for (auto& [a, b, c] : surface.triangles) {
    const auto& p = surface.positions;
    const Point3 normal = cross(p[b] - p[a], p[c] - p[a]);
    const Point3 middle = (1.0 / 3) * (p[a] + p[b] + p[c]);
    if (dot(normal, convolution.gradient(middle)) > 0) std::swap(b, c);
  }
  return sorted(surface);
}

/// The kernel is 0 from this x on.
constexpr double support = 2;
/// 1 / the integral of the kernel along an infinite line at distance 1.
constexpr double line_scale = 1.49683;
constexpr double point_scale = 64.0 / 27;
/// Of the grid that finds bones.
constexpr int cells_across = 100;

double kernel(double squared_distance, double radius) {
  const double rest = 1 - squared_distance / (support * support * radius * radius);
  return rest > 0 ? rest * rest * rest : 0;
}

double squared_distance(Point3 a, Point3 b) { return dot(a - b, a - b); }

/// Returns the range of t in [0, 1] in which the kernel is positive: |a + t d - p| < support (r + t
/// s). It lies between two roots, or beyond one if the radius changes faster than the position.
std::pair<double, double> reach(const Bone& bone, Point3 p) {
  const Point3 d = bone.b - bone.a;
  const Point3 from = bone.a - p;
  const double r = support * bone.radius_a;
  const double s = support * (bone.radius_b - bone.radius_a);
  const double a = dot(d, d) - s * s;
  const double b = dot(d, from) - s * r;
  const double c = dot(from, from) - r * r;
  if (a == 0) return {0, 1};
  const double discriminant = b * b - a * c;
  if (discriminant <= 0) return {0, a > 0 ? 0 : 1};
  const double root = std::sqrt(discriminant);
  if (a < 0 && s > 0) return {std::max(0.0, (-b - root) / a), 1};
  if (a < 0) return {0, std::min(1.0, (-b + root) / a)};
  return {std::max(0.0, (-b - root) / a), std::min(1.0, (-b + root) / a)};
}

}  // namespace

Result<TriangleSurface> contour(const Convolution& convolution, double cell, double smallest,
                                const RunContext& context) {
  const std::vector<Point3> first = first_points(convolution);
  if (first.empty()) return TriangleSurface{};
  Point3 low = first.front();
  Point3 high = low;
  Triangulation triangulation;
  for (const Point3 p : first) {
    triangulation.insert(to_cgal(p));
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double reach = norm(high - low);
  const Function outside = [&](const Kernel::Point_3& p) {
    return 1 - convolution.value(from_cgal(p));
  };
  const Kernel::Point_3 centre = to_cgal(0.5 * (low + high));
  // The mesher orders facets by their addresses, so vertices of two runs agree only as closely as
  // they lie on the surface.
  const Surface surface(outside, Kernel::Sphere_3(centre, reach * reach), 1e-10);
  Complex complex(triangulation);
  try {
    CGAL::make_surface_mesh(complex, surface, Sizes(convolution, cell, smallest, context),
                            CGAL::Manifold_tag(), 0);
  } catch (const Stopped&) {
    return interrupted_error();
  }
  if (complex.number_of_facets() > most_triangles)
    return Error{ErrorCode::limit, "the surface has too many triangles; use larger cells", "cell"};
  return triangles_of(complex, convolution);
}

double field(const Bone& bone, Point3 p) {
  const Point3 d = bone.b - bone.a;
  const double length = norm(d);
  if (length == 0) return point_scale * kernel(squared_distance(p, bone.a), bone.radius_a);
  const auto [begin, end] = reach(bone, p);
  if (begin >= end) return 0;
  const auto density = [&](double t) {
    const double radius = bone.radius_a + t * (bone.radius_b - bone.radius_a);
    return kernel(squared_distance(p, bone.a + t * d), radius) / radius;
  };
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  return line_scale * length * Gauss::integrate(density, begin, end);
}

Convolution::Convolution(std::vector<Bone> bones) : bones_(std::move(bones)) {
  if (bones_.empty()) return;
  std::vector<std::array<Point3, 2>> boxes;
  Point3 high = bones_[0].a;
  origin_ = high;
  double widest = 0;
  for (const Bone& bone : bones_) {
    const double reach = support * std::max(bone.radius_a, bone.radius_b);
    const Point3 low{std::min(bone.a.x, bone.b.x) - reach, std::min(bone.a.y, bone.b.y) - reach, 0};
    const Point3 top{std::max(bone.a.x, bone.b.x) + reach, std::max(bone.a.y, bone.b.y) + reach, 0};
    boxes.push_back({low, top});
    origin_ = {std::min(origin_.x, low.x), std::min(origin_.y, low.y), 0};
    high = {std::max(high.x, top.x), std::max(high.y, top.y), 0};
    widest = std::max({widest, high.x - origin_.x, high.y - origin_.y});
  }
  cell_ = widest / cells_across;
  columns_ = static_cast<int>((high.x - origin_.x) / cell_) + 1;
  rows_ = static_cast<int>((high.y - origin_.y) / cell_) + 1;
  near_.resize(static_cast<size_t>(columns_) * rows_);
  for (size_t i = 0; i < boxes.size(); ++i) {
    const auto& [low, top] = boxes[i];
    for (int y = static_cast<int>((low.y - origin_.y) / cell_);
         y <= static_cast<int>((top.y - origin_.y) / cell_); ++y)
      for (int x = static_cast<int>((low.x - origin_.x) / cell_);
           x <= static_cast<int>((top.x - origin_.x) / cell_); ++x)
        near_[static_cast<size_t>(y) * columns_ + x].push_back(static_cast<int>(i));
  }
}

template <class Visit>
void Convolution::for_each_near(Point3 p, Visit visit) const {
  const double x = (p.x - origin_.x) / cell_;
  const double y = (p.y - origin_.y) / cell_;
  if (!(x >= 0 && y >= 0 && x < columns_ && y < rows_)) return;
  for (const int i : near_[static_cast<size_t>(y) * columns_ + static_cast<size_t>(x)])
    visit(bones_[i]);
}

double Convolution::value(Point3 p) const {
  double sum = 0;
  for_each_near(p, [&](const Bone& bone) { sum += field(bone, p); });
  return sum;
}

Point3 Convolution::gradient(Point3 p) const {
  const double h = 1e-4 * std::max(radius(p), 1e-3);
  const auto slope = [&](Point3 step) { return (value(p + step) - value(p - step)) / (2 * h); };
  return {slope({h, 0, 0}), slope({0, h, 0}), slope({0, 0, h})};
}

double Convolution::radius(Point3 p) const {
  double sum = 0;
  double weight = 0;
  for_each_near(p, [&](const Bone& bone) {
    const double f = field(bone, p);
    sum += f * 0.5 * (bone.radius_a + bone.radius_b);
    weight += f;
  });
  return weight > 0 ? sum / weight : 0;
}

}  // namespace relievo::research
