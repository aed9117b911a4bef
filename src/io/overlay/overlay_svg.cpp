#include "io/overlay/overlay_svg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/number_text.h"
#include "kernel/geometry/ring_measure.h"

namespace relievo {
namespace {

/// Width of lines relative to the canvas' diagonal.
constexpr double line_share = 0.002;
constexpr int ramp_pieces = 12;

std::string number(double value) { return shortest_text(std::round(value * 100) / 100); }

std::string channel(double value) { return std::to_string(static_cast<int>(std::lround(value))); }

/// Between two colours given as red, green, blue.
std::string mix(std::array<double, 3> a, std::array<double, 3> b, double t) {
  std::string text = "rgb(";
  for (int i = 0; i < 3; ++i) text += (i > 0 ? "," : "") + channel(a[i] + t * (b[i] - a[i]));
  return text + ")";
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

class Painter {
 public:
  explicit Painter(const Scene& scene)
      : scene_(scene), width_(std::max(1.0, line_share * std::hypot(scene.width, scene.height))) {}

  std::string paint(const OverlayMarks& marks) {
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(scene_.width) +
            "\" height=\"" + number(scene_.height) + "\">\n";
    tints();
    outlines();
    for (const Relation& relation : scene_.relations) paint_relation(relation);
    for (const Join& join : scene_.joins) stroke(path_data(join.line, false), "#0030ff", 2.2, "");
    for (const RobinRange& range : scene_.robin) paint_ramp(range);
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

  /// The runs of the upper outline that lie inside the lower part.
  void paint_relation(const Relation& relation) {
    if (relation.kind == RelationKind::free) return;
    const char* colour = relation.kind == RelationKind::equal ? "#00d0e0" : "#e000c0";
    const Outline& lower = scene_.parts[relation.lower].outline;
    for (const Ring& ring : scene_.parts[relation.upper].outline) {
      std::vector<Point2> run;
      for (size_t i = 0; i <= ring.size(); ++i) {
        const Point2 p = ring[i % ring.size()];
        if (contains(lower, p)) run.push_back(p);
        if (run.size() > 1 && (i == ring.size() || !contains(lower, p)))
          stroke(path_data(run, false), colour, 1.4, "");
        if (!contains(lower, p)) run.clear();
      }
    }
  }

  /// The shorter way along the nearest ring of the upper part.
  void paint_ramp(const RobinRange& range) {
    const Ring* ring = nullptr;
    RingMeasure measure_of_ring;
    double best = 1e300;
    for (const Ring& candidate : scene_.parts[range.upper].outline) {
      const RingMeasure m = measure(candidate);
      const double d = nearest_on_ring(candidate, m, range.from).distance;
      if (d >= best) continue;
      best = d;
      ring = &candidate;
      measure_of_ring = m;
    }
    if (ring == nullptr) return;
    const RingMeasure& m = measure_of_ring;
    const double from = nearest_on_ring(*ring, m, range.from).s;
    double way = nearest_on_ring(*ring, m, range.to).s - from;
    if (way > m.length / 2) way -= m.length;
    if (way < -m.length / 2) way += m.length;
    for (int i = 0; i < ramp_pieces; ++i) {
      const auto at = [&](double t) { return point_at(*ring, m, from + t * way + m.length); };
      const double t = static_cast<double>(i) / ramp_pieces;
      stroke(path_data({at(t), at(t + 1.0 / ramp_pieces)}, false), mix({0, 190, 0}, {230, 0, 0}, t),
             2.2, "");
    }
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
