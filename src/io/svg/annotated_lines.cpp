#include "io/svg/annotated_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/svg/annotated_parts.h"
#include "io/svg/scanner.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

/// How far a line in a layer may be from the outline it follows, as a fraction of the canvas
/// diagonal.
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

/// The fraction of the line's length that is inside the outline, by midpoints of short pieces.
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

/// Connects the lines of a drawing with its parts.
class JoinFinder {
 public:
  JoinFinder(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts)
      : drawing_(drawing), parts_(parts) {}

  /// The joins of a marked line, one for each of its subpaths.
  Status add_marked(const SvgShape& shape, AnnotatedJoins& found) const {
    const std::string where = shape.name.empty() ? "join" : shape.name;
    const auto named = part_named(drawing_, parts_, shape.annotation.upper,
                                  enclosing_part(drawing_, parts_, shape.group), where);
    if (!named) return named.error();
    const auto lower = part_named(drawing_, parts_, shape.annotation.lower, -1, where);
    if (!lower) return lower.error();
    const int upper = *named;
    if (upper < 0) {
      return Error{ErrorCode::bad_input, "the join is in no part: name it in data-upper", where};
    }
    for (const Polyline& polyline : shape.lines) {
      std::vector<Point2> line = without_repeats(polyline.points);
      if (line.size() < 2) continue;
      const int behind = *lower >= 0 ? *lower : part_behind(line, upper);
      if (behind < 0 || behind == upper) {
        return Error{ErrorCode::contradiction, "the join lies over no part behind its own", where};
      }
      found.joins.push_back({upper, behind, std::move(line)});
    }
    found.elements.push_back(shape.element);
    return Done{};
  }

  /// A line in a layer that nobody marked: a join if it follows the outline over another part.
  void add_likely(const SvgShape& shape, AnnotatedJoins& found) const {
    const int upper = enclosing_part(drawing_, parts_, shape.group);
    if (upper < 0 || shape.lines.size() != 1 || shape.lines.front().closed) return;
    std::vector<Point2> line = without_repeats(shape.lines.front().points);
    const int lower = line.size() < 2 ? -1 : part_behind(line, upper);
    if (lower < 0 || fraction_inside(line, parts_[lower].part.outline) < 0.5) return;
    const double reach = near_outline * drawing_.canvas().diagonal();
    const Outline& outline = parts_[upper].part.outline;
    const bool follows = std::all_of(line.begin(), line.end(), [&](Point2 p) {
      return distance_to_outline(p, outline) <= reach;
    });
    if (!follows) return;
    found.joins.push_back({upper, lower, std::move(line)});
    found.elements.push_back(shape.element);
  }

 private:
  /// The nearest part behind that contains most of the line, else the one that contains the
  /// largest share of it, or -1.
  int part_behind(const std::vector<Point2>& line, int upper) const {
    int best = -1;
    double most = 0;
    for (int k = upper - 1; k >= 0; --k) {
      const double share = fraction_inside(line, parts_[k].part.outline);
      if (share > 0.5) return k;
      if (share > most) {
        most = share;
        best = k;
      }
    }
    return best;
  }

  const SvgDrawing& drawing_;
  const std::vector<AnnotatedPart>& parts_;
};

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

std::vector<Point2> closed_up(const Polyline& polyline) {
  std::vector<Point2> line = polyline.points;
  if (polyline.closed && !line.empty()) line.push_back(line.front());
  return without_repeats(std::move(line));
}

}  // namespace

Result<AnnotatedJoins> annotated_joins(const SvgDrawing& drawing,
                                       const std::vector<AnnotatedPart>& parts, bool layers) {
  const JoinFinder finder(drawing, parts);
  AnnotatedJoins found;
  for (const SvgShape& shape : drawing.shapes) {
    if (shape.join) {
      if (const Status s = finder.add_marked(shape, found); !s) return s.error();
    } else if (layers && !shape.cue && !shape.fill && shape.stroke) {
      finder.add_likely(shape, found);
    }
  }
  return found;
}

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
      std::vector<Point2> line = closed_up(polyline);
      if (line.size() >= 2) found.cues.push_back({*part, *kind, std::move(line), *value});
    }
    found.elements.push_back(shape.element);
  }
  return found;
}

}  // namespace relievo
