#include "io/svg/drawing_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/svg/basic_shapes.h"
#include "io/svg/clip_reader.h"
#include "io/svg/path_data.h"
#include "io/svg/picture_reader.h"
#include "io/svg/svg_region.h"
#include "io/svg/svg_transform.h"
#include "io/svg/svg_viewport.h"

namespace relievo {
namespace {

/// Largest coordinate from which regions can be computed, px.
constexpr double farthest = 1e9;

bool all_in_reach(const std::vector<Polyline>& lines) {
  return std::all_of(lines.begin(), lines.end(), [](const Polyline& line) {
    return std::all_of(line.points.begin(), line.points.end(), [](Point2 p) {
      return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest;
    });
  });
}

/// Returns the map of a space in which the pen is round, of the same mean scale; nothing where it
/// is round on the canvas, or so thin there that its mean has to do.
std::optional<Affine2> pen_frame(const Affine2& m) {
  constexpr double most_stretch = 100;
  const double scale = m.mean_scale();
  const double x = std::hypot(m.a, m.b) / scale;
  const double y = std::hypot(m.c, m.d) / scale;
  const double shear = (m.a * m.c + m.b * m.d) / (scale * scale);
  const bool is_round = std::abs(x - y) + std::abs(shear) < 1e-6;
  if (is_round || !(x < most_stretch) || !(y < most_stretch)) return std::nullopt;
  return Affine2{m.a / scale, m.b / scale, m.c / scale, m.d / scale, 0, 0};
}

void set_paint(const InheritedState& around, const SvgDocument& document, SvgShape& shape) {
  const SvgStyle& style = around.style;
  shape.fill_rule = around.in_clip ? style.clip_rule : style.fill_rule;
  shape.fill = representative_color(style.fill, document);
  if (shape.fill) shape.fill->a *= style.fill_opacity * around.opacity;
  shape.pen = {style.stroke_width * around.to_canvas.mean_scale(), style.cap, style.join,
               style.miter_limit};
  shape.pen_frame = pen_frame(around.to_canvas);
  if (shape.pen.width > 0) shape.stroke = representative_color(style.stroke, document);
  if (shape.stroke) shape.stroke->a *= style.stroke_opacity * around.opacity;
}

void read_element(const pugi::xml_node& element, const InheritedState& outside, Reading& reading);

/// Notes where an element that blends or isolates begins.
void enter_blending(InheritedState& around, size_t shapes_before) {
  if (around.style.blends) {
    if (around.backdrop.begin == around.backdrop.end) around.backdrop.begin = around.isolated;
    around.backdrop.end = shapes_before;
  }
  if (around.style.isolates) around.isolated = shapes_before;
}

/// Applies the element's style, transform and clip to `around`; returns false where it is not
/// drawn.
bool enter(const pugi::xml_node& element, InheritedState& around, Reading& reading) {
  if (++reading.elements > reading.options.max_elements)
    reading.fail("has too many elements", reading.options.max_elements);
  if (++around.depth > reading.options.max_depth)
    reading.fail("has elements nested too deeply", reading.options.max_depth);
  if (reading.error) return false;
  around.style = computed_style(element, around.style, around.lengths);
  if (!around.style.displayed) return false;
  around.lengths.font_size = around.style.font_size;
  around.opacity *= around.style.opacity;
  const auto transform = parse_transform(element.attribute("transform").value());
  if (transform) around.to_canvas = around.to_canvas * *transform;
  // A clip path or mask of a <use> moves with it.
  if (local_name(element.name()) == "use")
    around.to_canvas = around.to_canvas * placement_of(element, around.lengths);
  enter_clips(around, reading);
  enter_blending(around, reading.drawing.shapes.size());
  around.blurred = around.blurred || is_blur(reading.document, around.style.filter);
  return true;
}

/// Enters the viewport of a nested <svg> or a used <symbol>, whose size `sized` may override;
/// returns false where it has no area.
bool enter_nested(const pugi::xml_node& element, const pugi::xml_node& sized,
                  InheritedState& around, Reading& reading) {
  const RootSize size = viewport_of(element, sized, around.lengths);
  if (!(size.width > 0) || !(size.height > 0)) return false;
  around.to_canvas = around.to_canvas * placement_of(element, around.lengths);
  if (around.style.clips_overflow)
    add_clip(fill_region({rectangle_line({{0, 0}, {size.width, size.height}}, around.to_canvas)},
                         FillRule::nonzero, reading.drawing.canvas()),
             around, reading);
  around.to_canvas = around.to_canvas * enter_viewport(element, size, around.lengths);
  return true;
}

void add_group(const pugi::xml_node& element, bool layer, InheritedState& around,
               Reading& reading) {
  const std::string_view text = element.attribute("data-relievo").value();
  const SvgMark mark = svg_mark(element);
  if (!text.empty() && mark == SvgMark::none)
    reading.warn("data-relievo=\"" + std::string(text) +
                 "\" is ignored: it must be part, texture, ignore, join or cue");
  reading.drawing.groups.push_back({around.group, element, mark, layer});
  around.group = static_cast<int>(reading.drawing.groups.size()) - 1;
}

void enter_group(const pugi::xml_node& element, bool group_element, InheritedState& around,
                 Reading& reading) {
  if (!group_element && !has_annotation(element)) return;
  const bool layer = std::string_view(element.attribute("inkscape:groupmode").value()) == "layer";
  add_group(element, layer, around, reading);
}

/// Reads the name and lines of a shape; returns false where it has no usable lines.
bool read_lines(const pugi::xml_node& element, const InheritedState& around, SvgShape& shape,
                Reading& reading) {
  bool complete = true;
  const PathData path = shape_path(element, around.lengths, complete);
  if (path.empty()) return false;
  for (const PathSegment& s : path)
    if (s.kind == SegmentKind::cubic && local_name(element.name()) == "path")
      shape.anchors.push_back(around.to_canvas(s.end));
  shape.name = name_of(element);
  const std::string label = shape.name.empty() ? "a shape" : "shape " + shape.name;
  if (!complete) reading.warn(label + ": its path data has an error and is used up to there");
  const size_t room =
      reading.options.max_points - std::min(reading.points, reading.options.max_points);
  shape.lines = flatten(path, around.to_canvas, reading.options.tolerance, room);
  for (const Polyline& line : shape.lines) reading.points += line.points.size();
  if (reading.points > reading.options.max_points) {
    reading.fail("has too many points; simplify its paths", reading.options.max_points);
    return false;
  }
  const bool in_reach = all_in_reach(shape.lines);
  const double tangled = in_reach ? tangle(shape.lines) : 0;
  const bool usable = in_reach && tangled <= reading.options.max_tangle;
  if (!usable)
    reading.warn(label + " is ignored: " +
                 (in_reach ? "its outline crosses itself too often; simplify it"
                           : "it lies too far from the canvas"));
  else
    reading.tangle += tangled;
  if (reading.tangle > reading.options.max_total_tangle)
    reading.fail("has outlines that cross themselves too often; simplify them",
                 static_cast<size_t>(reading.options.max_total_tangle));
  return usable && !reading.error;
}

/// Adds a shape with all that its element and surroundings say of it.
void add_shape(const pugi::xml_node& element, SvgShape shape, InheritedState& around,
               Reading& reading) {
  shape.clips = around.clips;
  shape.backdrop = around.backdrop;
  shape.blurred = around.blurred;
  shape.element = element;
  if (element.attribute("data-relievo") || has_annotation(element))
    add_group(element, false, around, reading);
  shape.group = around.group;
  reading.drawing.shapes.push_back(std::move(shape));
}

void read_shape(const pugi::xml_node& element, InheritedState& around, Reading& reading) {
  SvgShape shape;
  const SvgMark mark = svg_mark(element);
  const std::string_view cue = trimmed_svg(element.attribute("data-cue").value());
  shape.join = mark == SvgMark::join || has_join_class(element);
  shape.cue = !shape.join && (mark == SvgMark::cue || !cue.empty() || has_cue_class(element));
  if (!around.style.visible && !shape.is_note()) return;
  if (!read_lines(element, around, shape, reading)) return;
  set_paint(around, reading.document, shape);
  fill_with_picture(element, around, shape, reading);
  add_shape(element, std::move(shape), around, reading);
}

void read_picture(const pugi::xml_node& element, InheritedState& around, Reading& reading) {
  std::optional<SvgShape> shape = picture_shape(element, around, reading);
  if (!shape) return;
  shape->name = name_of(element);
  add_shape(element, std::move(*shape), around, reading);
}

void read_switch(const pugi::xml_node& element, const InheritedState& around, Reading& reading) {
  for (const pugi::xml_node& child : element.children()) {
    if (!switch_allows(child)) continue;
    return read_element(child, around, reading);
  }
}

void read_use(const pugi::xml_node& element, InheritedState& around, Reading& reading) {
  const pugi::xml_node target = referenced_element(reading.document, element);
  if (!target) return reading.warn("a reference to a missing element or another file is ignored");
  if (!reading.begin_reference(target)) return;
  const std::string_view name = local_name(target.name());
  if (name == "symbol" || name == "svg") {
    if (enter(target, around, reading) && enter_nested(target, element, around, reading)) {
      read_children(target, around, reading);
    }
  } else {
    read_element(target, around, reading);
  }
  reading.open_references.pop_back();
}

void read_element(const pugi::xml_node& element, const InheritedState& outside, Reading& reading) {
  const std::string_view name = local_name(element.name());
  const bool shape = is_shape_element(name);
  const bool picture = name == "image" && !outside.in_clip;
  if (!shape && !picture && name != "use" && (!is_container(name) || outside.in_clip)) {
    if (name == "text")
      reading.warn(reading.whereabouts(element, outside) +
                   " is text and becomes no part: convert it to paths");
    return;
  }
  InheritedState around = outside;
  if (!enter(element, around, reading)) return;
  if (picture) return read_picture(element, around, reading);
  if (shape) return read_shape(element, around, reading);
  enter_group(element, name == "g", around, reading);
  if (name == "use") return read_use(element, around, reading);
  if (name == "switch") return read_switch(element, around, reading);
  if (name == "svg" && !enter_nested(element, element, around, reading)) return;
  read_children(element, around, reading);
}

/// Reads the tree in paint order, on a canvas as large as the scaled viewport of the root.
Result<SvgDrawing> read_tree(const SvgDocument& document, const SvgOptions& options, RootSize size,
                             double scale) {
  Reading reading{document, options};
  SvgDrawing& drawing = reading.drawing;
  drawing.width = scale * size.width;
  drawing.height = scale * size.height;
  drawing.px_width = size.width;
  drawing.px_height = size.height;
  drawing.warnings = document.warnings;
  const pugi::xml_node& root = document.root;
  InheritedState around;
  around.to_canvas = scaling(drawing.width / size.width, drawing.height / size.height);
  around.lengths = {16, size.width, size.height};
  around.to_canvas = around.to_canvas * enter_viewport(root, size, around.lengths);
  around.style = computed_style(root, {}, around.lengths);
  around.opacity = around.style.opacity;
  enter_clips(around, reading);
  if (around.style.displayed) read_children(root, around, reading);
  if (reading.error) return *reading.error;
  return std::move(drawing);
}

/// Returns the right and bottom of all shapes from the origin of user units.
Result<RootSize> extent(const SvgDocument& document, const SvgOptions& options) {
  const auto drawing = read_tree(document, options, {1, 1}, 1);
  if (!drawing) return drawing.error();
  Box2 box;
  for (const SvgShape& shape : drawing->shapes) {
    for (const Polyline& line : shape.lines) box.add(bounding_box(line.points));
  }
  if (!(box.max.x > 0) || !(box.max.y > 0)) return RootSize{300, 150};
  return RootSize{box.max.x, box.max.y};
}

}  // namespace

void read_children(const pugi::xml_node& parent, const InheritedState& around, Reading& reading) {
  for (const pugi::xml_node& child : parent.children()) {
    if (reading.error) return;
    if (child.type() == pugi::node_element) read_element(child, around, reading);
  }
}

Result<SvgDrawing> read_drawing(const SvgDocument& document, const SvgOptions& options) {
  auto size = root_size(document.root);
  if (!size) {
    const auto measured = extent(document, options);
    if (!measured) return measured.error();
    size = measured.value();
  }
  const double longest = std::max(size->width, size->height);
  if (!std::isfinite(longest) || !(std::min(size->width, size->height) * 1000 > longest)) {
    return Error{ErrorCode::bad_input, "is more than 1000 times as long as wide; crop its page",
                 "svg"};
  }
  const bool keep = longest >= options.min_side && longest <= options.max_side;
  return read_tree(document, options, *size, keep ? 1 : options.scaled_side / longest);
}

}  // namespace relievo
