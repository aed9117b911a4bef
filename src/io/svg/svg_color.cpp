#include "io/svg/svg_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "io/svg/scanner.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

/// The colour keywords of CSS, each with its red, green and blue.
constexpr const char* color_keywords =
    "aliceblue f0f8ff antiquewhite faebd7 aqua 00ffff aquamarine 7fffd4 azure f0ffff "
    "beige f5f5dc bisque ffe4c4 black 000000 blanchedalmond ffebcd blue 0000ff "
    "blueviolet 8a2be2 brown a52a2a burlywood deb887 cadetblue 5f9ea0 chartreuse 7fff00 "
    "chocolate d2691e coral ff7f50 cornflowerblue 6495ed cornsilk fff8dc crimson dc143c "
    "cyan 00ffff darkblue 00008b darkcyan 008b8b darkgoldenrod b8860b darkgray a9a9a9 "
    "darkgreen 006400 darkgrey a9a9a9 darkkhaki bdb76b darkmagenta 8b008b "
    "darkolivegreen 556b2f darkorange ff8c00 darkorchid 9932cc darkred 8b0000 "
    "darksalmon e9967a darkseagreen 8fbc8f darkslateblue 483d8b darkslategray 2f4f4f "
    "darkslategrey 2f4f4f darkturquoise 00ced1 darkviolet 9400d3 deeppink ff1493 "
    "deepskyblue 00bfff dimgray 696969 dimgrey 696969 dodgerblue 1e90ff firebrick b22222 "
    "floralwhite fffaf0 forestgreen 228b22 fuchsia ff00ff gainsboro dcdcdc ghostwhite f8f8ff "
    "gold ffd700 goldenrod daa520 gray 808080 green 008000 greenyellow adff2f grey 808080 "
    "honeydew f0fff0 hotpink ff69b4 indianred cd5c5c indigo 4b0082 ivory fffff0 khaki f0e68c "
    "lavender e6e6fa lavenderblush fff0f5 lawngreen 7cfc00 lemonchiffon fffacd "
    "lightblue add8e6 lightcoral f08080 lightcyan e0ffff lightgoldenrodyellow fafad2 "
    "lightgray d3d3d3 lightgreen 90ee90 lightgrey d3d3d3 lightpink ffb6c1 lightsalmon ffa07a "
    "lightseagreen 20b2aa lightskyblue 87cefa lightslategray 778899 lightslategrey 778899 "
    "lightsteelblue b0c4de lightyellow ffffe0 lime 00ff00 limegreen 32cd32 linen faf0e6 "
    "magenta ff00ff maroon 800000 mediumaquamarine 66cdaa mediumblue 0000cd "
    "mediumorchid ba55d3 mediumpurple 9370db mediumseagreen 3cb371 mediumslateblue 7b68ee "
    "mediumspringgreen 00fa9a mediumturquoise 48d1cc mediumvioletred c71585 "
    "midnightblue 191970 mintcream f5fffa mistyrose ffe4e1 moccasin ffe4b5 navajowhite ffdead "
    "navy 000080 oldlace fdf5e6 olive 808000 olivedrab 6b8e23 orange ffa500 orangered ff4500 "
    "orchid da70d6 palegoldenrod eee8aa palegreen 98fb98 paleturquoise afeeee "
    "palevioletred db7093 papayawhip ffefd5 peachpuff ffdab9 peru cd853f pink ffc0cb "
    "plum dda0dd powderblue b0e0e6 purple 800080 rebeccapurple 663399 red ff0000 "
    "rosybrown bc8f8f royalblue 4169e1 saddlebrown 8b4513 salmon fa8072 sandybrown f4a460 "
    "seagreen 2e8b57 seashell fff5ee sienna a0522d silver c0c0c0 skyblue 87ceeb "
    "slateblue 6a5acd slategray 708090 slategrey 708090 snow fffafa springgreen 00ff7f "
    "steelblue 4682b4 tan d2b48c teal 008080 thistle d8bfd8 tomato ff6347 turquoise 40e0d0 "
    "violet ee82ee wheat f5deb3 white ffffff whitesmoke f5f5f5 yellow ffff00 "
    "yellowgreen 9acd32";

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

/// Returns the colour of a keyword in lower case; nothing for any other text.
std::optional<Color> keyword_color(const std::string& name) {
  static const std::map<std::string, std::string> digits = [] {
    std::map<std::string, std::string> map;
    std::istringstream words(color_keywords);
    for (std::string word, code; words >> word >> code;) map.emplace(word, code);
    return map;
  }();
  const auto found = digits.find(name);
  return found == digits.end() ? std::nullopt : hex_color(found->second);
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
  if (const auto color = keyword_color(name)) return color;
  return function_color(name);
}

}  // namespace relievo
