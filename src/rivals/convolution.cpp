#include "rivals/convolution.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <utility>

namespace relievo {
namespace {

/// Of the kernel: it ends where x reaches this.
constexpr double support = 2;
/// 1 over the integral of the kernel over an infinite line at distance 1.
constexpr double line_scale = 1.49683;
constexpr double point_scale = 64.0 / 27;
/// Of the grid that finds bones.
constexpr int cells_across = 100;

double kernel(double squared_distance, double radius) {
  const double rest = 1 - squared_distance / (support * support * radius * radius);
  return rest > 0 ? rest * rest * rest : 0;
}

double squared_distance(Point3 a, Point3 b) { return dot(a - b, a - b); }

/// Where along the bone the kernel is positive, within [0, 1]: |a + t d - p| < support (r + t s),
/// between two places, or beyond one where the radius changes faster than the place.
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

}  // namespace relievo
