#include "io/svg/svg_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Appends the digits from `i` on to `mantissa` and returns their count. Digits beyond the
/// precision of a double only move the decimal point.
int read_digits(std::string_view text, size_t& i, double& mantissa, int& dropped) {
  int count = 0;
  for (; i < text.size() && is_digit(text[i]); ++i, ++count) {
    if (mantissa < 1e17) {
      mantissa = 10 * mantissa + (text[i] - '0');
    } else {
      ++dropped;
    }
  }
  return count;
}

/// Reads the exponent at `i` ("e-3"); 0 where there is none.
int read_exponent(std::string_view text, size_t& i) {
  if (i >= text.size() || (text[i] != 'e' && text[i] != 'E')) return 0;
  size_t j = i + 1;
  bool negative = false;
  if (j < text.size() && (text[j] == '+' || text[j] == '-')) negative = text[j++] == '-';
  if (j >= text.size() || !is_digit(text[j])) return 0;
  int value = 0;
  for (; j < text.size() && is_digit(text[j]); ++j)
    value = std::min(9999, 10 * value + text[j] - '0');
  i = j;
  return negative ? -value : value;
}

double scaled(double mantissa, int exponent) {
  if (mantissa == 0) return 0;
  if (exponent < -300) return mantissa * 1e-300 * std::pow(10.0, exponent + 300);
  return exponent < 0 ? mantissa / std::pow(10.0, -exponent) : mantissa * std::pow(10.0, exponent);
}

/// Returns 0, 1/2 or 1 for Min, Mid or Max at `position` of an alignment like xMidYMax.
double alignment(std::string_view align, size_t position) {
  const std::string_view word = align.size() >= position + 3 ? align.substr(position, 3) : "Mid";
  if (word == "Min") return 0;
  return word == "Max" ? 1 : 0.5;
}

/// Reads an absolute length; nothing for one that is missing, relative or not positive.
std::optional<double> absolute_length(const pugi::xml_attribute& attribute) {
  const std::string_view text = trimmed_svg(attribute.value());
  if (text.empty() || text.back() == '%') return std::nullopt;
  const auto value = parse_length(text, LengthAxis::horizontal, {});
  if (!value || !(*value > 0) || !std::isfinite(*value)) return std::nullopt;
  return value;
}

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

std::optional<Color> hex_color(std::string_view digits) {
  const size_t n = digits.size();
  if (n != 3 && n != 4 && n != 6 && n != 8) return std::nullopt;
  const size_t width = n < 6 ? 1 : 2;
  std::array<double, 4> channel = {0, 0, 0, 1};
  for (size_t i = 0; i < n / width; ++i) {
    const char* begin = digits.data() + i * width;
    unsigned value = 0;
    if (std::from_chars(begin, begin + width, value, 16).ptr != begin + width) return std::nullopt;
    channel[i] = (width == 1 ? 17 * value : value) / 255.0;
  }
  return Color{channel[0], channel[1], channel[2], channel[3]};
}

