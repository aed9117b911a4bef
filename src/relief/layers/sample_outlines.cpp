#include "relief/layers/sample_outlines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/geometry/polygon.h"
#include "kernel/geometry/polyline.h"
#include "relief/layers/crease_lines.h"

namespace relievo::relief {
namespace {

constexpr double corner_angle = 0.61;  // 35 degrees
constexpr double max_sagitta = 0.08;   // of the spacing
constexpr int min_ring_samples = 12;
constexpr int min_join_edges = 6;
constexpr int fine_join_edges = 64;       // below which edges become as short as `finest_at_join`
constexpr double coarse_at_join = 0.5;    // of the spacing
constexpr double finest_at_join = 0.25;   // of the spacing
constexpr double line_reach = 0.08;       // of the canvas diagonal
constexpr double speck = 0.02;            // of the detail: smaller rings are lost
constexpr double coarsest_detail = 0.01;  // of the drawing, however few vertices there are
constexpr double same_mark = 0.02;        // of the spacing: nearer marks are one

struct PartRing {
  int part;
  const Ring* ring;
  RingMeasure measure;
  std::vector<double> marks;  // arc lengths that must be samples
};

/// A range of arc length, from `from` forward to `to` (modulo the ring).
struct ArcRange {
  int ring;  // index into rings
  double from;
  double to;
  bool reversed;
};

double forward(double from, double to, double length) {
  const double d = std::fmod(to - from, length);
  return d < 0 ? d + length : d;
}

Ring without_repeats(const Ring& ring) {
  Ring clean;
  for (const Point2 p : ring)
    if (clean.empty() || !(clean.back() == p)) clean.push_back(p);
  while (clean.size() > 1 && clean.front() == clean.back()) clean.pop_back();
  return clean;
}

// Arc lengths at which the ring turns by more than corner_angle over a window, the sharpest of
// each neighbourhood.
std::vector<double> corners(const Ring& ring, const RingMeasure& m, double window) {
  struct Corner {
    double s;
    double angle;
  };
  std::vector<Corner> found;
  for (size_t i = 0; i < ring.size(); ++i) {
    const double s = m.start[i];
    const Point2 in = ring[i] - point_at(ring, m, s - window);
    const Point2 out = point_at(ring, m, s + window) - ring[i];
    const double angle = std::abs(std::atan2(cross(in, out), dot(in, out)));
    if (angle > corner_angle) found.push_back({s, angle});
  }
  std::vector<double> kept;
  for (size_t i = 0; i < found.size(); ++i) {
    bool sharpest = true;
    for (size_t step = 1; step < found.size() && sharpest; ++step) {
      const Corner& other = found[(i + step) % found.size()];
      if (forward(found[i].s, other.s, m.length) > window) break;
      sharpest = other.angle < found[i].angle;
    }
    for (size_t step = 1; step < found.size() && sharpest; ++step) {
      const Corner& other = found[(i + found.size() - step) % found.size()];
      if (forward(other.s, found[i].s, m.length) > window) break;
      sharpest = other.angle <= found[i].angle;
    }
    if (sharpest) kept.push_back(found[i].s);
  }
  return kept;
}

/// The arc from a forward to b, in chords.
constexpr int chords = 32;
std::vector<Point2> chords_of_arc(const PartRing& ring, double a, double b) {
  const double length = forward(a, b, ring.measure.length);
  std::vector<Point2> arc;
  for (int i = 0; i <= chords; ++i)
    arc.push_back(point_at(*ring.ring, ring.measure, a + length * i / chords));
  return arc;
}

/// Mean distance between the arc from a forward to b and the line, both ways.
double gap_to_line(const PartRing& ring, double a, double b, const std::vector<Point2>& line) {
  const std::vector<Point2> arc = chords_of_arc(ring, a, b);
  double sum = 0;
  for (const Point2 p : arc) sum += distance_to_polyline(line, p) / chords;
  for (const Point2 p : line)
    sum += distance_to_polyline(arc, p) / static_cast<double>(line.size());
  return sum;
}

/// How much of the arc lies inside the outline.
double length_inside(const PartRing& ring, const ArcRange& arc, const Outline& outline) {
  double length = 0;
  for (const LineSpan span : spans_inside(chords_of_arc(ring, arc.from, arc.to), outline))
    length += span.to - span.from;
  return length;
}

/// Corners next to a mark give way to it.
void keep_clear(const PartRing& ring, double clear, std::vector<double>& stops) {
  const auto near_mark = [&](double s) {
    return std::any_of(ring.marks.begin(), ring.marks.end(), [&](double mark) {
      const double gap = forward(s, mark, ring.measure.length);
      return std::min(gap, ring.measure.length - gap) < clear;
    });
  };
  stops.erase(std::remove_if(stops.begin(), stops.end(), near_mark), stops.end());
}

void add_spacings(const InputCurve& curve, std::vector<CurveSample>& samples) {
  const size_t n = curve.points.size();
  for (size_t i = 0; i < n; ++i) {
    const double before = distance(curve.points[i], curve.points[(i + n - 1) % n]);
    const double after = distance(curve.points[i], curve.points[(i + 1) % n]);
    samples.push_back({curve.points[i], std::max(before, after)});
  }
}

/// The sample at which the arc length is nearest to s, round a ring.
int nearest_sample(const std::vector<double>& samples, double s, double length) {
  int best = 0;
  double gap = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < samples.size(); ++i) {
    const double ahead = forward(samples[i], s, length);
    const double d = std::min(ahead, length - ahead);
    if (!(d < gap)) continue;
    gap = d;
    best = static_cast<int>(i);
  }
  return best;
}

/// The mark that is already at s within rounding, or s: a range often begins where a join ends.
double settled(const PartRing& ring, double s, double reach) {
  for (const double mark : ring.marks) {
    const double gap = forward(s, mark, ring.measure.length);
    if (std::min(gap, ring.measure.length - gap) < reach) return mark;
  }
  return s;
}

/// The ends of the arc must be samples.
void mark(const ArcRange& arc, std::vector<PartRing>& rings) {
  rings[arc.ring].marks.push_back(arc.from);
  rings[arc.ring].marks.push_back(arc.to);
}

/// The ring of the part that is nearest to the points on the mean, -1 where it has none; `gap` is
/// the sum of the distances.
int nearest_ring(const std::vector<PartRing>& rings, int part, const std::vector<Point2>& points,
                 double& gap) {
  int best = -1;
  gap = std::numeric_limits<double>::infinity();
  for (size_t r = 0; r < rings.size(); ++r) {
    if (rings[r].part != part || rings[r].ring->size() < 3) continue;
    double sum = 0;
    for (const Point2 p : points)
      sum += nearest_on_ring(*rings[r].ring, rings[r].measure, p).distance;
    if (sum >= gap) continue;
    gap = sum;
    best = static_cast<int>(r);
  }
  return best;
}

class Sampler {
 public:
  Sampler(const Scene& scene, double spacing) : scene_(scene), spacing_(spacing) {
    Box2 box;
    for (const Part& part : scene.parts) box.add(bounding_box(part.outline));
    out_.detail = std::min(spacing, coarsest_detail * box.diagonal());
    for (size_t p = 0; p < scene.parts.size(); ++p) {
      int specks = 0;
      for (const Ring& ring : scene.parts[p].outline) {
        clean_.push_back(without_repeats(ring));
        ring_part_.push_back(static_cast<int>(p));
        if (bounding_box(clean_.back()).diagonal() >= speck * out_.detail) continue;
        clean_.back().clear();
        ++specks;
      }
      if (specks > 0)
        out_.warnings.push_back("parts[" + std::to_string(p) + "] (\"" + scene.parts[p].id +
                                "\"): " + std::to_string(specks) +
                                " of its rings are specks that are lost at this resolution");
    }
    for (size_t r = 0; r < clean_.size(); ++r)
      rings_.push_back({ring_part_[r], &clean_[r], measure(clean_[r]), {}});
  }

