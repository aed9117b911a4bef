#include "io/svg/affine.h"

#include <cmath>
#include <vector>

#include "io/svg/scanner.h"

namespace relievo {
namespace {

constexpr double radians = 3.14159265358979323846 / 180;

Affine2 rotation(double degrees) {
  const double s = std::sin(degrees * radians);
  const double c = std::cos(degrees * radians);
  return {c, s, -s, c, 0, 0};
}

std::optional<Affine2> primitive(std::string_view name, const std::vector<double>& v) {
  const size_t n = v.size();
  if (name == "matrix" && n == 6) return Affine2{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return translation(v[0], n == 2 ? v[1] : 0);
  if (name == "scale" && (n == 1 || n == 2)) return scaling(v[0], n == 2 ? v[1] : v[0]);
  if (name == "rotate" && n == 1) return rotation(v[0]);
  if (name == "rotate" && n == 3) {
    return translation(v[1], v[2]) * rotation(v[0]) * translation(-v[1], -v[2]);
  }
  if (name == "skewX" && n == 1) return Affine2{1, 0, std::tan(v[0] * radians), 1, 0, 0};
  if (name == "skewY" && n == 1) return Affine2{1, std::tan(v[0] * radians), 0, 1, 0, 0};
  return std::nullopt;
}

std::optional<std::vector<double>> arguments(SvgScanner& scanner) {
  scanner.skip_space();
  if (!scanner.take('(')) return std::nullopt;
  std::vector<double> values;
  scanner.skip_space();
  while (!scanner.take(')')) {
    const std::optional<double> value = scanner.number();
    if (!value) return std::nullopt;
    values.push_back(*value);
    scanner.skip_separator();
  }
  return values;
}

}  // namespace

Affine2 operator*(const Affine2& outer, const Affine2& inner) {
  const Point2 origin = outer({inner.e, inner.f});
  return {outer.a * inner.a + outer.c * inner.b,
          outer.b * inner.a + outer.d * inner.b,
          outer.a * inner.c + outer.c * inner.d,
          outer.b * inner.c + outer.d * inner.d,
          origin.x,
          origin.y};
}

std::optional<Affine2> parse_transform(std::string_view text) {
  SvgScanner scanner(text);
  Affine2 total;
  for (scanner.skip_separator(); !scanner.at_end(); scanner.skip_separator()) {
    const std::string_view name = scanner.word();
    const auto values = arguments(scanner);
    if (!values) return std::nullopt;
    const auto step = primitive(name, *values);
    if (!step) return std::nullopt;
    total = total * *step;
  }
  return total;
}

}  // namespace relievo
