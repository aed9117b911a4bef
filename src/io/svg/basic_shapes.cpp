#include "io/svg/basic_shapes.h"

#include <algorithm>
#include <optional>

#include "io/svg/path_data.h"
#include "io/svg/stylesheet.h"
#include "io/svg/svg_values.h"

namespace relievo {
namespace {

/// Reads lengths from the attributes of a shape.
struct Lengths {
  const pugi::xml_node& element;
  const LengthContext& context;

  std::optional<double> given(const char* name, LengthAxis axis) const {
    const pugi::xml_attribute attribute = element.attribute(name);
    if (!attribute) return std::nullopt;
    return parse_length(attribute.value(), axis, context);
  }
  double x(const char* name) const { return given(name, LengthAxis::horizontal).value_or(0); }
  double y(const char* name) const { return given(name, LengthAxis::vertical).value_or(0); }
  double r(const char* name) const { return given(name, LengthAxis::diagonal).value_or(0); }
};

PathSegment move_to(double x, double y) { return {SegmentKind::move, {}, {}, {x, y}}; }
PathSegment line_to(double x, double y) { return {SegmentKind::line, {}, {}, {x, y}}; }
PathSegment close_path() { return {SegmentKind::close, {}, {}, {}}; }

PathData ellipse_path(Point2 centre, double rx, double ry) {
  if (!(rx > 0) || !(ry > 0)) return {};
  const Point2 right{centre.x + rx, centre.y};
  const Point2 left{centre.x - rx, centre.y};
  PathData path = {move_to(right.x, right.y)};
  append_arc(path, right, {rx, ry, 0, false, true}, left);
  append_arc(path, left, {rx, ry, 0, false, true}, right);
  path.push_back(close_path());
  return path;
}

PathData circle(const Lengths& l) {
  return ellipse_path({l.x("cx"), l.y("cy")}, l.r("r"), l.r("r"));
}

/// Returns rx and ry; a missing or negative one equals the other.
Point2 radii(const Lengths& l) {
  auto rx = l.given("rx", LengthAxis::horizontal);
  auto ry = l.given("ry", LengthAxis::vertical);
  if (rx && !(*rx >= 0)) rx.reset();
  if (ry && !(*ry >= 0)) ry.reset();
  if (!rx) rx = ry;
  if (!ry) ry = rx;
  return {rx.value_or(0), ry.value_or(0)};
}

PathData ellipse(const Lengths& l) {
  const Point2 r = radii(l);
  return ellipse_path({l.x("cx"), l.y("cy")}, r.x, r.y);
}

PathData rounded_rect(Point2 a, Point2 b, double rx, double ry) {
  const ArcShape corner{rx, ry, 0, false, true};
  PathData path = {move_to(a.x + rx, a.y)};
  const auto side = [&](Point2 to, Point2 after_corner) {
    path.push_back(line_to(to.x, to.y));
    append_arc(path, to, corner, after_corner);
  };
  side({b.x - rx, a.y}, {b.x, a.y + ry});
  side({b.x, b.y - ry}, {b.x - rx, b.y});
  side({a.x + rx, b.y}, {a.x, b.y - ry});
  side({a.x, a.y + ry}, {a.x + rx, a.y});
  path.push_back(close_path());
  return path;
}

PathData rect(const Lengths& l) {
  const Point2 a{l.x("x"), l.y("y")};
  const Point2 size{l.x("width"), l.y("height")};
  if (!(size.x > 0) || !(size.y > 0)) return {};
  const Point2 b = a + size;
  const Point2 r = radii(l);
  const Point2 corner{std::min(r.x, size.x / 2), std::min(r.y, size.y / 2)};
  if (corner.x > 0 && corner.y > 0) return rounded_rect(a, b, corner.x, corner.y);
  return {move_to(a.x, a.y), line_to(b.x, a.y), line_to(b.x, b.y), line_to(a.x, b.y), close_path()};
}

PathData line(const Lengths& l) {
  return {move_to(l.x("x1"), l.y("y1")), line_to(l.x("x2"), l.y("y2"))};
}

PathData poly(const pugi::xml_node& e, bool closed, bool& complete) {
  SvgScanner scanner(e.attribute("points").value());
  PathData path;
  for (scanner.skip_space(); !scanner.at_end(); scanner.skip_separator()) {
    const auto x = scanner.number();
    scanner.skip_separator();
    const auto y = x ? scanner.number() : std::nullopt;
    if (!y) {
      complete = false;
      break;
    }
    path.push_back(path.empty() ? move_to(*x, *y) : line_to(*x, *y));
  }
  if (path.size() < 2) return {};
  if (closed) path.push_back(close_path());
  return path;
}

}  // namespace

bool is_shape_element(std::string_view name) {
  return name == "path" || name == "rect" || name == "circle" || name == "ellipse" ||
         name == "line" || name == "polyline" || name == "polygon";
}

PathData shape_path(const pugi::xml_node& element, const LengthContext& context, bool& complete) {
  const std::string_view name = local_name(element.name());
  const Lengths lengths{element, context};
  complete = true;
  if (name == "path") return parse_path_data(element.attribute("d").value(), &complete);
  if (name == "rect") return rect(lengths);
  if (name == "circle") return circle(lengths);
  if (name == "ellipse") return ellipse(lengths);
  if (name == "line") return line(lengths);
  if (name == "polyline") return poly(element, false, complete);
  if (name == "polygon") return poly(element, true, complete);
  return {};
}

}  // namespace relievo
