#include "io/svg/path_data.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

#include "io/svg/svg_values.h"

namespace relievo {
namespace {

using std::numbers::pi;

/// An arc of an ellipse, as an arc of the unit circle and a map from it.
struct EllipseArc {
  Affine2 from_unit;
  double begin = 0;  ///< radians on the unit circle
  double span = 0;   ///< signed
};

/// Converts endpoints to the centre parametrisation [SVG 1.1, F.6.5 and F.6.6].
EllipseArc centre_form(Point2 from, const ArcShape& shape, Point2 to) {
  const double phi = shape.rotation * pi / 180;
  const double c = std::cos(phi);
  const double s = std::sin(phi);
  double rx = std::abs(shape.rx);
  double ry = std::abs(shape.ry);
  const Point2 half = 0.5 * (from - to);
  Point2 q{(c * half.x + s * half.y) / rx, (-s * half.x + c * half.y) / ry};
  const double grow = std::max(1.0, norm(q));
  rx *= grow;
  ry *= grow;
  q = (1 / grow) * q;

  // On the unit circle the chord runs from q to -q around the centre m, perpendicular to it.
  const double length2 = dot(q, q);
  const double reach = std::sqrt(std::max(0.0, 1 / length2 - 1));
  const double side = shape.large == shape.sweep ? -reach : reach;
  const Point2 m{side * q.y, -side * q.x};
  const Point2 begin = q - m;
  const Point2 end = Point2{-q.x, -q.y} - m;

  EllipseArc arc;
  arc.begin = std::atan2(begin.y, begin.x);
  arc.span = std::atan2(cross(begin, end), dot(begin, end));
  if (shape.sweep && arc.span < 0) arc.span += 2 * pi;
  if (!shape.sweep && arc.span > 0) arc.span -= 2 * pi;
  const Affine2 axes{c * rx, s * rx, -s * ry, c * ry, 0, 0};
  const Point2 middle = 0.5 * (from + to) + axes(m);
  arc.from_unit = translation(middle.x, middle.y) * axes;
  return arc;
}

/// Reads the commands one after the other and keeps the state that the next one depends on.
class PathReader {
 public:
  explicit PathReader(std::string_view text) : scanner_(text) {}

  PathData read(bool* complete) {
    bool whole = true;
    for (scanner_.skip_space(); whole && !scanner_.at_end(); scanner_.skip_space())
      whole = next_command() && step();
    if (complete) *complete = whole;
    return std::move(path_);
  }

 private:
  /// Takes the command letter, or repeats the last command where a number follows.
  bool next_command() {
    const char c = scanner_.peek();
    if (std::isalpha(static_cast<unsigned char>(c))) {
      scanner_.take(c);
      command_ = c;
      fresh_ = true;
    } else {
      if (command_ == '\0' || command_ == 'z' || command_ == 'Z') return false;
      if (command_ == 'm') command_ = 'l';
      if (command_ == 'M') command_ = 'L';
      fresh_ = false;
    }
    return !path_.empty() || command_ == 'm' || command_ == 'M';
  }