/// Returns the colour of a keyword in lower case; nothing for any other text.
std::optional<Color> keyword_color(std::string_view name) {
  static const std::map<std::string_view, std::string_view> digits = [] {
    constexpr size_t digit_count = 6;
    std::map<std::string_view, std::string_view> map;
    for (std::string_view rest = color_keywords; !rest.empty();) {
      const size_t gap = rest.find(' ');
      map.emplace(rest.substr(0, gap), rest.substr(gap + 1, digit_count));
      rest.remove_prefix(std::min(rest.size(), gap + digit_count + 2));
    }
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

void SvgScanner::skip_space() {
  while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
}

void SvgScanner::skip_separator() {
  skip_space();
  if (take(',')) skip_space();
}

bool SvgScanner::take(char c) {
  if (rest_.empty() || rest_.front() != c) return false;
  rest_.remove_prefix(1);
  return true;
}

std::optional<double> SvgScanner::number() {
  size_t i = 0;
  bool negative = false;
  if (i < rest_.size() && (rest_[i] == '+' || rest_[i] == '-')) negative = rest_[i++] == '-';
  double mantissa = 0;
  int shift = 0;
  int digits = read_digits(rest_, i, mantissa, shift);
  if (i < rest_.size() && rest_[i] == '.') {
    ++i;
    int dropped = 0;
    const int fraction = read_digits(rest_, i, mantissa, dropped);
    shift -= fraction - dropped;
    digits += fraction;
  }
  if (digits == 0) return std::nullopt;
  const double value = scaled(mantissa, shift + read_exponent(rest_, i));
  rest_.remove_prefix(i);
  return negative ? -value : value;
}

std::optional<bool> SvgScanner::flag() {
  if (peek() != '0' && peek() != '1') return std::nullopt;
  const bool value = peek() == '1';
  rest_.remove_prefix(1);
  return value;
}

std::string_view SvgScanner::word() {
  size_t n = 0;
  while (n < rest_.size() && (is_letter(rest_[n]) || rest_[n] == '-')) ++n;
  const std::string_view found = rest_.substr(0, n);
  rest_.remove_prefix(n);
  return found;
}

std::string_view trimmed_svg(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view local_name(std::string_view name) {
  const size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view next_svg_item(std::string_view& text) {
  const auto separates = [](char c) { return is_space(c) || c == ','; };
  while (!text.empty() && separates(text.front())) text.remove_prefix(1);
  const auto end = std::find_if(text.begin(), text.end(), separates);
  const std::string_view item = text.substr(0, static_cast<size_t>(end - text.begin()));
  text.remove_prefix(item.size());
  return item;
}

Affine2 operator*(const Affine2& outer, const Affine2& inner) {
  const Point2 origin = outer({inner.e, inner.f});
  return {outer.a * inner.a + outer.c * inner.b,
          outer.b * inner.a + outer.d * inner.b,
          outer.a * inner.c + outer.c * inner.d,
          outer.b * inner.c + outer.d * inner.d,
          origin.x,
          origin.y};
}

Affine2 inverse(const Affine2& m) {
  const double det = m.a * m.d - m.b * m.c;
  return Affine2{m.d / det, -m.b / det, -m.c / det, m.a / det, 0, 0} * translation(-m.e, -m.f);
}

double reference_length(LengthAxis axis, const LengthContext& context) {
  if (axis == LengthAxis::horizontal) return context.viewport_width;
  if (axis == LengthAxis::vertical) return context.viewport_height;
  return std::hypot(context.viewport_width, context.viewport_height) / std::sqrt(2.0);
}

double unit_factor(const std::string& unit, const LengthContext& context) {
  if (unit.empty() || unit == "px") return 1;
  if (unit == "pt") return 96.0 / 72;
  if (unit == "pc") return 16;
  if (unit == "mm") return 96 / 25.4;
  if (unit == "cm") return 96 / 2.54;
  if (unit == "in") return 96;
  if (unit == "em") return context.font_size;
  if (unit == "rem") return 16;
  if (unit == "ex") return context.font_size / 2;
  return 0;
}

std::optional<double> parse_length(std::string_view text, LengthAxis axis,
                                   const LengthContext& context) {
  SvgScanner scanner(trimmed_svg(text));
  const std::optional<double> value = scanner.number();
  if (!value) return std::nullopt;
  if (scanner.rest() == "%") return *value / 100 * reference_length(axis, context);
  const double factor = unit_factor(lower_case(scanner.rest()), context);
  if (factor == 0) return std::nullopt;
  return *value * factor;
}

std::optional<ViewBox> parse_view_box(std::string_view text) {
  SvgScanner scanner(text);
  std::array<double, 4> v = {};
  for (double& value : v) {
    scanner.skip_separator();
    const auto number = scanner.number();
    if (!number || !std::isfinite(*number)) return std::nullopt;
    value = *number;
  }
  if (!(v[2] > 0) || !(v[3] > 0)) return std::nullopt;
  return ViewBox{v[0], v[1], v[2], v[3]};
}

Affine2 fit_view_box(const ViewBox& box, double width, double height,
                     std::string_view preserve_aspect_ratio) {
  std::string_view align = next_svg_item(preserve_aspect_ratio);
  if (align == "defer") align = next_svg_item(preserve_aspect_ratio);
  const bool slice = next_svg_item(preserve_aspect_ratio) == "slice";
  double sx = width / box.width;
  double sy = height / box.height;
  if (align != "none") sx = sy = slice ? std::max(sx, sy) : std::min(sx, sy);
  const double x = (width - sx * box.width) * alignment(align, 1);
  const double y = (height - sy * box.height) * alignment(align, 5);
  return translation(x, y) * scaling(sx, sy) * translation(-box.x, -box.y);
}

std::optional<RootSize> root_size(const pugi::xml_node& root) {
  const auto width = absolute_length(root.attribute("width"));
  const auto height = absolute_length(root.attribute("height"));
  const auto box = parse_view_box(root.attribute("viewBox").value());
  if (width && height) return RootSize{*width, *height};
  if (!box) return std::nullopt;
  if (width) return RootSize{*width, *width * box->height / box->width};
  if (height) return RootSize{*height * box->width / box->height, *height};
  return RootSize{box->width, box->height};
}

std::optional<Color> parse_color(std::string_view text) {
  const std::string name = lower_case(trimmed_svg(text));
  if (name.empty()) return std::nullopt;
  if (name[0] == '#') return hex_color(std::string_view(name).substr(1));
  if (name == "transparent") return Color{0, 0, 0, 0};
  if (const auto color = keyword_color(name)) return color;
  return function_color(name);
}

}  // namespace relievo
