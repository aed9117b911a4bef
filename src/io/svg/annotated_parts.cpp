#include "io/svg/annotated_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/svg/scanner.h"
#include "io/svg/svg_drawing.h"
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

/// Sets `value` from an attribute, where it is given.
Status set_number(double& value, const SvgGroup& group, const char* name, const std::string& part) {
  const std::string text = group.value(name);
  if (text.empty()) return Done{};
  SvgScanner scanner(trimmed_svg(text));
  const auto number = scanner.number();
  if (!number || !scanner.at_end() || !std::isfinite(*number)) {
    return Error{ErrorCode::bad_input, std::string(name) + " must be a number", part};
  }
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
    RelationKind kind = RelationKind::free;
    if (text == "equal") {
      kind = RelationKind::equal;
    } else if (text == "above") {
      kind = RelationKind::above;
    } else if (text != "free") {
      return Error{ErrorCode::bad_input, "data-relation must be equal, above or free",
                   parts[upper].part.id};
    }
    for (size_t lower = 0; lower < upper; ++lower) {
      const Region common = intersect(parts[upper].part.outline, parts[lower].part.outline);
      if (area(common) < 1) continue;
      relations.push_back({static_cast<int>(upper), static_cast<int>(lower), kind, {}});
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

int enclosing_part(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts, int group) {
  for (; group >= 0; group = drawing.groups[group].parent) {
    for (size_t k = 0; k < parts.size(); ++k) {
      if (parts[k].group == group) return static_cast<int>(k);
    }
  }
  return -1;
}

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

}  // namespace relievo
