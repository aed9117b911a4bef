#include "io/svg/svg_color.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "io/svg/named_colors.h"
#include "io/svg/scanner.h"

namespace relievo {
namespace {

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

std::optional<Color> hex_color(std::string_view digits) {
  const size_t n = digits.size();
  if (n != 3 && n != 4 && n != 6 && n != 8) return std::nullopt;
  const size_t width = n < 6 ? 1 : 2;
  std::array<double, 4> channel = {0, 0, 0, 1};
  for (size_t i = 0; i < n / width; ++i) {
    const int high = hex_digit(digits[i * width]);
    const int low = hex_digit(digits[i * width + width - 1]);
    if (high < 0 || low < 0) return std::nullopt;
    channel[i] = (16 * high + low) / 255.0;
  }
  return Color{channel[0], channel[1], channel[2], channel[3]};
}

double unit_clamp(double value) { return value > 0 ? std::min(value, 1.0) : 0; }

struct Component {
  double value = 0;
  bool percent = false;
};

std::vector<Component> components(SvgScanner& scanner) {
  std::vector<Component> list;
  if (!scanner.take('(')) return list;
  for (scanner.skip_space(); !scanner.take(')'); scanner.skip_separator()) {
    if (scanner.take('/')) scanner.skip_space();
    const auto value = scanner.number();
    if (!value) return {};
    list.push_back({*value, scanner.take('%')});
    scanner.word();
  }
  return list;
}

Color from_hsl(double hue, double saturation, double lightness) {
  const double chroma = saturation * std::min(lightness, 1 - lightness);
  const auto channel = [=](double n) {
    const double k = std::fmod(n + std::fmod(hue / 30, 12) + 12, 12);
    return lightness - chroma * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
  };
  return {channel(0), channel(8), channel(4), 1};
}

std::optional<Color> function_color(std::string_view text) {
  SvgScanner scanner(text);
  const std::string_view name = scanner.word();
  const std::vector<Component> c = components(scanner);
  if (c.size() != 3 && c.size() != 4) return std::nullopt;
  Color color;
  if (name == "rgb" || name == "rgba") {
    const auto channel = [](const Component& v) {
      return unit_clamp(v.value / (v.percent ? 100 : 255));
    };
    color = {channel(c[0]), channel(c[1]), channel(c[2]), 1};
  } else if (name == "hsl" || name == "hsla") {
    color = from_hsl(c[0].value, unit_clamp(c[1].value / 100), unit_clamp(c[2].value / 100));
  } else {
    return std::nullopt;
  }
  if (c.size() == 4) color.a = unit_clamp(c[3].percent ? c[3].value / 100 : c[3].value);
  return color;
}

}  // namespace

std::optional<Color> parse_color(std::string_view text) {
  const std::string name = lower_case(trimmed_svg(text));
  if (name.empty()) return std::nullopt;
  if (name[0] == '#') return hex_color(std::string_view(name).substr(1));
  if (name == "transparent") return Color{0, 0, 0, 0};
  if (const auto rgb = named_color(name)) {
    return Color{(*rgb >> 16) / 255.0, (*rgb >> 8 & 255) / 255.0, (*rgb & 255) / 255.0, 1};
  }
  return function_color(name);
}

}  // namespace relievo
