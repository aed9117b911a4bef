#include "io/svg/svg_style.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "io/svg/svg_attributes.h"
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

/// A declaration that is applied to the style of an element.
struct Applied {
  SvgStyle& style;
  const SvgStyle& parent;
  LengthContext context;
  const std::string& value;

  /// Sets a property to that of the parent for "inherit", else to the value read, if any.
  template <class T>
  void set(T SvgStyle::*property, const std::optional<T>& read) const {
    if (value == "inherit")
      style.*property = parent.*property;
    else if (read)
      style.*property = *read;
  }

  /// Sets a property to the value of a keyword.
  template <class T>
  void choose(T SvgStyle::*property, const std::map<std::string, T>& keywords) const {
    const auto found = keywords.find(value);
    set(property, found == keywords.end() ? std::nullopt : std::optional(found->second));
  }
};

const std::map<std::string, LineCap> caps = {
    {"butt", LineCap::butt}, {"round", LineCap::round}, {"square", LineCap::square}};
const std::map<std::string, LineJoin> joins = {{"miter", LineJoin::miter},
                                               {"miter-clip", LineJoin::miter},
                                               {"round", LineJoin::round},
                                               {"bevel", LineJoin::bevel}};
const std::map<std::string, FillRule> rules = {{"nonzero", FillRule::nonzero},
                                               {"evenodd", FillRule::even_odd}};
const std::map<std::string, bool> visibilities = {
    {"visible", true}, {"hidden", false}, {"collapse", false}};

std::optional<double> pen_width(const Applied& a) {
  LengthContext context = a.context;
  context.font_size = a.style.font_size;
  const auto width = parse_length(a.value, LengthAxis::diagonal, context);
  return width && *width >= 0 ? width : std::nullopt;
}

std::optional<double> miter_limit(std::string_view text) {
  const auto limit = SvgScanner(text).number();
  return limit && *limit >= 1 ? limit : std::nullopt;
}

/// Sets any property but those of apply_first.
void apply(const Applied& a, std::string_view name) {
  const std::string& value = a.value;
  if (name == "fill") return a.set(&SvgStyle::fill, parse_paint(value, a.style.color));
  if (name == "stroke") return a.set(&SvgStyle::stroke, parse_paint(value, a.style.color));
  if (name == "fill-opacity") return a.set(&SvgStyle::fill_opacity, parse_fraction(value));
  if (name == "stroke-opacity") return a.set(&SvgStyle::stroke_opacity, parse_fraction(value));
  if (name == "opacity") return a.set(&SvgStyle::opacity, parse_fraction(value));
  if (name == "stroke-width") return a.set(&SvgStyle::stroke_width, pen_width(a));
  if (name == "stroke-linecap") return a.choose(&SvgStyle::cap, caps);
  if (name == "stroke-linejoin") return a.choose(&SvgStyle::join, joins);
  if (name == "stroke-miterlimit") return a.set(&SvgStyle::miter_limit, miter_limit(value));
  if (name == "fill-rule") return a.choose(&SvgStyle::fill_rule, rules);
  if (name == "clip-rule") return a.choose(&SvgStyle::clip_rule, rules);
  if (name == "visibility") return a.choose(&SvgStyle::visible, visibilities);
  if (name == "display") return a.set(&SvgStyle::displayed, std::optional(value != "none"));
  if (name == "overflow") a.style.clips_overflow = value != "visible" && value != "auto";
  const std::optional<std::string> reference = local_reference(value);
  if (name == "clip-path") return a.set(&SvgStyle::clip_path, reference);
  if (name == "mask") return a.set(&SvgStyle::mask, reference);
  if (name == "filter") return a.set(&SvgStyle::filter, reference);
  if (name == "isolation") a.style.isolates = value == "isolate";
  if (name == "mix-blend-mode") a.style.blends = value != "normal";
}

/// Sets `color` or `font-size`, to which other properties refer.
void apply_first(const Applied& a, std::string_view name) {
  if (name == "color") return a.set(&SvgStyle::color, paint_color(a.value, a.parent.color));
  if (name != "font-size") return;
  LengthContext context = a.context;
  context.font_size = a.parent.font_size;
  context.viewport_height = a.parent.font_size;  // a percentage is of the parent's font size
  const auto size = parse_length(a.value, LengthAxis::vertical, context);
  if (size && *size > 0) a.style.font_size = *size;
}

/// Returns all declarations for the element, the strongest last.
std::vector<Declaration> declarations_of(const pugi::xml_node& element) {
  std::vector<Declaration> list;
  for (const pugi::xml_attribute& attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name == "style" || name == "d" || name == "points") continue;
    if (name == "mix-blend-mode" || name == "isolation") continue;  // of CSS alone
    list.push_back({std::string(name), std::string(trimmed_svg(attribute.value())), false});
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

std::vector<Stop> own_stops(const pugi::xml_node& gradient) {
  std::vector<Stop> stops;
  for (const pugi::xml_node& child : gradient.children()) {
    if (local_name(child.name()) != "stop") continue;
    Stop stop{parse_fraction(child.attribute("offset").value()).value_or(0),
              parse_color(stated_value(child, "stop-color")).value_or(Color{})};
    if (!stops.empty()) stop.offset = std::max(stop.offset, stops.back().offset);
    stop.color.a *= parse_fraction(stated_value(child, "stop-opacity")).value_or(1);
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

SvgStyle computed_style(const pugi::xml_node& element, const SvgStyle& parent,
                        const LengthContext& context) {
  SvgStyle style = parent;
  style.opacity = 1;
  style.displayed = true;
  style.clips_overflow = true;
  style.clip_path.clear();
  style.mask.clear();
  style.filter.clear();
  style.blends = style.isolates = false;
  const std::vector<Declaration> list = declarations_of(element);
  for (const Declaration& d : list) apply_first({style, parent, context, d.value}, d.name);
  for (const Declaration& d : list) apply({style, parent, context, d.value}, d.name);
  style.isolates |= style.blends || style.opacity < 1 || !style.mask.empty() ||
                    !style.filter.empty() || !style.clip_path.empty();
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