  Result<SampledOutlines> run() {
    for (size_t j = 0; j < scene_.joins.size(); ++j)
      if (Status status = locate_join(j); !status) return status.error();
    for (const RobinRange& range : scene_.robin)
      robin_.push_back(locate_range(range.upper, range.from, range.to, true));
    for (const Relation& relation : scene_.relations)
      relations_.push_back(relation.range ? locate_range(relation.upper, relation.range->first,
                                                         relation.range->second, false)
                                          : ArcRange{-1, 0, 0, false});
    for (size_t r = 0; r < rings_.size(); ++r) sample_ring(r);
    if (out_.samples.empty())
      return Error{ErrorCode::bad_input,
                   "nothing is left of any part at this resolution; use more vertices", "parts"};
    for (const ArcRange& arc : joins_) out_.joins.push_back(as_run(arc));
    for (const ArcRange& arc : robin_) out_.robin.push_back(as_run(arc));
    for (const ArcRange& arc : relations_) out_.relation_ranges.push_back(as_run(arc));
    return std::move(out_);
  }

 private:
  Status locate_join(size_t j) {
    const Join& join = scene_.joins[j];
    const Culprit culprit{CulpritList::joins, j};
    const std::string where = to_string(culprit) + ".line";
    double gap = 0;
    const int best = nearest_ring(rings_, join.upper, join.line, gap);
    const std::string& upper = scene_.parts[join.upper].id;
    const double diagonal = std::hypot(scene_.width, scene_.height);
    if (best < 0 || gap / static_cast<double>(join.line.size()) > line_reach * diagonal)
      return Error{ErrorCode::bad_input,
                   "the join's line is far from the outline of \"" + upper +
                       "\"; draw it along that outline, where it lies inside the lower part",
                   where, culprit};
    const PartRing& ring = rings_[best];
    const double a = mark_near(ring, join.line.front());
    const double b = mark_near(ring, join.line.back());
    const double ahead = forward(a, b, ring.measure.length);
    if (std::min(ahead, ring.measure.length - ahead) < 1e-6 * ring.measure.length)
      return Error{ErrorCode::bad_input,
                   "both ends of the join meet the outline of \"" + upper + "\" at one point",
                   where, culprit};
    const bool as_drawn = gap_to_line(ring, a, b, join.line) <= gap_to_line(ring, b, a, join.line);
    joins_.push_back(as_drawn ? ArcRange{best, a, b, false} : ArcRange{best, b, a, true});
    mark(joins_.back(), rings_);
    // Flat faces meet at an angle that grows with their size, where one smooth surface is meant.
    const double inside = length_inside(ring, joins_.back(), scene_.parts[join.lower].outline);
    join_spacing_.push_back(
        std::clamp(inside / fine_join_edges, finest_at_join * spacing_, coarse_at_join * spacing_));
    return Done{};
  }

