#pragma once

#include <cmath>
#include <vector>

namespace relievo {

/// A point or vector in the plane. Canvas coordinates: px, origin top-left, x right, y down.
struct Point2 {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

inline Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
inline Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
inline Point2 operator*(double s, Point2 a) { return {s * a.x, s * a.y}; }
inline double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
inline double norm(Point2 a) { return std::sqrt(dot(a, a)); }
inline double distance(Point2 a, Point2 b) { return norm(a - b); }

/// A closed polyline; the last point connects to the first, which is not repeated.
using Ring = std::vector<Point2>;

/// A region bounded by rings, filled by the non-zero rule: a point is inside if the sum of the
/// rings' winding numbers is not 0. A hole runs against the ring around it.
using Outline = std::vector<Ring>;

/// A point or vector in model space: X right, Y up, Z towards the viewer, right-handed.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;
  friend bool operator==(const Point3&, const Point3&) = default;
};

inline Point3 operator+(Point3 a, Point3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point3 operator*(double s, Point3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point3 cross(Point3 a, Point3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Point3 a) { return std::sqrt(dot(a, a)); }

/// Returns a / |a|, or the zero vector if |a| is 0.
inline Point3 normalized(Point3 a) {
  const double n = norm(a);
  return n > 0 ? (1 / n) * a : Point3{};
}

}  // namespace relievo
