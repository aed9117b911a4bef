#include "io/svg/annotated_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/svg/annotated_parts.h"
#include "io/svg/scanner.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

/// Largest distance of a line in a layer from the outline that it follows / diagonal of the canvas.
constexpr double near_outline = 0.015;

double distance_to_outline(Point2 p, const Outline& outline) {
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& ring : outline) {
    for (size_t i = 0; i < ring.size(); ++i) {
      least = std::min(least, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
    }
  }
  return least;
}

/// Returns the fraction of the line's length inside the outline, by midpoints of short pieces.
double fraction_inside(const std::vector<Point2>& line, const Outline& outline) {
  double inside = 0;
  double length = 0;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const double piece = distance(line[i], line[i + 1]) / 8;
    length += 8 * piece;
    for (int k = 0; k < 8; ++k) {
      const Point2 p = line[i] + ((k + 0.5) / 8) * (line[i + 1] - line[i]);
      if (contains(outline, p)) inside += piece;
    }
  }
  return length > 0 ? inside / length : 0;
}

std::vector<Point2> without_repeats(std::vector<Point2> line) {
  line.erase(std::unique(line.begin(), line.end()), line.end());
  return line;
}

/// Returns the nearest part behind that contains most of the line, else the one that contains the
/// largest share of it, or -1.
int part_behind(const std::vector<AnnotatedPart>& parts, const std::vector<Point2>& line,
                int upper) {
  int best = -1;
  double most = 0;
  for (int k = upper - 1; k >= 0; --k) {
    const double share = fraction_inside(line, parts[k].part.outline);
    if (share > 0.5) return k;
    if (share > most) {
      most = share;
      best = k;
    }
  }
  return best;
}

/// Adds the joins of a marked line, one for each of its subpaths.
Status add_marked(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                  const SvgShape& shape, std::vector<Join>& joins) {
  const std::string where = shape.name.empty() ? "join" : shape.name;
  const auto upper = part_named(drawing, parts, shape.element.attribute("data-upper").value(),
                                enclosing_part(drawing, parts, shape.group), where);
  if (!upper) return upper.error();
  const auto lower =
      part_named(drawing, parts, shape.element.attribute("data-lower").value(), -1, where);
  if (!lower) return lower.error();
  if (*upper < 0)
    return Error{ErrorCode::bad_input, "the join lies in no part; name its part in data-upper",
                 where};
  for (const Polyline& polyline : shape.lines) {
    std::vector<Point2> line = without_repeats(polyline.points);
    if (line.size() < 2) continue;
    const int behind = *lower >= 0 ? *lower : part_behind(parts, line, *upper);
    if (behind < 0 || behind == *upper)
      return Error{ErrorCode::contradiction,
                   "the join lies over no part behind its own; move it over one, or name that part "
                   "in data-lower",
                   where};
    joins.push_back({*upper, behind, std::move(line)});
  }
  return Done{};
}

/// Adds an unmarked line in a layer if it follows the outline of its part over another part;
/// returns whether it does.
bool add_likely(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                const SvgShape& shape, std::vector<Join>& joins) {
  const int upper = enclosing_part(drawing, parts, shape.group);
  if (upper < 0 || shape.lines.size() != 1 || shape.lines.front().closed) return false;
  std::vector<Point2> line = without_repeats(shape.lines.front().points);
  const int lower = line.size() < 2 ? -1 : part_behind(parts, line, upper);
  if (lower < 0 || fraction_inside(line, parts[lower].part.outline) < 0.5) return false;
  const double reach = near_outline * drawing.canvas().diagonal();
  const Outline& outline = parts[upper].part.outline;
  const bool follows = std::all_of(
      line.begin(), line.end(), [&](Point2 p) { return distance_to_outline(p, outline) <= reach; });
  if (follows) joins.push_back({upper, lower, std::move(line)});
  return follows;
}

Result<CueKind> kind_of(const SvgShape& shape, const std::string& where) {
  const std::string_view text = trimmed_svg(shape.element.attribute("data-cue").value());
  for (const CueKind kind : {CueKind::bulge, CueKind::slope, CueKind::crease})
    if (text == name(kind)) return kind;
  return Error{ErrorCode::bad_input, "data-cue must be bulge, slope or crease", where};
}

Result<double> value_of(const SvgShape& shape, CueKind kind, const std::string& where) {
  SvgScanner scanner(trimmed_svg(shape.element.attribute("data-value").value()));
  const auto value = scanner.number();
  if (value && scanner.at_end() && has_sound_value({0, kind, {}, *value})) return *value;
  return Error{ErrorCode::bad_input,
               kind == CueKind::bulge ? "data-value must be a number from 0.05 to 10"
                                      : "data-value must be a number of degrees from -75 to 75",
               where};
}

std::vector<Point2> closed_up(const Polyline& polyline) {
  std::vector<Point2> line = polyline.points;
  if (polyline.closed && !line.empty()) line.push_back(line.front());
  return without_repeats(std::move(line));
}

}  // namespace

Status add_annotated_joins(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                           bool layers, std::vector<Join>& joins,
                           std::vector<pugi::xml_node>& elements) {
  for (const SvgShape& shape : drawing.shapes) {
    if (shape.join) {
      if (const Status s = add_marked(drawing, parts, shape, joins); !s) return s.error();
      elements.push_back(shape.element);
    } else if (layers && !shape.cue && !shape.fill && shape.stroke) {
      if (add_likely(drawing, parts, shape, joins)) elements.push_back(shape.element);
    }
  }
  return Done{};
}

Status add_annotated_cues(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                          std::vector<Cue>& cues, std::vector<pugi::xml_node>& elements) {
  for (const SvgShape& shape : drawing.shapes) {
    if (!shape.cue) continue;
    const std::string where = shape.name.empty() ? "cue" : shape.name;
    const auto kind = kind_of(shape, where);
    if (!kind) return kind.error();
    const auto value = value_of(shape, *kind, where);
    if (!value) return value.error();
    const auto part = part_named(drawing, parts, shape.element.attribute("data-part").value(),
                                 enclosing_part(drawing, parts, shape.group), where);
    if (!part) return part.error();
    if (*part < 0)
      return Error{ErrorCode::bad_input, "the cue lies in no part; name its part in data-part",
                   where};
    for (const Polyline& polyline : shape.lines) {
      std::vector<Point2> line = closed_up(polyline);
      if (line.size() >= 2) cues.push_back({*part, *kind, std::move(line), *value});
    }
    elements.push_back(shape.element);
  }
  return Done{};
}

}  // namespace relievo
