#include <algorithm>
#include <cmath>
#include <utility>

#include "io/svg/basic_shapes.h"
#include "io/svg/path_data.h"
#include "io/svg/svg_document.h"
#include "io/svg/svg_drawing.h"
#include "io/svg/svg_region.h"
#include "io/svg/svg_style.h"
#include "io/svg/svg_values.h"

namespace relievo {
namespace {

/// The state that an element inherits.
struct Surroundings {
  Affine2 to_canvas;
  SvgStyle style;
  LengthContext lengths;
  double opacity = 1;
  std::vector<int> clips;
  bool blurred = false;
  int group = -1;
  size_t depth = 0;
  bool in_clip = false;
};

/// Largest coordinate from which regions can be computed, px.
constexpr double farthest = 1e9;

bool all_in_reach(const std::vector<Polyline>& lines) {
  return std::all_of(lines.begin(), lines.end(), [](const Polyline& line) {
    return std::all_of(line.points.begin(), line.points.end(), [](Point2 p) {
      return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest;
    });
  });
}

void enter_view_box(const pugi::xml_node& element, RootSize size, Surroundings& around) {
  const auto box = parse_view_box(element.attribute("viewBox").value());
  if (!box) return;
  around.to_canvas =
      around.to_canvas *
      fit_view_box(*box, size.width, size.height, element.attribute("preserveAspectRatio").value());
  around.lengths.viewport_width = box->width;
  around.lengths.viewport_height = box->height;
}

/// Returns the size of a nested <svg> or a used <symbol>, which `sized` may override.
RootSize viewport_of(const pugi::xml_node& element, const pugi::xml_node& sized,
                     const LengthContext& lengths) {
  const auto size = [&](const char* name, LengthAxis axis) {
    pugi::xml_attribute attribute = sized.attribute(name);
    if (!attribute) attribute = element.attribute(name);
    return parse_length(attribute.value(), axis, lengths).value_or(reference_length(axis, lengths));
  };
  return {size("width", LengthAxis::horizontal), size("height", LengthAxis::vertical)};
}

/// Returns the translation by the element's x and y.
Affine2 placement_of(const pugi::xml_node& element, const LengthContext& lengths) {
  const auto at = [&](const char* name, LengthAxis axis) {
    return parse_length(element.attribute(name).value(), axis, lengths).value_or(0);
  };
  return translation(at("x", LengthAxis::horizontal), at("y", LengthAxis::vertical));
}

/// Returns the name of an element for warnings.
std::string whereabouts(const pugi::xml_node& element, const Surroundings& around,
                        const SvgDrawing& drawing) {
  const std::string name = name_of(element);
  const std::string layer = inherited_name(drawing, around.group);
  return std::string(local_name(element.name())) + (name.empty() ? "" : " " + name) +
         (layer.empty() ? "" : " in " + layer);
}

void set_paint(const Surroundings& around, const SvgDocument& document, SvgShape& shape) {
  const SvgStyle& style = around.style;
  shape.fill_rule = around.in_clip ? style.clip_rule : style.fill_rule;
  shape.fill = representative_color(style.fill, document);
  if (shape.fill) shape.fill->a *= style.fill_opacity * around.opacity;
  shape.pen = {style.stroke_width * around.to_canvas.mean_scale(), style.cap, style.join,
               style.miter_limit};
  if (shape.pen.width > 0) shape.stroke = representative_color(style.stroke, document);
  if (shape.stroke) shape.stroke->a *= style.stroke_opacity * around.opacity;
}

/// The state of reading a document.
struct Reading {
  const SvgDocument& document;
  const SvgOptions& options;
  SvgDrawing drawing = {};
  std::vector<pugi::xml_node> open_references = {};
  size_t elements = 0;
  size_t points = 0;
  double tangle = 0;
  std::optional<Error> error = {};

  void warn(const std::string& text) {
    auto& list = drawing.warnings;
    if (std::find(list.begin(), list.end(), text) == list.end() && list.size() < 100)
      list.push_back(text);
  }

