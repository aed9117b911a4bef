#include "relief/layers/sample_outlines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "relief/layers/crease_lines.h"

namespace relievo::relief {
namespace {

/// Smallest turn of a corner, over half a spacing on both sides, rad (35 degrees): the corners of a
/// regular polygon stay if it has at most 10 sides.
constexpr double corner_angle = 0.61;

/// Smallest distance of corners from marks, of the spacing. Nearer corners would make short edges.
constexpr double clear_of_marks = 0.3;

/// Largest distance between a chord and the curve, of the spacing. So a chord of one spacing is
/// halved on curves with a radius below 1.6 spacings.
constexpr double max_sagitta = 0.08;

/// How often a chord is halved at most: edges are up to 8 times shorter in tight bends.
constexpr int max_halvings = 3;

/// Fewest edges of a ring: 12 keep 95 % of the area of a small disc.
constexpr int min_ring_edges = 12;

/// Fewest edges of a join: twice those that connect_sheets needs inside the lower part.
constexpr int min_join_edges = 6;

/// Distances of the additional samples on both sides of a join's end, of the spacing: the surface
/// has a crease that begins there, which short edges resolve.
constexpr double end_steps[] = {-1.2, -0.5, -0.2, 0.2, 0.5, 1.2};

/// Smallest distance of these from other samples, of the spacing.
constexpr double clear_of_stops = 0.15;

/// Finds the arc lengths at which the ring turns by more than corner_angle over a window, the
/// sharpest of each neighbourhood.
std::vector<double> corners(const MarkedRing& ring, double window) {
  const double length = ring.measure.length;
  std::vector<double> at;
  std::vector<double> angles;
  for (size_t i = 0; i < ring.ring.size(); ++i) {
    const double s = ring.measure.start[i];
    const Point2 in = ring.ring[i] - point_at(ring.ring, ring.measure, s - window);
    const Point2 out = point_at(ring.ring, ring.measure, s + window) - ring.ring[i];
    const double angle = std::abs(std::atan2(cross(in, out), dot(in, out)));
    if (angle <= corner_angle) continue;
    at.push_back(s);
    angles.push_back(angle);
  }
  const size_t n = at.size();
  std::vector<double> kept;
  for (size_t i = 0; i < n; ++i) {
    bool sharpest = true;
    for (size_t step = 1; step < n && sharpest; ++step) {
      const size_t other = (i + step) % n;
      if (arc_forward(at[i], at[other], length) > window) break;
      sharpest = angles[other] < angles[i];
    }
    for (size_t step = 1; step < n && sharpest; ++step) {
      const size_t other = (i + n - step) % n;
      if (arc_forward(at[other], at[i], length) > window) break;
      sharpest = angles[other] <= angles[i];
    }
    if (sharpest) kept.push_back(at[i]);
  }
  return kept;
}

double spacing_of_ring(const MarkedRing& ring, double spacing) {
  return std::min(spacing, ring.measure.length / min_ring_edges);
}

/// Returns the spacing of samples from one arc length to another, finer along joins.
double spacing_between(const MarkedOutlines& marked, int r, double spacing, double from,
                       double to) {
  const MarkedRing& ring = marked.rings[r];
  spacing = spacing_of_ring(ring, spacing);
  const double middle = from + 0.5 * (to - from);
  for (size_t j = 0; j < marked.joins.size(); ++j) {
    const CurveRun& join = marked.joins[j];
    if (join.curve == r && arc_forward(join.from, middle, ring.measure.length) < join.length)
      spacing = std::min({spacing, join.length / min_join_edges, marked.join_spacing[j]});
  }
  return spacing;
}

/// Adds stops on both sides of the ends of joins.
void refine_at_ends(const MarkedOutlines& marked, int r, double spacing,
                    std::vector<double>& stops) {
  const double length = marked.rings[r].measure.length;
  spacing = spacing_of_ring(marked.rings[r], spacing);
  const std::vector<double> plain = stops;
  for (const CurveRun& join : marked.joins) {
    if (join.curve != r) continue;
    for (const double end : {join.from, join.to})
      for (const double step : end_steps) {
        const double s = arc_forward(0, end + step * spacing, length);
        const bool clear = std::none_of(plain.begin(), plain.end(), [&](double stop) {
          return stop != end && arc_distance(s, stop, length) < clear_of_stops * spacing;
        });
        if (clear) stops.push_back(s);
      }
  }
}

/// Lists the arc lengths on a ring that must be samples, ascending.
std::vector<double> stops_of(const MarkedOutlines& marked, int r, double spacing) {
  const MarkedRing& ring = marked.rings[r];
  std::vector<double> stops = corners(ring, 0.5 * spacing_of_ring(ring, spacing));
  std::erase_if(stops, [&](double s) {
    return std::any_of(ring.marks.begin(), ring.marks.end(), [&](double mark) {
      return arc_distance(s, mark, ring.measure.length) < clear_of_marks * spacing;
    });
  });
  stops.insert(stops.end(), ring.marks.begin(), ring.marks.end());
  refine_at_ends(marked, r, spacing, stops);
  if (stops.empty()) stops.push_back(0);
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  return stops;
}

/// Appends arc lengths between a and b until the chords are within `tolerance` of the ring.
void bisect(const MarkedRing& ring, double a, double b, double tolerance, int halvings,
            std::vector<double>& samples) {
  if (halvings == 0) return;
  const Point2 from = point_at(ring.ring, ring.measure, a);
  const Point2 to = point_at(ring.ring, ring.measure, b);
  double sagitta = 0;
  for (const double t : {0.25, 0.5, 0.75}) {
    const Point2 p = point_at(ring.ring, ring.measure, a + t * (b - a));
    sagitta = std::max(sagitta, distance_to_segment(p, from, to));
  }
  if (sagitta <= tolerance) return;
  const double middle = 0.5 * (a + b);
  bisect(ring, a, middle, tolerance, halvings - 1, samples);
  samples.push_back(middle);
  bisect(ring, middle, b, tolerance, halvings - 1, samples);
}

/// Samples one ring. Returns the arc length of each sample.
std::vector<double> sample_ring(const MarkedOutlines& marked, int r, double spacing,
                                InputCurve& curve) {
  const MarkedRing& ring = marked.rings[r];
  const double length = ring.measure.length;
  std::vector<double> samples;
  if (ring.ring.size() < 3 || !(length > 0)) return samples;
  const std::vector<double> stops = stops_of(marked, r, spacing);
  for (size_t i = 0; i < stops.size(); ++i) {
    const double from = stops[i];
    const double to = i + 1 < stops.size() ? stops[i + 1] : stops[0] + length;
    const double wanted = spacing_between(marked, r, spacing, from, to);
    const int pieces = std::max(1, static_cast<int>(std::lround((to - from) / wanted)));
    for (int k = 0; k < pieces; ++k) {
      const double a = from + (to - from) * k / pieces;
      const double b = from + (to - from) * (k + 1) / pieces;
      samples.push_back(a);
      curve.kept.push_back(k == 0);
      bisect(ring, a, b, max_sagitta * spacing, max_halvings, samples);
      curve.kept.resize(samples.size(), false);
    }
  }
  for (double& s : samples) {
    curve.points.push_back(point_at(ring.ring, ring.measure, s));
    s = std::fmod(s, length);
  }
  return samples;
}

void add_spacings(const InputCurve& curve, std::vector<CurveSample>& samples) {
  const size_t n = curve.points.size();
  for (size_t i = 0; i < n; ++i) {
    const double before = distance(curve.points[i], curve.points[(i + n - 1) % n]);
    const double after = distance(curve.points[i], curve.points[(i + 1) % n]);
    samples.push_back({curve.points[i], std::max(before, after)});
  }
}

/// Returns the index of the sample nearest to arc length s.
int nearest_sample(const std::vector<double>& samples, double s, double length) {
  const auto nearest = std::min_element(samples.begin(), samples.end(), [&](double a, double b) {
    return arc_distance(a, s, length) < arc_distance(b, s, length);
  });
  return static_cast<int>(nearest - samples.begin());
}

}  // namespace

Result<SampledOutlines> sample_outlines(const Scene& scene, double spacing) {
  auto marked = mark_outlines(scene, spacing);
  if (!marked) return marked.error();
  SampledOutlines out{std::move(*marked), {}, {}, {}, {}};
  std::vector<std::vector<double>> samples;  // per ring: arc length of each sample
  for (size_t r = 0; r < out.marked.rings.size(); ++r) {
    InputCurve curve;
    samples.push_back(sample_ring(out.marked, static_cast<int>(r), spacing, curve));
    add_spacings(curve, out.samples);
    out.curves.push_back(std::move(curve));
  }
  if (out.samples.empty())
    return Error{ErrorCode::bad_input,
                 "nothing is left of any part at this resolution; use more vertices", "parts"};
  for (std::vector<CurveRun>* runs :
       {&out.marked.joins, &out.marked.robin, &out.marked.relation_ranges})
    for (CurveRun& run : *runs) {
      if (run.curve < 0) continue;
      const double length = out.marked.rings[run.curve].measure.length;
      run.first = nearest_sample(samples[run.curve], run.from, length);
      run.last = nearest_sample(samples[run.curve], run.to, length);
    }
  sample_creases(scene, spacing, out);
  return out;
}

}  // namespace relievo::relief