  ArcRange locate_range(int part, Point2 from, Point2 to, bool shorter) {
    double gap = 0;
    const int best = nearest_ring(rings_, part, {from, to}, gap);
    if (best < 0) return {-1, 0, 0, false};
    const PartRing& ring = rings_[best];
    const double a = mark_near(ring, from);
    const double b = mark_near(ring, to);
    const bool flip = shorter && forward(a, b, ring.measure.length) > 0.5 * ring.measure.length;
    const ArcRange arc = flip ? ArcRange{best, b, a, true} : ArcRange{best, a, b, false};
    mark(arc, rings_);
    return arc;
  }

  double mark_near(const PartRing& ring, Point2 p) const {
    return settled(ring, nearest_on_ring(*ring.ring, ring.measure, p).s, same_mark * spacing_);
  }

  /// Short rings keep enough edges.
  double spacing_of_ring(size_t r) const {
    return std::min(spacing_, rings_[r].measure.length / min_ring_samples);
  }

  double spacing_between(size_t r, double from, double to) const {
    const double length = rings_[r].measure.length;
    double spacing = spacing_of_ring(r);
    const double middle = from + 0.5 * (to - from);
    for (size_t j = 0; j < joins_.size(); ++j) {
      const ArcRange& join = joins_[j];
      if (join.ring != static_cast<int>(r)) continue;
      const double arc = forward(join.from, join.to, length);
      if (forward(join.from, middle, length) < arc)
        spacing = std::min({spacing, arc / min_join_edges, join_spacing_[j]});
    }
    return spacing;
  }