  void fail(const std::string& what, size_t limit) {
    if (!error)
      error = Error{ErrorCode::limit, what + " (limit " + std::to_string(limit) + ")", "svg"};
  }
};

void read_element(const pugi::xml_node& element, const Surroundings& outside, Reading& reading);

void read_children(const pugi::xml_node& parent, const Surroundings& around, Reading& reading) {
  for (const pugi::xml_node& child : parent.children()) {
    if (reading.error) return;
    if (child.type() == pugi::node_element) read_element(child, around, reading);
  }
}

/// Opens a reference; returns false where it is open already, since it leads back to itself.
bool begin_reference(const pugi::xml_node& target, Reading& reading) {
  if (std::find(reading.open_references.begin(), reading.open_references.end(), target) !=
      reading.open_references.end()) {
    reading.warn("an element that uses itself is ignored");
    return false;
  }
  reading.open_references.push_back(target);
  return true;
}

/// Closes an open reference and returns its shapes, which the drawing itself does not show.
std::vector<SvgShape> shapes_apart(const pugi::xml_node& parent, const Surroundings& inside,
                                   Reading& reading) {
  const size_t groups = reading.drawing.groups.size();
  std::vector<SvgShape> shapes = std::exchange(reading.drawing.shapes, {});
  read_children(parent, inside, reading);
  std::swap(shapes, reading.drawing.shapes);
  reading.drawing.groups.resize(groups);
  reading.open_references.pop_back();
  return shapes;
}

void add_clip(Region region, Surroundings& around, Reading& reading) {
  reading.drawing.clips.push_back(std::move(region));
  around.clips.push_back(static_cast<int>(reading.drawing.clips.size()) - 1);
}

void enter_clip(Surroundings& around, Reading& reading) {
  const auto found = reading.document.ids.find(around.style.clip_path);
  if (found == reading.document.ids.end() || local_name(found->second.name()) != "clipPath") return;
  const pugi::xml_node& clip = found->second;
  if (std::string_view(clip.attribute("clipPathUnits").value()) == "objectBoundingBox") {
    return reading.warn("clip paths with objectBoundingBox units are ignored");
  }
  if (!begin_reference(clip, reading)) return;
  Surroundings inside = around;
  inside.in_clip = true;
  inside.clips.clear();
  inside.style = {};
  const auto transform = parse_transform(clip.attribute("transform").value());
  if (transform) inside.to_canvas = inside.to_canvas * *transform;
  std::vector<Region> regions;
  for (const SvgShape& shape : shapes_apart(clip, inside, reading))
    regions.push_back(fill_of(shape, reading.drawing));
  add_clip(unite(regions), around, reading);
}

void enter_mask(const pugi::xml_node& element, Surroundings& around, Reading& reading) {
  const auto found = reading.document.ids.find(around.style.mask);
  if (found == reading.document.ids.end() || local_name(found->second.name()) != "mask") return;
  const pugi::xml_node& mask = found->second;
  if (std::string_view(mask.attribute("maskContentUnits").value()) == "objectBoundingBox")
    return reading.warn(whereabouts(element, around, reading.drawing) +
                        ": its mask with objectBoundingBox units is ignored");
  if (!begin_reference(mask, reading)) return;
  Surroundings inside = around;
  inside.clips.clear();
  inside.style = {};
  inside.opacity = 1;
  add_clip(light_region(shapes_apart(mask, inside, reading), reading.drawing), around, reading);
}

/// Applies the element's style, transform and clip to `around`; returns false where it is not
/// drawn.
bool enter(const pugi::xml_node& element, Surroundings& around, Reading& reading) {
  if (++reading.elements > reading.options.max_elements)
    reading.fail("has too many elements", reading.options.max_elements);
  if (++around.depth > reading.options.max_depth)
    reading.fail("has elements nested too deeply", reading.options.max_depth);
  if (reading.error) return false;
  around.style = computed_style(element, reading.document.sheet, around.style, around.lengths);
  if (!around.style.displayed) return false;
  around.lengths.font_size = around.style.font_size;
  around.opacity *= around.style.opacity;
  const std::string own = element.attribute("transform").value();
  const auto transform = parse_transform(around.style.transform.value_or(own));
  if (transform) around.to_canvas = around.to_canvas * *transform;
  if (!transform) reading.warn("an unreadable transform is ignored");
  if (!around.style.clip_path.empty()) enter_clip(around, reading);
  if (!around.style.mask.empty()) enter_mask(element, around, reading);
  around.blurred = around.blurred || is_blur(reading.document, around.style.filter);
  return true;
}

void clip_to_viewport(RootSize size, Surroundings& around, Reading& reading) {
  const Affine2& map = around.to_canvas;
  const Polyline box{
      {map({0, 0}), map({size.width, 0}), map({size.width, size.height}), map({0, size.height})},
      true};
  add_clip(fill_region({box}, FillRule::nonzero, reading.drawing.canvas()), around, reading);
}

/// Enters the viewport of a nested <svg> or a used <symbol>, whose size `sized` may override;
/// returns false where it has no area.
bool enter_nested(const pugi::xml_node& element, const pugi::xml_node& sized, Surroundings& around,
                  Reading& reading) {
  const RootSize size = viewport_of(element, sized, around.lengths);
  if (!(size.width > 0) || !(size.height > 0)) return false;
  around.to_canvas = around.to_canvas * placement_of(element, around.lengths);
  if (around.style.clips_overflow) clip_to_viewport(size, around, reading);
  around.lengths.viewport_width = size.width;
  around.lengths.viewport_height = size.height;
  enter_view_box(element, size, around);
  return true;
}

void add_group(const pugi::xml_node& element, bool layer, Surroundings& around, Reading& reading) {
  const std::string_view text = element.attribute("data-relievo").value();
  const SvgMark mark = svg_mark(element);
  if (!text.empty() && mark == SvgMark::none)
    reading.warn("data-relievo=\"" + std::string(text) +
                 "\" is ignored: it must be part, texture, ignore, join or cue");
  reading.drawing.groups.push_back({around.group, element, mark, layer});
  around.group = static_cast<int>(reading.drawing.groups.size()) - 1;
}

void enter_group(const pugi::xml_node& element, bool group_element, Surroundings& around,
                 Reading& reading) {
  if (!group_element && !has_annotation(element)) return;
  const bool layer = std::string_view(element.attribute("inkscape:groupmode").value()) == "layer";
  add_group(element, layer, around, reading);
}

/// Reads the name and lines of a shape; returns false where it has no usable lines.
bool read_lines(const pugi::xml_node& element, const Surroundings& around, SvgShape& shape,
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

void read_shape(const pugi::xml_node& element, Surroundings& around, Reading& reading) {
  SvgShape shape;
  const SvgMark mark = svg_mark(element);
  const std::string_view cue = trimmed_svg(element.attribute("data-cue").value());
  shape.join = mark == SvgMark::join || has_join_class(element);
  shape.cue = !shape.join && (mark == SvgMark::cue || !cue.empty() || has_cue_class(element));
  if (!around.style.visible && !shape.is_note()) return;
  if (!read_lines(element, around, shape, reading)) return;
  set_paint(around, reading.document, shape);
  shape.clips = around.clips;
  shape.blurred = around.blurred;
  shape.element = element;
  if (element.attribute("data-relievo") || has_annotation(element))
    add_group(element, false, around, reading);
  shape.group = around.group;
  reading.drawing.shapes.push_back(std::move(shape));
}

void read_switch(const pugi::xml_node& element, const Surroundings& around, Reading& reading) {
  for (const pugi::xml_node& child : element.children()) {
    if (!switch_allows(child)) continue;
    return read_element(child, around, reading);
  }
}

void read_use(const pugi::xml_node& element, Surroundings& around, Reading& reading) {
  const pugi::xml_node target = referenced_element(reading.document, element);
  if (!target) return reading.warn("a reference to a missing element or another file is ignored");
  if (!begin_reference(target, reading)) return;
  around.to_canvas = around.to_canvas * placement_of(element, around.lengths);
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

void read_element(const pugi::xml_node& element, const Surroundings& outside, Reading& reading) {
  const std::string_view name = local_name(element.name());
  const bool shape = is_shape_element(name);
  if (!shape && name != "use" && (!is_container(name) || outside.in_clip)) {
    if (name == "text")
      reading.warn(whereabouts(element, outside, reading.drawing) +
                   " is text and becomes no part: convert it to paths");
    if (name == "image")
      reading.warn(
          whereabouts(element, outside, reading.drawing) +
          " is a picture and becomes no part: make it a layer of its own, or find its parts "
          "with: relievo segment");
    return;
  }
  Surroundings around = outside;
  if (!enter(element, around, reading)) return;
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
  Surroundings around;
  around.to_canvas = scaling(drawing.width / size.width, drawing.height / size.height);
  around.lengths = {16, size.width, size.height};
  enter_view_box(root, size, around);
  around.style = computed_style(root, document.sheet, {}, around.lengths);
  around.opacity = around.style.opacity;
  if (!around.style.clip_path.empty()) enter_clip(around, reading);
  if (!around.style.mask.empty()) enter_mask(root, around, reading);
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
