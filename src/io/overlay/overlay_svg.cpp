#include "io/overlay/overlay_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/files/number_text.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

/// Width of lines / diagonal of the canvas.
constexpr double line_share = 0.002;
constexpr int ramp_pieces = 12;
constexpr int range_pieces = 200;

constexpr const char* join_colour = "#0030ff";
constexpr const char* equal_colour = "#00d0e0";
constexpr const char* above_colour = "#e000c0";
constexpr const char* below_colour = "#700060";

std::string number(double value) { return shortest_text(std::round(value * 100) / 100); }

std::string channel(double value) { return std::to_string(static_cast<int>(std::lround(value))); }

/// Mixes two colours, given as red, green and blue.
std::string mix(std::array<double, 3> a, std::array<double, 3> b, double t) {
  std::string text = "rgb(";
  for (int i = 0; i < 3; ++i) text += (i > 0 ? "," : "") + channel(a[i] + t * (b[i] - a[i]));
  return text + ")";
}

/// Returns a colour from green (alpha 0) to red (alpha 1).
std::string ramp_colour(double alpha) { return mix({0, 190, 0}, {230, 0, 0}, alpha); }

/// Returns path data of a segment, given as x0 y0 x1 y1 in px.
std::string segment_data(const float* ends) {
  return "M" + number(ends[0]) + " " + number(ends[1]) + "L" + number(ends[2]) + " " +
         number(ends[3]);
}

std::string path_data(const std::vector<Point2>& points, bool closed) {
  std::string text;
  for (size_t i = 0; i < points.size(); ++i)
    text += (i == 0 ? "M" : "L") + number(points[i].x) + " " + number(points[i].y);
  return text + (closed ? "Z" : "");
}

std::string outline_data(const Outline& outline) {
  std::string text;
  for (const Ring& ring : outline) text += path_data(ring, true);
  return text;
}

const char* colour_of(RelationKind kind) {
  if (kind == RelationKind::equal) return equal_colour;
  if (kind == RelationKind::joined) return join_colour;
  return kind == RelationKind::below ? below_colour : above_colour;
}

/// A run along a ring.
struct Way {
  const Ring* ring = nullptr;
  RingMeasure measure;
  double from = 0;    ///< arc length
  double length = 0;  ///< negative: against the ring's direction
};

/// Returns the way along the ring nearest to `from`: the shorter one, or the one in the ring's
/// direction. Precondition: the outline has a ring.
Way way_along(const Outline& outline, Point2 from, Point2 to, bool shorter) {
  Way way;
  double best = std::numeric_limits<double>::infinity();
  for (const Ring& candidate : outline) {
    const RingMeasure m = measure(candidate);
    const double d = nearest_on_ring(candidate, m, from).distance;
    if (d >= best) continue;
    best = d;
    way.ring = &candidate;
    way.measure = m;
  }
  const double around = way.measure.length;
  way.from = nearest_on_ring(*way.ring, way.measure, from).s;
  way.length = nearest_on_ring(*way.ring, way.measure, to).s - way.from;
  if (way.length < 0) way.length += around;
  if (shorter && way.length > around / 2) way.length -= around;
  return way;
}

/// Returns the point after `i` of `pieces` equal pieces.
Point2 point_on(const Way& way, int i, int pieces) {
  const double s = way.from + way.length * i / pieces;
  return point_at(*way.ring, way.measure, s + way.measure.length);
}

class Painter {
 public:
  explicit Painter(const Scene& scene)
      : scene_(scene), width_(std::max(1.0, line_share * std::hypot(scene.width, scene.height))) {}

  std::string paint(const OverlayMarks& marks) {
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(scene_.width) +
            "\" height=\"" + number(scene_.height) + "\">\n";
    tints();
    outlines();
    if (marks.lines)
      paint_lines(*marks.lines);
    else
      paint_annotations();
    for (const auto& bridge : marks.bridges) stroke(path_data(bridge, false), "#ff8000", 1.5, "");
    return text_ + "</svg>\n";
  }

