#include <algorithm>

#include "io/svg/part_lookup.h"
#include "io/svg/scanner.h"

namespace relievo {
namespace {

Result<CueKind> kind_of(const SvgShape& shape, const std::string& where) {
  for (const CueKind kind : {CueKind::bulge, CueKind::slope, CueKind::crease})
    if (shape.annotation.cue == name(kind)) return kind;
  return Error{ErrorCode::bad_input, "data-cue must be bulge, slope or crease", where};
}

Result<double> value_of(const SvgShape& shape, CueKind kind, const std::string& where) {
  SvgScanner scanner(trimmed_svg(shape.annotation.value));
  const auto value = scanner.number();
  if (value && scanner.at_end() && has_sound_value({0, kind, {}, *value})) return *value;
  return Error{ErrorCode::bad_input,
               kind == CueKind::bulge ? "data-value must be a number from 0.05 to 10"
                                      : "data-value must be a number of degrees from -75 to 75",
               where};
}

std::vector<Point2> line_of(const Polyline& polyline) {
  std::vector<Point2> line = polyline.points;
  if (polyline.closed && !line.empty()) line.push_back(line.front());
  line.erase(std::unique(line.begin(), line.end()), line.end());
  return line;
}

}  // namespace

Result<AnnotatedCues> annotated_cues(const SvgDrawing& drawing,
                                     const std::vector<AnnotatedPart>& parts) {
  AnnotatedCues found;
  for (const SvgShape& shape : drawing.shapes) {
    if (!shape.cue) continue;
    const std::string where = shape.name.empty() ? "cue" : shape.name;
    const auto kind = kind_of(shape, where);
    if (!kind) return kind.error();
    const auto value = value_of(shape, *kind, where);
    if (!value) return value.error();
    const auto part = part_named(drawing, parts, shape.annotation.part,
                                 enclosing_part(drawing, parts, shape.group), where);
    if (!part) return part.error();
    if (*part < 0)
      return Error{ErrorCode::bad_input, "the cue is in no part: name it in data-part", where};
    for (const Polyline& polyline : shape.lines) {
      std::vector<Point2> line = line_of(polyline);
      if (line.size() >= 2) found.cues.push_back({*part, *kind, std::move(line), *value});
    }
    found.elements.push_back(shape.element);
  }
  return found;
}

}  // namespace relievo
