#include "understanding/completion/shape_candidates.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/ellipse.h"
#include "kernel/image/diffusion.h"
#include "kernel/image/distance_transform.h"

namespace relievo::understanding {
namespace {

constexpr size_t ellipse_samples = 100;  ///< approximate number of contour points in a fit
constexpr size_t violations = 50;        ///< approximate number of violated points that are added
constexpr double violation = 0.5;        ///< distance by which a first fit violates a point, px
constexpr int ellipse_points = 180;      ///< corners of the polygon of an ellipse
/// Noise of a contour: the larger of a distance in px and a share of the part's size.
constexpr double ellipse_noise = 0.8;
constexpr double ellipse_noise_share = 0.012;
/// The length of a contour without an end of its own, as a share of the visible part's size.
constexpr double endless_share = 0.25;

double size_of(const Mask& mask) { return std::sqrt(static_cast<double>(pixel_count(mask))); }

/// The known sides (`hidden_ones` 0) or the hidden sides (1) of the outer rings, away from
/// junctions.
std::vector<Point2> ring_points(const HiddenPart& hidden, uint8_t hidden_ones) {
  std::vector<Point2> points;
  for (size_t r = 0; r < hidden.rings().size(); ++r) {
    const LabelRing& ring = hidden.rings()[r];
    const std::vector<uint8_t>& flags = hidden.known[r].hidden;
    if (ring.hole) continue;
    const size_t n = ring.size();
    for (size_t i = 0; i < n; ++i) {
      bool clear = flags[i] == hidden_ones;
      for (size_t k = 1; k <= junction_sides && clear; ++k)
        clear = flags[(i + k) % n] == hidden_ones && flags[(i + n * k - k) % n] == hidden_ones;
      if (clear) points.push_back(ring.sides[i]);
    }
  }
  return points;
}

/// The sides between occluders and parts or background that cannot hide the part, beyond which it
/// would be seen.
std::vector<Point2> occluder_borders(const HiddenPart& hidden) {
  const auto hides = [&](int other) { return other >= 0 && hidden.hides[other] != 0; };
  std::vector<Point2> points;
  for (int other = 0; other < hidden.regions.count(); ++other) {
    if (!hides(other)) continue;
    for (const LabelRing& ring : hidden.regions.rings[other])
      for (size_t i = 0; i < ring.size(); ++i) {
        const int beyond = hidden.regions.part_of(ring.beyond[i]);
        if (beyond != hidden.part && !hides(beyond)) points.push_back(ring.sides[i]);
      }
  }
  return points;
}

std::vector<Point2> thinned(const std::vector<Point2>& points, size_t about) {
  const size_t step = std::max<size_t>(1, points.size() / about);
  std::vector<Point2> few;
  for (size_t i = 0; i < points.size(); i += step) few.push_back(points[i]);
  return few;
}

/// Appends some of the points to the list.
void add_thinned(const std::vector<Point2>& points, std::vector<Point2>& list) {
  for (const Point2 p : thinned(points, violations)) list.push_back(p);
}

/// The ellipse through `on` that contains `within` and excludes `without`. It is fitted to some of
/// the points, and then once more with some of the points that the first fit violates.
std::optional<Ellipse> fit_to_boundaries(const std::vector<Point2>& on,
                                         const std::vector<Point2>& within,
                                         const std::vector<Point2>& without) {
  EllipseEvidence evidence;
  evidence.on = thinned(on, ellipse_samples);
  evidence.within = thinned(within, ellipse_samples);
  evidence.without = thinned(without, ellipse_samples);
  const auto first = fit_ellipse(evidence);
  if (!first) return std::nullopt;
  std::vector<Point2> left_out;
  std::vector<Point2> covered;
  for (const Point2 p : within)
    if (first_order_distance(*first, p) > violation) left_out.push_back(p);
  for (const Point2 p : without)
    if (first_order_distance(*first, p) < -violation) covered.push_back(p);
  if (left_out.empty() && covered.empty()) return first;
  add_thinned(left_out, evidence.within);
  add_thinned(covered, evidence.without);
  return fit_ellipse(evidence);
}

double rms_distance(const Ellipse& ellipse, const std::vector<Point2>& points) {
  double sum = 0;
  for (const Point2 p : points) {
    const double d = first_order_distance(ellipse, p);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(std::max<size_t>(points.size(), 1)));
}

Image8 above_half(const ImageF& p) {
  Image8 above(p.width, p.height, 1);
  for (size_t i = 0; i < p.pixels.size(); ++i) above.pixels[i] = p.pixels[i] > 0.5F ? 1 : 0;
  return above;
}

/// Whether the shape has pixels at the border of its box.
bool reaches_border(const Mask& shape) {
  const Image8& inside = shape.inside;
  for (int x = 0; x < inside.width; ++x)
    if (inside.at(x, 0) != 0 || inside.at(x, inside.height - 1) != 0) return true;
  for (int y = 0; y < inside.height; ++y)
    if (inside.at(0, y) != 0 || inside.at(inside.width - 1, y) != 0) return true;
  return false;
}

/// Removes pixels that are farther from the visible part than a share of its size.
void cut_off(Mask& shape, const Mask& visible) {
  Image8 seen(shape.inside.width, shape.inside.height, 1);
  for_each_pixel(visible, [&](int x, int y) { seen.at(x - shape.left, y - shape.top) = 1; });
  const double reach = endless_share * std::max(visible.inside.width, visible.inside.height);
  const auto squares = squared_distance_to(seen);
  for (size_t i = 0; i < squares.pixels.size(); ++i)
    if (squares.pixels[i] > reach * reach) shape.inside.pixels[i] = 0;
}

/// The convex hull of the visible part.
Mask hull_of(const HiddenPart& hidden) {
  std::vector<Point2> sides;
  for (const LabelRing& ring : hidden.rings())
    sides.insert(sides.end(), ring.sides.begin(), ring.sides.end());
  return fill_outline({convex_hull(std::move(sides))}, hidden.regions.map.width,
                      hidden.regions.map.height);
}

Box2 grown(const Mask& mask, double share) {
  const double margin = share * std::max(mask.inside.width, mask.inside.height) + 2;
  return {{mask.left - margin, mask.top - margin}, {mask.right() + margin, mask.bottom() + margin}};
}

}  // namespace

bool HiddenPart::has_gaps() const {
  return std::any_of(known.begin(), known.end(),
                     [](const KnownContour& k) { return k.nothing || !k.gaps.empty(); });
}

HiddenPart hidden_part(const PartRegions& regions, int part, const std::vector<int>& occluders) {
  HiddenPart hidden{regions, part, std::vector<uint8_t>(regions.labels.size(), 0), {}};
  for (const int other : occluders) hidden.hides[other] = 1;
  for (const LabelRing& ring : hidden.rings()) {
    std::vector<uint8_t> flags(ring.size());
    for (size_t i = 0; i < ring.size(); ++i) {
      const int other = regions.part_of(ring.beyond[i]);
      flags[i] = other >= 0 ? hidden.hides[other] : uint8_t{0};
    }
    hidden.known.push_back(find_gaps(ring, std::move(flags)));
  }
  return hidden;
}

double contour_tolerance(const HiddenPart& hidden) {
  return std::max(ellipse_noise, ellipse_noise_share * size_of(hidden.visible()));
}

std::optional<Mask> ellipse_shape(const HiddenPart& hidden, double tolerance) {
  const std::vector<Point2> on = ring_points(hidden, 0);
  const auto ellipse = fit_to_boundaries(on, ring_points(hidden, 1), occluder_borders(hidden));
  if (!ellipse) return std::nullopt;
  if (rms_distance(*ellipse, on) > tolerance) return std::nullopt;
  return fill_outline({ring_of(*ellipse, ellipse_points)}, hidden.regions.map.width,
                      hidden.regions.map.height);
}

std::optional<Mask> continued_shape(const HiddenPart& hidden) {
  const auto outline = bridge_gaps(hidden.rings(), hidden.known);
  if (!outline) return std::nullopt;
  return fill_outline(*outline, hidden.regions.map.width, hidden.regions.map.height);
}

Mask membrane_shape(const HiddenPart& hidden) {
  const Image16& labels = hidden.regions.map;
  const Box2 box = grown(hidden.visible(), 0.5);
  const int left = std::max(0, static_cast<int>(box.min.x));
  const int top = std::max(0, static_cast<int>(box.min.y));
  const int right = std::min(labels.width, static_cast<int>(box.max.x) + 1);
  const int bottom = std::min(labels.height, static_cast<int>(box.max.y) + 1);
  ImageF known(right - left, bottom - top, 2);
  const auto fix = [&](int x, int y, float value) {
    if (x < left || y < top || x >= right || y >= bottom) return;
    known.at(x - left, y - top, 0) = value;
    known.at(x - left, y - top, 1) = fixed_weight;
  };
  const auto other_side = [&](int px, int py, int x, int y) {
    if (x < 0 || y < 0 || x >= labels.width || y >= labels.height) return;
    const int other = hidden.regions.part_at(x, y);
    if (other == hidden.part || (other >= 0 && hidden.hides[other] != 0)) return;
    fix(px, py, 1);
    fix(x, y, 0);
  };
  for_each_pixel(hidden.visible(), [&](int x, int y) {
    other_side(x, y, x - 1, y);
    other_side(x, y, x + 1, y);
    other_side(x, y, x, y - 1);
    other_side(x, y, x, y + 1);
  });
  Mask shape{left, top, above_half(diffuse(known))};
  if (reaches_border(shape)) cut_off(shape, hidden.visible());
  for_each_pixel(hull_of(hidden), [&](int x, int y) { shape.add(x, y); });
  return shape;
}

}  // namespace relievo::understanding