  void sample_ring(size_t r) {
    PartRing& ring = rings_[r];
    InputCurve curve;
    ring_samples_.emplace_back();
    if (ring.ring->size() >= 3 && ring.measure.length > 0) {
      std::vector<double> stops = corners(*ring.ring, ring.measure, 0.5 * spacing_of_ring(r));
      keep_clear(ring, 0.3 * spacing_, stops);
      stops.insert(stops.end(), ring.marks.begin(), ring.marks.end());
      refine_at_ends(r, stops);
      if (stops.empty()) stops.push_back(0);
      std::sort(stops.begin(), stops.end());
      stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
      for (size_t i = 0; i < stops.size(); ++i) {
        const double next = i + 1 < stops.size() ? stops[i + 1] : stops[0] + ring.measure.length;
        sample_stretch(r, stops[i], next, curve);
      }
    }
    add_spacings(curve, out_.samples);
    out_.curves.push_back(std::move(curve));
    out_.curve_part.push_back(ring.part);
  }

  // The surface has a crease that starts at a join's end: short edges there resolve it.
  void refine_at_ends(size_t r, std::vector<double>& stops) const {
    const double length = rings_[r].measure.length;
    const double spacing = spacing_of_ring(r);
    const std::vector<double> plain = stops;
    for (const ArcRange& join : joins_) {
      if (join.ring != static_cast<int>(r)) continue;
      for (const double end : {join.from, join.to})
        for (const double step : {-1.2, -0.5, -0.2, 0.2, 0.5, 1.2}) {
          const double s = forward(0, end + step * spacing, length);
          const bool clear = std::none_of(plain.begin(), plain.end(), [&](double stop) {
            const double gap = forward(s, stop, length);
            return stop != end && std::min(gap, length - gap) < 0.15 * spacing;
          });
          if (clear) stops.push_back(s);
        }
    }
  }

  void sample_stretch(size_t r, double from, double to, InputCurve& curve) {
    const int pieces =
        std::max(1, static_cast<int>(std::lround((to - from) / spacing_between(r, from, to))));
    for (int i = 0; i < pieces; ++i) {
      const double a = from + (to - from) * i / pieces;
      const double b = from + (to - from) * (i + 1) / pieces;
      push(r, a, i == 0, curve);
      bisect(r, a, b, 3, curve);
    }
  }

  // Adds samples between a and b until the chords are close to the curve.
  void bisect(size_t r, double a, double b, int levels, InputCurve& curve) {
    const PartRing& ring = rings_[r];
    if (levels == 0) return;
    const Point2 pa = point_at(*ring.ring, ring.measure, a);
    const Point2 pb = point_at(*ring.ring, ring.measure, b);
    double sagitta = 0;
    for (const double t : {0.25, 0.5, 0.75})
      sagitta = std::max(sagitta, distance_to_segment(
                                      point_at(*ring.ring, ring.measure, a + t * (b - a)), pa, pb));
    if (sagitta <= max_sagitta * spacing_) return;
    const double middle = 0.5 * (a + b);
    bisect(r, a, middle, levels - 1, curve);
    push(r, middle, false, curve);
    bisect(r, middle, b, levels - 1, curve);
  }

  void push(size_t r, double s, bool kept, InputCurve& curve) {
    curve.points.push_back(point_at(*rings_[r].ring, rings_[r].measure, s));
    curve.kept.push_back(kept);
    ring_samples_[r].push_back(std::fmod(s, rings_[r].measure.length));
  }

  CurveRun as_run(const ArcRange& arc) const {
    if (arc.ring < 0) return {};
    const std::vector<double>& samples = ring_samples_[arc.ring];
    const double length = rings_[arc.ring].measure.length;
    return {arc.ring, nearest_sample(samples, arc.from, length),
            nearest_sample(samples, arc.to, length), forward(arc.from, arc.to, length),
            arc.reversed};
  }

  const Scene& scene_;
  double spacing_;
  std::vector<Ring> clean_;
  std::vector<int> ring_part_;
  std::vector<PartRing> rings_;
  std::vector<std::vector<double>> ring_samples_;  // per ring: arc length of each sample
  std::vector<ArcRange> joins_;
  std::vector<double> join_spacing_;  // per join
  std::vector<ArcRange> robin_;
  std::vector<ArcRange> relations_;
  SampledOutlines out_;
};

}  // namespace

Result<SampledOutlines> sample_outlines(const Scene& scene, double spacing) {
  auto sampled = Sampler(scene, spacing).run();
  if (sampled) sample_creases(scene, spacing, *sampled);
  return sampled;
}

}  // namespace relievo::relief