  bool step() {
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command_)));
    switch (kind) {
      case 'M':
        return move();
      case 'L':
        return line();
      case 'H':
      case 'V':
        return axis_line(kind == 'H');
      case 'C':
        return cubic();
      case 'S':
        return smooth_cubic();
      case 'Q':
        return quadratic();
      case 'T':
        return smooth_quadratic();
      case 'A':
        return arc();
      case 'Z':
        return close();
      default:
        return false;
    }
  }

  bool relative() const { return std::islower(static_cast<unsigned char>(command_)); }

  std::optional<double> coordinate() {
    if (fresh_) {
      scanner_.skip_space();
    } else {
      scanner_.skip_separator();
    }
    fresh_ = false;
    return scanner_.number();
  }

  std::optional<Point2> point() {
    const auto x = coordinate();
    if (!x) return std::nullopt;
    const auto y = coordinate();
    if (!y) return std::nullopt;
    return relative() ? Point2{current_.x + *x, current_.y + *y} : Point2{*x, *y};
  }

  void go(const PathSegment& segment) {
    if (closed_ && segment.kind != SegmentKind::move) {
      path_.push_back({SegmentKind::move, {}, {}, start_});
    }
    closed_ = false;
    path_.push_back(segment);
    current_ = segment.end;
    last_cubic_control_ = last_quadratic_control_ = current_;
  }

  bool move() {
    const auto p = point();
    if (!p) return false;
    go({SegmentKind::move, {}, {}, *p});
    start_ = current_;
    return true;
  }

  bool line() {
    const auto p = point();
    if (!p) return false;
    go({SegmentKind::line, {}, {}, *p});
    return true;
  }

  bool axis_line(bool horizontal) {
    const auto value = coordinate();
    if (!value) return false;
    Point2 p = current_;
    double& moved = horizontal ? p.x : p.y;
    moved = relative() ? moved + *value : *value;
    go({SegmentKind::line, {}, {}, p});
    return true;
  }

  bool add_cubic(Point2 c1, Point2 c2, Point2 end) {
    go({SegmentKind::cubic, c1, c2, end});
    last_cubic_control_ = c2;
    return true;
  }

  bool cubic() {
    const auto c1 = point();
    const auto c2 = c1 ? point() : std::nullopt;
    const auto end = c2 ? point() : std::nullopt;
    return end && add_cubic(*c1, *c2, *end);
  }

  bool smooth_cubic() {
    const Point2 c1 = 2 * current_ - last_cubic_control_;
    const auto c2 = point();
    const auto end = c2 ? point() : std::nullopt;
    return end && add_cubic(c1, *c2, *end);
  }

  bool add_quadratic(Point2 control, Point2 end) {
    const Point2 c1 = (1.0 / 3) * (current_ + 2 * control);
    const Point2 c2 = (1.0 / 3) * (end + 2 * control);
    go({SegmentKind::cubic, c1, c2, end});
    last_quadratic_control_ = control;
    return true;
  }

  bool quadratic() {
    const auto control = point();
    const auto end = control ? point() : std::nullopt;
    return end && add_quadratic(*control, *end);
  }

  bool smooth_quadratic() {
    const Point2 control = 2 * current_ - last_quadratic_control_;
    const auto end = point();
    return end && add_quadratic(control, *end);
  }

  std::optional<bool> flag() {
    scanner_.skip_separator();
    return scanner_.flag();
  }

  bool arc() {
    const auto rx = coordinate();
    const auto ry = rx ? coordinate() : std::nullopt;
    const auto rotation = ry ? coordinate() : std::nullopt;
    const auto large = rotation ? flag() : std::nullopt;
    const auto sweep = large ? flag() : std::nullopt;
    const auto end = sweep ? point() : std::nullopt;
    if (!end) return false;
    PathData pieces;
    append_arc(pieces, current_, {*rx, *ry, *rotation, *large, *sweep}, *end);
    for (const PathSegment& piece : pieces) go(piece);
    return true;
  }

  bool close() {
    if (!closed_) path_.push_back({SegmentKind::close, {}, {}, start_});
    closed_ = true;
    current_ = last_cubic_control_ = last_quadratic_control_ = start_;
    return true;
  }

  SvgScanner scanner_;
  PathData path_;
  char command_ = '\0';
  bool fresh_ = true;
  bool closed_ = false;
  Point2 current_;
  Point2 start_;
  Point2 last_cubic_control_;
  Point2 last_quadratic_control_;
};

int cubic_pieces(Point2 p0, Point2 p1, Point2 p2, Point2 p3, double tolerance) {
  const double bend = std::max(norm(p0 - 2 * p1 + p2), norm(p1 - 2 * p2 + p3));
  const double pieces = std::sqrt(0.75 * bend / tolerance);
  return pieces < 200 ? std::max(1, static_cast<int>(std::ceil(pieces))) : 200;
}

void flatten_cubic(std::vector<Point2>& points, const PathSegment& s, const Affine2& transform,
                   double tolerance) {
  const Point2 p0 = points.back();
  const Point2 p1 = transform(s.control1);
  const Point2 p2 = transform(s.control2);
  const Point2 p3 = transform(s.end);
  const int n = cubic_pieces(p0, p1, p2, p3, tolerance);
  for (int i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    const double r = 1 - t;
    points.push_back((r * r * r) * p0 + (3 * r * r * t) * p1 + (3 * r * t * t) * p2 +
                     (t * t * t) * p3);
  }
  points.push_back(p3);
}

}  // namespace

void append_arc(PathData& path, Point2 from, const ArcShape& shape, Point2 to) {
  if (from == to) return;
  const EllipseArc arc = centre_form(from, shape, to);
  if (shape.rx == 0 || shape.ry == 0 || !std::isfinite(arc.span)) {
    path.push_back({SegmentKind::line, {}, {}, to});
    return;
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(arc.span) / (pi / 4))));
  const double step = arc.span / pieces;
  const double handle = 4.0 / 3 * std::tan(step / 4);
  for (int i = 0; i < pieces; ++i) {
    const double a = arc.begin + i * step;
    const double b = a + step;
    const Point2 c1{std::cos(a) - handle * std::sin(a), std::sin(a) + handle * std::cos(a)};
    const Point2 c2{std::cos(b) + handle * std::sin(b), std::sin(b) - handle * std::cos(b)};
    const Point2 end = i + 1 == pieces ? to : arc.from_unit({std::cos(b), std::sin(b)});
    path.push_back({SegmentKind::cubic, arc.from_unit(c1), arc.from_unit(c2), end});
  }
}

PathData parse_path_data(std::string_view text, bool* complete) {
  return PathReader(text).read(complete);
}

std::vector<Polyline> flatten(const PathData& path, const Affine2& transform, double tolerance,
                              size_t max_points) {
  std::vector<Polyline> lines;
  size_t finished = 0;
  for (const PathSegment& s : path) {
    if (!lines.empty() && finished + lines.back().points.size() > max_points) break;
    if (s.kind == SegmentKind::move) {
      if (!lines.empty()) finished += lines.back().points.size();
      lines.push_back({{transform(s.end)}, false});
    } else if (s.kind == SegmentKind::close) {
      lines.back().closed = true;
    } else if (s.kind == SegmentKind::line) {
      lines.back().points.push_back(transform(s.end));
    } else {
      flatten_cubic(lines.back().points, s, transform, tolerance);
    }
  }
  return lines;
}

}  // namespace relievo
