#include "io/svg/svg_style.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/svg/svg_values.h"

namespace relievo {
namespace {

/// Reads a number or a percentage, clamped to [0, 1].
std::optional<double> parse_fraction(std::string_view text) {
  const auto value = parse_length(text, LengthAxis::horizontal, {16, 1, 1});
  if (!value || std::isnan(*value)) return std::nullopt;
  return std::clamp(*value, 0.0, 1.0);
}

/// Reads the colour in "red icc-color(...)" or "currentColor".
std::optional<Color> paint_color(std::string_view text, const Color& current) {
  text = trimmed_svg(text);
  const std::string_view first = text.substr(0, text.find(" icc-color"));
  if (first == "currentColor" || first == "currentcolor") return current;
  return parse_color(first);
}

std::optional<SvgPaint> parse_paint(std::string_view text, const Color& current) {
  text = trimmed_svg(text);
  SvgPaint paint;
  if (text == "none") return paint;
  if (text.substr(0, 4) == "url(") {
    const size_t close = text.find(')');
    if (close == std::string_view::npos) return std::nullopt;
    paint.server = local_reference(text.substr(0, close + 1));
    paint.color = paint_color(text.substr(close + 1), current);
    return paint;
  }
  paint.color = paint_color(text, current);
  if (!paint.color) return std::nullopt;
  return paint;
}

template <class T>
void assign(T& target, const std::optional<T>& value) {
  if (value) target = *value;
}

/// Sets a property of painting in `s`, with the values of `parent` for "inherit"; returns whether
/// it is one.
bool apply_paint(SvgStyle& s, const SvgStyle& parent, const std::string& name,
                 const std::string& value) {
  const bool inherit = value == "inherit";
  if (name == "fill") {
    assign(s.fill, inherit ? parent.fill : parse_paint(value, s.color));
  } else if (name == "stroke") {
    assign(s.stroke, inherit ? parent.stroke : parse_paint(value, s.color));
  } else if (name == "fill-opacity") {
    assign(s.fill_opacity, inherit ? parent.fill_opacity : parse_fraction(value));
  } else if (name == "stroke-opacity") {
    assign(s.stroke_opacity, inherit ? parent.stroke_opacity : parse_fraction(value));
  } else if (name == "opacity") {
    assign(s.opacity, inherit ? parent.opacity : parse_fraction(value));
  } else {
    return false;
  }
  return true;
}

/// Likewise a property of strokes.
bool apply_stroke(SvgStyle& s, const SvgStyle& parent, LengthContext context,
                  const std::string& name, const std::string& value) {
  const bool inherit = value == "inherit";
  context.font_size = s.font_size;
  if (name == "stroke-width") {
    const auto width = inherit ? std::optional<double>(parent.stroke_width)
                               : parse_length(value, LengthAxis::diagonal, context);
    if (width && *width >= 0) s.stroke_width = *width;
  } else if (name == "stroke-linecap") {
    if (inherit) s.cap = parent.cap;
    if (value == "butt") s.cap = LineCap::butt;
    if (value == "round") s.cap = LineCap::round;
    if (value == "square") s.cap = LineCap::square;
  } else if (name == "stroke-linejoin") {
    if (inherit) s.join = parent.join;
    if (value.substr(0, 5) == "miter") s.join = LineJoin::miter;
    if (value == "round") s.join = LineJoin::round;
    if (value == "bevel") s.join = LineJoin::bevel;
  } else if (name == "stroke-miterlimit") {
    const auto limit = SvgScanner(value).number();
    if (limit && *limit >= 1) s.miter_limit = *limit;
  } else {
    return false;
  }
  return true;
}

void apply_rule(FillRule& rule, const FillRule& parent, const std::string& value) {
  if (value == "inherit") rule = parent;
  if (value == "nonzero") rule = FillRule::nonzero;
  if (value == "evenodd") rule = FillRule::even_odd;
}

void apply_rest(SvgStyle& s, const SvgStyle& parent, const std::string& name,
                const std::string& value) {
  const bool inherit = value == "inherit";
  if (name == "fill-rule") {
    apply_rule(s.fill_rule, parent.fill_rule, value);
  } else if (name == "clip-rule") {
    apply_rule(s.clip_rule, parent.clip_rule, value);
  } else if (name == "visibility") {
    if (inherit) s.visible = parent.visible;
    if (value == "visible") s.visible = true;
    if (value == "hidden" || value == "collapse") s.visible = false;
  } else if (name == "display") {
    s.displayed = inherit ? parent.displayed : value != "none";
  } else if (name == "overflow") {
    s.clips_overflow = value != "visible" && value != "auto";
  } else if (name == "clip-path") {
    s.clip_path = inherit ? parent.clip_path : local_reference(value);
  } else if (name == "mask") {
    s.mask = inherit ? parent.mask : local_reference(value);
  } else if (name == "filter") {
    s.filter = inherit ? parent.filter : local_reference(value);
  } else if (name == "transform") {
    s.transform = value;
  }
}

/// Sets `color` or `font-size`, to which other properties refer.
void apply_first(SvgStyle& s, const SvgStyle& parent, LengthContext context,
                 const std::string& name, const std::string& value) {
  if (name == "color") {
    assign(s.color, value == "inherit" ? parent.color : paint_color(value, parent.color));
  } else if (name == "font-size" && value != "inherit") {
    context.font_size = parent.font_size;
    context.viewport_height = parent.font_size;  // a percentage is of the parent's font size
    const auto size = parse_length(value, LengthAxis::vertical, context);
    if (size && *size > 0) s.font_size = *size;
  }
}

/// Returns all declarations for the element, the strongest last.
std::vector<Declaration> declarations_of(const pugi::xml_node& element, const Stylesheet& sheet) {
  std::vector<Declaration> list;
  for (const pugi::xml_attribute& attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name == "style" || name == "d" || name == "points" || name == "transform") continue;
    list.push_back({std::string(name), std::string(trimmed_svg(attribute.value())), false});
  }
  for (const StyleRule& rule : sheet) {
    if (!matches(rule, element)) continue;
    list.insert(list.end(), rule.declarations.begin(), rule.declarations.end());
  }
  const auto own = parse_declarations(element.attribute("style").value());
  list.insert(list.end(), own.begin(), own.end());
  std::stable_partition(list.begin(), list.end(),
                        [](const Declaration& d) { return !d.important; });
  return list;
}

constexpr int max_href_chain = 16;

struct Stop {
  double offset = 0;
  Color color;
};

std::string property(const pugi::xml_node& element, const char* name) {
  std::string value = element.attribute(name).value();
  for (const Declaration& d : parse_declarations(element.attribute("style").value())) {
    if (d.name == name) value = d.value;
  }
  return value;
}

std::vector<Stop> own_stops(const pugi::xml_node& gradient) {
  std::vector<Stop> stops;
  for (const pugi::xml_node& child : gradient.children()) {
    if (local_name(child.name()) != "stop") continue;
    Stop stop{parse_fraction(child.attribute("offset").value()).value_or(0),
              parse_color(property(child, "stop-color")).value_or(Color{})};
    if (!stops.empty()) stop.offset = std::max(stop.offset, stops.back().offset);
    stop.color.a *= parse_fraction(property(child, "stop-opacity")).value_or(1);
    stops.push_back(stop);
  }
  return stops;
}

Color overall_color(const std::vector<Stop>& stops) {
  Color sum{0, 0, 0, 1};
  const auto add = [&sum](const Color& c, double weight) {
    sum = {sum.r + weight * c.r, sum.g + weight * c.g, sum.b + weight * c.b, std::min(sum.a, c.a)};
  };
  add(stops.front().color, stops.front().offset);
  for (size_t i = 0; i + 1 < stops.size(); ++i) {
    const double half = (stops[i + 1].offset - stops[i].offset) / 2;
    add(stops[i].color, half);
    add(stops[i + 1].color, half);
  }
  add(stops.back().color, 1 - stops.back().offset);
  return sum;
}

}  // namespace

