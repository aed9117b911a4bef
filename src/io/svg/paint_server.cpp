#include "io/svg/paint_server.h"

#include <algorithm>
#include <vector>

namespace relievo {
namespace {

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
  const LengthContext fraction{16, 1, 1};
  for (const pugi::xml_node& child : gradient.children()) {
    if (local_name(child.name()) != "stop") continue;
    const auto offset =
        parse_length(child.attribute("offset").value(), LengthAxis::horizontal, fraction);
    const auto opacity =
        parse_length(property(child, "stop-opacity"), LengthAxis::horizontal, fraction);
    Stop stop{std::clamp(offset.value_or(0), 0.0, 1.0),
              parse_color(property(child, "stop-color")).value_or(Color{})};
    if (!stops.empty()) stop.offset = std::max(stop.offset, stops.back().offset);
    stop.color.a *= std::clamp(opacity.value_or(1), 0.0, 1.0);
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

std::optional<Color> representative_color(const SvgPaint& paint, const SvgDocument& document) {
  if (paint.kind == SvgPaint::Kind::none) return std::nullopt;
  if (paint.kind == SvgPaint::Kind::color) return paint.color;
  const auto found = document.ids.find(paint.server);
  if (found == document.ids.end()) {
    return paint.has_fallback ? std::optional<Color>(paint.color) : std::nullopt;
  }
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
