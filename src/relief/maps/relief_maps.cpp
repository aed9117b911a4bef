#include "relief/maps/relief_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace relievo::relief {
namespace {

constexpr int max_side = 32768;
constexpr int64_t max_pixels = int64_t{1} << 28;

/// A point in fixed-point pixels, so that every pixel centre is on exactly one side of an edge.
using FixedPoint = std::array<int64_t, 2>;

Status check_size(int width, int height) {
  if (width < 1 || height < 1)
    return Error{ErrorCode::usage, "maps must be at least 1 pixel wide and high", "size"};
  if (width > max_side || height > max_side || int64_t{width} * height > max_pixels)
    return Error{ErrorCode::limit,
                 "maps may have at most " + std::to_string(max_side) + " pixels a side and " +
                     std::to_string(max_pixels) + " in all",
                 "size"};
  return Done{};
}

/// Converts vertices to fixed point, `one` units a pixel, a power of two and at least 2.
/// Differences of coordinates stay below 2^30, so edge functions fit 62 bits.
Result<std::vector<FixedPoint>> to_fixed_point(const SolvedSurface& surface, int width, int height,
                                               int64_t& one) {
  const LayeredMesh& mesh = surface.mesh;
  const double scale_x = width / surface.scene.width;
  const double scale_y = height / surface.scene.height;
  double extent = std::max(width, height);
  for (const Point2 p : mesh.vertices)
    extent = std::max({extent, std::abs(p.x * scale_x), std::abs(p.y * scale_y)});
  const double room = std::ldexp(1.0, 29) / extent;
  if (!(room >= 2)) return Error{ErrorCode::limit, "a part reaches too far off the canvas", ""};
  one = int64_t{1} << std::min(std::ilogb(room), 16);
  const auto unit = static_cast<double>(one);
  std::vector<FixedPoint> points;
  points.reserve(mesh.vertices.size());
  for (const Point2 p : mesh.vertices)
    points.push_back({std::llround(p.x * scale_x * unit), std::llround(p.y * scale_y * unit)});
  return points;
}

int64_t floor_divide(int64_t a, int64_t b) { return a / b - (a % b != 0 && (a < 0) != (b < 0)); }

/// Twice the signed area of the triangle of an edge and a pixel centre. A centre exactly on an edge
/// belongs to the triangle on one side of it, by the direction of the edge: as if all centres were
/// moved by an infinitesimal step.
struct EdgeFunction {
  int64_t at_origin = 0;  ///< at the centre of pixel (0, 0)
  int64_t per_column = 0;
  int64_t per_row = 0;
  int64_t least = 0;  ///< inside where the value is at least this: 0 or 1

  EdgeFunction(const FixedPoint& a, const FixedPoint& b, int64_t one) {
    const int64_t dx = b[0] - a[0];
    const int64_t dy = b[1] - a[1];
    at_origin = dx * (one / 2 - a[1]) - dy * (one / 2 - a[0]);
    per_column = -dy * one;
    per_row = dx * one;
    least = dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;
  }

  /// Narrows [first, last] to the columns that are inside in row `y`.
  void clip(int y, int64_t& first, int64_t& last) const {
    const int64_t lacking = least - (at_origin + y * per_row);
    if (per_column > 0)
      first = std::max(first, -floor_divide(-lacking, per_column));
    else if (per_column < 0)
      last = std::min(last, floor_divide(-lacking, -per_column));
    else if (lacking > 0)
      last = first - 1;
  }

  double value(int64_t x, int y) const {
    return static_cast<double>(at_origin + x * per_column + y * per_row);
  }
};

/// Draws front faces into maps.
class Rasterizer {
 public:
  Rasterizer(const SolvedSurface& surface, const std::vector<FixedPoint>& points, int64_t one)
      : surface_(surface), mesh_(surface.mesh), points_(points), one_(one) {}

  void allocate(int width, int height) {
    maps_.height = ImageF(width, height, 1, std::numeric_limits<float>::quiet_NaN());
    maps_.normal = ImageF(width, height, 3);
    for (size_t i = 2; i < maps_.normal.pixels.size(); i += 3) maps_.normal.pixels[i] = 1;
    maps_.part = Image<int32_t>(width, height, 1, -1);
  }