SvgStyle computed_style(const pugi::xml_node& element, const Stylesheet& sheet,
                        const SvgStyle& parent, const LengthContext& context) {
  SvgStyle style = parent;
  style.opacity = 1;
  style.displayed = true;
  style.clips_overflow = true;
  style.clip_path.clear();
  style.mask.clear();
  style.filter.clear();
  style.transform.reset();
  const std::vector<Declaration> list = declarations_of(element, sheet);
  for (const Declaration& d : list) apply_first(style, parent, context, d.name, d.value);
  for (const Declaration& d : list) {
    if (!apply_paint(style, parent, d.name, d.value) &&
        !apply_stroke(style, parent, context, d.name, d.value))
      apply_rest(style, parent, d.name, d.value);
  }
  return style;
}

std::string local_reference(std::string_view text) {
  text = trimmed_svg(text);
  if (text.substr(0, 4) == "url(" && text.back() == ')') {
    text = trimmed_svg(text.substr(4, text.size() - 5));
    if (text.size() >= 2 && (text[0] == '"' || text[0] == '\'')) {
      text = trimmed_svg(text.substr(1, text.size() - 2));
    }
  }
  if (text.empty() || text[0] != '#') return "";
  return std::string(text.substr(1));
}

std::optional<Color> representative_color(const SvgPaint& paint, const SvgDocument& document) {
  if (!paint.server) return paint.color;
  const auto found = document.ids.find(*paint.server);
  if (found == document.ids.end()) return paint.color;
  pugi::xml_node server = found->second;
  if (local_name(server.name()) == "pattern") return Color{0.5, 0.5, 0.5, 1};
  for (int i = 0; i < max_href_chain && server; ++i) {
    const std::vector<Stop> stops = own_stops(server);
    if (!stops.empty()) return overall_color(stops);
    server = referenced_element(document, server);
  }
  return std::nullopt;
}

}  // namespace relievo
