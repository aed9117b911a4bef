#include "io/svg/basic_shapes.h"

#include <algorithm>
#include <optional>

#include "io/svg/scanner.h"
#include "io/svg/stylesheet.h"

namespace relievo {
namespace {

std::optional<double> length(const pugi::xml_node& element, const char* name, LengthAxis axis,
                             const LengthContext& context) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) return std::nullopt;
  return parse_length(attribute.value(), axis, context);
}

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

PathData circle(const pugi::xml_node& e, const LengthContext& c) {
  const double r = length(e, "r", LengthAxis::diagonal, c).value_or(0);
  return ellipse_path({length(e, "cx", LengthAxis::horizontal, c).value_or(0),
                       length(e, "cy", LengthAxis::vertical, c).value_or(0)},
                      r, r);
}

struct Radii {
  double rx = 0;
  double ry = 0;
};

/// rx and ry; one that is missing or negative is as the other.
Radii radii(const pugi::xml_node& e, const LengthContext& c) {
  auto rx = length(e, "rx", LengthAxis::horizontal, c);
  auto ry = length(e, "ry", LengthAxis::vertical, c);
  if (rx && !(*rx >= 0)) rx.reset();
  if (ry && !(*ry >= 0)) ry.reset();
  if (!rx) rx = ry;
  if (!ry) ry = rx;
  return {rx.value_or(0), ry.value_or(0)};
}

PathData ellipse(const pugi::xml_node& e, const LengthContext& c) {
  const Radii r = radii(e, c);
  return ellipse_path({length(e, "cx", LengthAxis::horizontal, c).value_or(0),
                       length(e, "cy", LengthAxis::vertical, c).value_or(0)},
                      r.rx, r.ry);
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

PathData rect(const pugi::xml_node& e, const LengthContext& c) {
  const double x = length(e, "x", LengthAxis::horizontal, c).value_or(0);
  const double y = length(e, "y", LengthAxis::vertical, c).value_or(0);
  const double width = length(e, "width", LengthAxis::horizontal, c).value_or(0);
  const double height = length(e, "height", LengthAxis::vertical, c).value_or(0);
  if (!(width > 0) || !(height > 0)) return {};
  const Radii r = radii(e, c);
  const double corner_x = std::min(r.rx, width / 2);
  const double corner_y = std::min(r.ry, height / 2);
  if (corner_x > 0 && corner_y > 0) {
    return rounded_rect({x, y}, {x + width, y + height}, corner_x, corner_y);
  }
  return {move_to(x, y), line_to(x + width, y), line_to(x + width, y + height),
          line_to(x, y + height), close_path()};
}

PathData line(const pugi::xml_node& e, const LengthContext& c) {
  return {move_to(length(e, "x1", LengthAxis::horizontal, c).value_or(0),
                  length(e, "y1", LengthAxis::vertical, c).value_or(0)),
          line_to(length(e, "x2", LengthAxis::horizontal, c).value_or(0),
                  length(e, "y2", LengthAxis::vertical, c).value_or(0))};
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

PathData shape_path(const pugi::xml_node& element, const LengthContext& context, bool* complete) {
  const std::string_view name = local_name(element.name());
  bool whole = true;
  PathData path;
  if (name == "path") path = parse_path_data(element.attribute("d").value(), &whole);
  if (name == "rect") path = rect(element, context);
  if (name == "circle") path = circle(element, context);
  if (name == "ellipse") path = ellipse(element, context);
  if (name == "line") path = line(element, context);
  if (name == "polyline") path = poly(element, false, whole);
  if (name == "polygon") path = poly(element, true, whole);
  if (complete) *complete = whole;
  return path;
}

}  // namespace relievo