  void draw(int face) {
    const std::array<int, 3>& triangle = mesh_.triangles[mesh_.face_triangle[face]];
    const FixedPoint& a = points_[triangle[0]];
    const FixedPoint& b = points_[triangle[1]];
    const FixedPoint& c = points_[triangle[2]];
    const int64_t area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area <= 0) return;
    const std::array<EdgeFunction, 3> edges{EdgeFunction(b, c, one_), EdgeFunction(c, a, one_),
                                            EdgeFunction(a, b, one_)};
    const auto [top, bottom] = std::minmax({a[1], b[1], c[1]});
    const int64_t half = one_ / 2;
    const int64_t first_row = std::max<int64_t>(0, -floor_divide(half - top, one_));
    const int64_t last_row =
        std::min<int64_t>(maps_.height.height - 1, floor_divide(bottom - half, one_));
    load_corners(face);
    for (int64_t y = first_row; y <= last_row; ++y)
      draw_row(static_cast<int>(y), edges, 1 / static_cast<double>(area));
  }

  ReliefMaps take() { return std::move(maps_); }

 private:
  void load_corners(int face) {
    part_ = mesh_.face_part[face];
    for (int k = 0; k < 3; ++k) corners_[k] = corner_sample(surface_, face, k);
  }

  void draw_row(int y, const std::array<EdgeFunction, 3>& edges, double inverse_area) {
    int64_t first = 0;
    int64_t last = maps_.height.width - 1;
    for (const EdgeFunction& edge : edges) edge.clip(y, first, last);
    for (int64_t x = first; x <= last; ++x)
      write(static_cast<int>(x), y,
            blend(inverse_area * edges[0].value(x, y), inverse_area * edges[1].value(x, y),
                  inverse_area * edges[2].value(x, y)));
  }

  SurfaceSample blend(double wa, double wb, double wc) const {
    const auto& [a, b, c] = corners_;
    return {wa * a.u + wb * b.u + wc * c.u, wa * a.g + wb * b.g + wc * c.g,
            wa * a.grad_u + wb * b.grad_u + wc * c.grad_u,
            wa * a.grad_g + wb * b.grad_g + wc * c.grad_g};
  }

  void write(int x, int y, const SurfaceSample& sample) {
    const Point3 normal = surface_normal(sample);
    maps_.height.at(x, y) = static_cast<float>(height(sample));
    maps_.normal.at(x, y, 0) = static_cast<float>(normal.x);
    maps_.normal.at(x, y, 1) = static_cast<float>(normal.y);
    maps_.normal.at(x, y, 2) = static_cast<float>(normal.z);
    maps_.part.at(x, y) = part_;
  }

  const SolvedSurface& surface_;
  const LayeredMesh& mesh_;
  const std::vector<FixedPoint>& points_;
  int64_t one_;  ///< units of points per pixel
  ReliefMaps maps_;
  std::array<SurfaceSample, 3> corners_;  ///< of the face being drawn
  int part_ = -1;                         ///< its part
};

}  // namespace

Result<ReliefMaps> rasterize_relief(const SolvedSurface& surface, int width, int height,
                                    const RunContext& context) {
  if (Status status = check_size(width, height); !status.ok()) return status.error();
  if (Status status = check_surface(surface); !status.ok()) return status.error();
  int64_t one = 0;
  const auto points = to_fixed_point(surface, width, height, one);
  if (!points) return points.error();
  Rasterizer rasterizer(surface, *points, one);
  rasterizer.allocate(width, height);
  const LayeredMesh& mesh = surface.mesh;
  const int triangles = static_cast<int>(mesh.triangles.size());
  for (int t = 0; t < triangles; ++t) {
    if (t % 1024 == 0) {
      if (context.cancelled()) return interrupted_error();
      context.report("maps", static_cast<double>(t) / triangles);
    }
    if (mesh.stack_begin[t] < mesh.stack_begin[t + 1]) rasterizer.draw(mesh.stack_begin[t + 1] - 1);
  }
  context.report("maps", 1);
  return rasterizer.take();
}

}  // namespace relievo::relief