 private:
  void tints() {
    text_ += "<g opacity=\"0.45\">\n";
    const double last = std::max<double>(1, static_cast<double>(scene_.parts.size()) - 1);
    for (size_t k = 0; k < scene_.parts.size(); ++k)
      text_ += "<path fill=\"" + mix({40, 60, 160}, {255, 225, 70}, static_cast<double>(k) / last) +
               "\" d=\"" + outline_data(scene_.parts[k].outline) + "\"/>\n";
    text_ += "</g>\n";
  }

  void outlines() {
    for (const Part& part : scene_.parts) {
      stroke(outline_data(part.outline), "#ffffff", 1, "");
      stroke(outline_data(part.outline), "#000000", 1, "4 3");
    }
  }

  void paint_annotations() {
    for (const Relation& relation : scene_.relations) paint_relation(relation);
    for (const Join& join : scene_.joins) stroke(path_data(join.line, false), join_colour, 2.2, "");
    for (const RobinRange& range : scene_.robin) paint_ramp(range);
  }

  void paint_lines(const MeshLines& lines) {
    paint_segments(lines.above, above_colour, 1.4);
    paint_segments(lines.below, below_colour, 1.4);
    paint_segments(lines.equal, equal_colour, 1.4);
    paint_segments(lines.joins, join_colour, 2.2);
    for (size_t i = 0; i + 5 < lines.ramps.size(); i += 6) {
      const double alpha = 0.5 * (lines.ramps[i + 4] + lines.ramps[i + 5]);
      stroke(segment_data(&lines.ramps[i]), ramp_colour(alpha), 2.2, "");
    }
  }

  void paint_segments(const std::vector<float>& ends, const char* colour, double width) {
    std::string data;
    for (size_t i = 0; i + 3 < ends.size(); i += 4) data += segment_data(&ends[i]);
    if (!data.empty()) stroke(data, colour, width, "");
  }

  /// Paints the runs of the upper outline, or of the range in it, that lie inside the lower part.
  void paint_relation(const Relation& relation) {
    if (relation.kind == RelationKind::free) return;
    const Outline& upper = scene_.parts[relation.upper].outline;
    if (relation.range) {
      const Way way = way_along(upper, relation.range->first, relation.range->second, false);
      std::vector<Point2> line;
      for (int i = 0; i <= range_pieces; ++i) line.push_back(point_on(way, i, range_pieces));
      return paint_inside(line, relation);
    }
    for (std::vector<Point2> line : upper) {
      line.push_back(line.front());
      paint_inside(line, relation);
    }
  }

  void paint_inside(const std::vector<Point2>& line, const Relation& relation) {
    const Outline& lower = scene_.parts[relation.lower].outline;
    std::vector<Point2> run;
    for (size_t i = 0; i <= line.size(); ++i) {
      const bool inside = i < line.size() && contains(lower, line[i]);
      if (inside) run.push_back(line[i]);
      if (!inside && run.size() > 1)
        stroke(path_data(run, false), colour_of(relation.kind), 1.4, "");
      if (!inside) run.clear();
    }
  }

  void paint_ramp(const RobinRange& range) {
    const Way way = way_along(scene_.parts[range.upper].outline, range.from, range.to, true);
    for (int i = 0; i < ramp_pieces; ++i)
      stroke(path_data({point_on(way, i, ramp_pieces), point_on(way, i + 1, ramp_pieces)}, false),
             ramp_colour(static_cast<double>(i) / ramp_pieces), 2.2, "");
  }

  void stroke(const std::string& data, const std::string& colour, double width,
              const std::string& dashes) {
    text_ += "<path fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
             number(width * width_) + "\"";
    if (!dashes.empty()) text_ += " stroke-dasharray=\"" + dashes + "\"";
    text_ += " d=\"" + data + "\"/>\n";
  }

  const Scene& scene_;
  double width_;
  std::string text_;
};

}  // namespace

std::string overlay_svg(const Scene& scene, const OverlayMarks& marks) {
  return Painter(scene).paint(marks);
}

}  // namespace relievo
