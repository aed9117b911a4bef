#include "io/svg/annotations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "io/svg/svg_values.h"
#include "kernel/geometry/polyline.h"
#include "kernel/geometry/region.h"
#include "scene/part_ids.h"

namespace relievo {
namespace {

/// Least width of a stroke without a fill that is a shape of its own / diagonal of the canvas.
constexpr double wide_stroke = 0.02;

bool is_part_group(const SvgGroup& group, bool layers) {
  return group.mark == SvgMark::part || has_part_values(group.element) || (layers && group.layer);
}

int owner_of(const SvgDrawing& drawing, int group, bool layers) {
  while (group >= 0 && !is_part_group(drawing.groups[group], layers)) {
    group = drawing.groups[group].parent;
  }
  return group;
}

Region silhouette(const SvgShape& shape, const SvgDrawing& drawing) {
  if (is_paint(shape, drawing)) return {};
  const bool filled = shape.fill && shape.fill->a > faint_alpha;
  const bool stroked = shape.stroke && shape.stroke->a > faint_alpha;
  const bool wide = shape.pen.width > wide_stroke * drawing.canvas().diagonal();
  const Region stroke = stroked && (filled || wide) ? stroke_of(shape, drawing) : Region();
  return filled ? unite(fill_of(shape, drawing), stroke) : stroke;
}

std::string part_id(const SvgGroup& group) {
  std::string id = group.value("id");
  std::string label = group.value("inkscape:label");
  const bool by_id = !group.layer || label.empty();
  return by_id && !id.empty() ? id : label;
}

/// Reads a finite number and nothing else.
std::optional<double> number_of(const std::string& text) {
  SvgScanner scanner(trimmed_svg(text));
  const auto number = scanner.number();
  return number && scanner.at_end() && std::isfinite(*number) ? number : std::nullopt;
}

/// Sets `value` from an attribute, where it is given.
Status set_number(double& value, const SvgGroup& group, const char* name, const std::string& part) {
  const std::string text = group.value(name);
  if (text.empty()) return Done{};
  const auto number = number_of(text);
  if (!number) return Error{ErrorCode::bad_input, std::string(name) + " must be a number", part};
  value = *number;
  return Done{};
}

Status set_lean(Point2& lean, const std::string& text, const std::string& part) {
  if (text.empty()) return Done{};
  SvgScanner scanner(trimmed_svg(text));
  const auto x = scanner.number();
  scanner.skip_separator();
  const auto y = scanner.number();
  if (!x || !y || !scanner.at_end() || !(std::abs(*x) <= max_lean && std::abs(*y) <= max_lean))
    return Error{ErrorCode::bad_input, "data-lean must be two numbers from -2 to 2", part};
  lean = {*x, *y};
  return Done{};
}

Status set_values(Part& part, const SvgGroup& group) {
  if (const Status s = set_number(part.c, group, "data-c", part.id); !s) return s.error();
  if (const Status s = set_number(part.d, group, "data-d", part.id); !s) return s.error();
  if (const Status s = set_number(part.flat, group, "data-flat", part.id); !s) return s.error();
  if (const Status s = set_lean(part.lean, group.value("data-lean"), part.id); !s) return s.error();
  const auto wrong = [&](const char* message) {
    return Error{ErrorCode::bad_input, message, part.id};
  };
  if (part.c <= 0) return wrong("data-c must be above 0");
  if (part.d == 0) return wrong("data-d must not be 0");
  if (part.flat < 0 || part.flat > 1) return wrong("data-flat must lie between 0 and 1");
  return Done{};
}

/// Returns the one of the kinds that has this name.
template <class Kind>
std::optional<Kind> kind_named(std::string_view text, std::initializer_list<Kind> kinds) {
  for (const Kind kind : kinds)
    if (text == name(kind)) return kind;
  return std::nullopt;
}

/// Returns the shapes of each part group, with the group's index; groups are in the order of their
/// first shape. A mark's colour is that of its fill, or of its stroke where it has no fill.
std::vector<std::vector<understanding::Mark>> owned_shapes(const SvgDrawing& drawing, bool layers) {
  std::vector<std::vector<understanding::Mark>> owned;
  std::map<int, size_t> place;
  for (const SvgShape& shape : drawing.shapes) {
    const int owner = owner_of(drawing, shape.group, layers);
    if (owner < 0 || shape.is_note()) continue;
    if (inherited_mark(drawing, shape.group) >= SvgMark::texture) continue;
    understanding::Mark mark;
    mark.group = owner;
    mark.region = silhouette(shape, drawing);
    if (mark.region.empty()) continue;
    mark.color = shape.fill ? *shape.fill : *shape.stroke;
    const auto [at, fresh] = place.emplace(owner, owned.size());
    if (fresh) owned.emplace_back();
    owned[at->second].push_back(std::move(mark));
  }
  return owned;
}

/// Returns the colours that show on at least a tenth of the shapes' area, the most frequent first.
Palette palette_of(const std::vector<understanding::Mark>& shapes) {
  Region above;
  std::vector<std::pair<double, std::array<double, 3>>> seen;
  for (size_t i = shapes.size(); i-- > 0;) {
    const Color& c = shapes[i].color;
    const std::array<double, 3> color{c.r, c.g, c.b};
    const double own = area(subtract(shapes[i].region, above));
    above = unite(above, shapes[i].region);
    const auto same = std::find_if(seen.begin(), seen.end(),
                                   [&](const auto& entry) { return entry.second == color; });
    if (same == seen.end()) {
      seen.emplace_back(own, color);
    } else {
      same->first += own;
    }
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  Palette palette;
  for (const auto& [own, color] : seen)
    if (palette.empty() || own > 0.1 * area(above)) palette.push_back(color);
  return palette;
}

/// Returns the part that holds the group, or -1.
int enclosing_part(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts, int group) {
  for (; group >= 0; group = drawing.groups[group].parent) {
    for (size_t k = 0; k < parts.size(); ++k) {
      if (parts[k].group == group) return static_cast<int>(k);
    }
  }
  return -1;
}

/// Returns the part whose id, or whose group's id or label, is `name`; `otherwise` for an empty
/// name. Errors: `bad_input` at `where` where there is no such part.
Result<int> part_named(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                       const std::string& name, int otherwise, const std::string& where) {
  if (name.empty()) return otherwise;
  for (size_t k = 0; k < parts.size(); ++k) {
    const SvgGroup& group = drawing.groups[parts[k].group];
    if (name == parts[k].part.id || name == group.value("id") ||
        name == group.value("inkscape:label"))
      return static_cast<int>(k);
  }
  return Error{ErrorCode::bad_input, "no part has the id or label \"" + name + "\"", where};
}

/// Largest distance of a line in a layer from the outline that it follows / diagonal of the canvas.
constexpr double near_outline = 0.015;

double distance_to_outline(Point2 p, const Outline& outline) {
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& ring : outline)
    least = std::min(least, nearest_on_ring(ring, measure(ring), p).distance);
  return least;
}

/// Returns the fraction of the line's length inside the outline.
double fraction_inside(const std::vector<Point2>& line, const Outline& outline) {
  double inside = 0;
  for (const LineSpan& span : spans_inside(line, outline)) inside += span.to - span.from;
  const double length = line_length(line);
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
  const auto kind = kind_named(trimmed_svg(shape.element.attribute("data-cue").value()),
                               {CueKind::bulge, CueKind::slope, CueKind::crease});
  if (kind) return *kind;
  return Error{ErrorCode::bad_input, "data-cue must be bulge, slope or crease", where};
}

Result<double> value_of(const SvgShape& shape, CueKind kind, const std::string& where) {
  const auto value = number_of(shape.element.attribute("data-value").value());
  if (value && has_sound_value({0, kind, {}, *value})) return *value;
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

Result<std::vector<AnnotatedPart>> annotated_parts(const SvgDrawing& drawing, bool layers) {
  std::vector<Part> parts;
  std::vector<AnnotatedPart> result;
  for (const std::vector<understanding::Mark>& shapes : owned_shapes(drawing, layers)) {
    const int group = shapes.front().group;
    std::vector<Region> regions;
    for (const understanding::Mark& shape : shapes) regions.push_back(shape.region);
    Part part{part_id(drawing.groups[group]), tidied(unite(regions), 0.1, 4)};
    if (part.outline.empty()) continue;
    if (const Status s = set_values(part, drawing.groups[group]); !s) return s.error();
    parts.push_back(std::move(part));
    result.push_back({group, {}, palette_of(shapes)});
  }
  make_ids_unique(parts);
  for (size_t k = 0; k < parts.size(); ++k) result[k].part = std::move(parts[k]);
  return result;
}

Result<std::vector<Relation>> annotated_relations(const SvgDrawing& drawing,
                                                  const std::vector<AnnotatedPart>& parts) {
  std::vector<Relation> relations;
  for (size_t upper = 0; upper < parts.size(); ++upper) {
    const std::string text = drawing.groups[parts[upper].group].value("data-relation");
    if (text.empty()) continue;
    const auto kind =
        kind_named(text, {RelationKind::equal, RelationKind::above, RelationKind::free});
    if (!kind)
      return Error{ErrorCode::bad_input, "data-relation must be equal, above or free",
                   parts[upper].part.id};
    for (size_t lower = 0; lower < upper; ++lower) {
      const Region common = intersect(parts[upper].part.outline, parts[lower].part.outline);
      if (area(common) < 1) continue;
      relations.push_back({static_cast<int>(upper), static_cast<int>(lower), *kind, {}});
    }
  }
  return relations;
}

std::vector<std::vector<understanding::Mark>> marks_by_layer(const SvgDrawing& drawing) {
  std::map<int, std::vector<const SvgShape*>> by_layer;
  for (const SvgShape& shape : drawing.shapes) {
    const int owner = owner_of(drawing, shape.group, true);
    if (owner >= 0 && !silhouette(shape, drawing).empty()) by_layer[owner].push_back(&shape);
  }
  std::vector<std::vector<understanding::Mark>> layers;
  for (const auto& [owner, shapes] : by_layer) layers.push_back(opaque_marks(drawing, shapes));
  return layers;
}

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
