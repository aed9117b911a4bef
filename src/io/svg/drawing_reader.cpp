#include <algorithm>
#include <cmath>
#include <utility>

#include "io/svg/basic_shapes.h"
#include "io/svg/svg_document.h"
#include "io/svg/svg_drawing.h"
#include "io/svg/svg_length.h"
#include "io/svg/svg_region.h"
#include "io/svg/svg_style.h"

namespace relievo {
namespace {

/// What an element inherits.
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

/// Farther points, px, are beyond what regions can be computed from.
constexpr double farthest = 1e9;

bool all_in_reach(const std::vector<Polyline>& lines) {
  return std::all_of(lines.begin(), lines.end(), [](const Polyline& line) {
    return std::all_of(line.points.begin(), line.points.end(), [](Point2 p) {
      return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest;
    });
  });
}

/// Walks the tree in paint order and appends what it finds to a drawing.
class DrawingReader {
 public:
  DrawingReader(const SvgDocument& document, const SvgOptions& options)
      : document_(document), options_(options) {}

  /// On a canvas as large as the viewport of the root, scaled.
  Result<SvgDrawing> read(RootSize size, double scale) {
    drawing_.width = scale * size.width;
    drawing_.height = scale * size.height;
    drawing_.px_width = size.width;
    drawing_.px_height = size.height;
    drawing_.warnings = document_.warnings;
    const pugi::xml_node& root = document_.root;
    Surroundings around;
    around.to_canvas = scaling(drawing_.width / size.width, drawing_.height / size.height);
    around.lengths = {16, size.width, size.height};
    enter_view_box(root, size.width, size.height, around);
    around.style = computed_style(root, document_.sheet, {}, around.lengths);
    around.opacity = around.style.opacity;
    if (!around.style.clip_path.empty()) enter_clip(around);
    if (!around.style.mask.empty()) enter_mask(root, around);
    if (around.style.displayed) read_children(root, around);
    if (error_) return *error_;
    return std::move(drawing_);
  }

 private:
  void warn(const std::string& text) {
    auto& list = drawing_.warnings;
    if (std::find(list.begin(), list.end(), text) == list.end() && list.size() < 100) {
      list.push_back(text);
    }
  }

  void fail(const std::string& what, size_t limit) {
    if (error_) return;
    error_ = Error{ErrorCode::limit, what + " (limit " + std::to_string(limit) + ")", "svg"};
  }

  static void enter_view_box(const pugi::xml_node& element, double width, double height,
                             Surroundings& around) {
    const auto box = parse_view_box(element.attribute("viewBox").value());
    if (!box) return;
    around.to_canvas =
        around.to_canvas *
        fit_view_box(*box, width, height, element.attribute("preserveAspectRatio").value());
    around.lengths.viewport_width = box->width;
    around.lengths.viewport_height = box->height;
  }

  void read_children(const pugi::xml_node& parent, const Surroundings& around) {
    for (const pugi::xml_node& child : parent.children()) {
      if (error_) return;
      if (child.type() == pugi::node_element) read_element(child, around);
    }
  }

  /// Style, transform and clip of the element on top of what surrounds it; false where nothing
  /// of it is drawn.
  bool enter(const pugi::xml_node& element, Surroundings& around) {
    if (++elements_ > options_.max_elements) fail("too many elements", options_.max_elements);
    if (++around.depth > options_.max_depth) fail("nested too deeply", options_.max_depth);
    if (error_) return false;
    around.style = computed_style(element, document_.sheet, around.style, around.lengths);
    if (!around.style.displayed) return false;
    around.lengths.font_size = around.style.font_size;
    around.opacity *= around.style.opacity;
    const std::string own = element.attribute("transform").value();
    const auto transform = parse_transform(around.style.transform.value_or(own));
    if (transform) around.to_canvas = around.to_canvas * *transform;
    if (!transform) warn("a transform that cannot be read is ignored");
    if (!around.style.clip_path.empty()) enter_clip(around);
    if (!around.style.mask.empty()) enter_mask(element, around);
    around.blurred = around.blurred || is_blur(document_, around.style.filter);
    return true;
  }

  void read_element(const pugi::xml_node& element, const Surroundings& outside) {
    const std::string_view name = local_name(element.name());
    const bool shape = is_shape_element(name);
    if (!shape && name != "use" && (!is_container(name) || outside.in_clip)) {
      if (name == "text")
        warn(whereabouts(element, outside) + " is text and becomes no part: convert it to paths");
      if (name == "image")
        warn(whereabouts(element, outside) +
             " is a picture and becomes no part: make it a layer of its own, or find its parts "
             "with: relievo segment");
      return;
    }
    Surroundings around = outside;
    if (!enter(element, around)) return;
    if (shape) return read_shape(element, around);
    enter_group(element, name == "g", around);
    if (name == "use") return read_use(element, around);
    if (name == "switch") return read_switch(element, around);
    if (name == "svg" && !enter_nested(element, element, around)) return;
    read_children(element, around);
  }

  void enter_group(const pugi::xml_node& element, bool group_element, Surroundings& around) {
    const SvgAnnotation annotation = annotation_of(element);
    if (!group_element && annotation.empty()) return;
    const bool layer = std::string_view(element.attribute("inkscape:groupmode").value()) == "layer";
    add_group(element, layer, annotation, around);
  }

  void add_group(const pugi::xml_node& element, bool layer, const SvgAnnotation& annotation,
                 Surroundings& around) {
    const std::string_view mark = element.attribute("data-relievo").value();
    if (!mark.empty() && annotation.mark == SvgMark::none) {
      warn("data-relievo=\"" + std::string(mark) + "\" is not known and ignored");
    }
    drawing_.groups.push_back({around.group, element.attribute("id").value(),
                               element.attribute("inkscape:label").value(), layer, annotation});
    around.group = static_cast<int>(drawing_.groups.size()) - 1;
  }

  void read_switch(const pugi::xml_node& element, const Surroundings& around) {
    for (const pugi::xml_node& child : element.children()) {
      if (!switch_allows(child)) continue;
      return read_element(child, around);
    }
  }

  /// Enters the viewport of a nested <svg> or a used <symbol>, whose size `sized` may override.
  bool enter_nested(const pugi::xml_node& element, const pugi::xml_node& sized,
                    Surroundings& around) {
    const auto size = [&](const char* name, LengthAxis axis) {
      pugi::xml_attribute attribute = sized.attribute(name);
      if (!attribute) attribute = element.attribute(name);
      const double whole = reference_length(axis, around.lengths);
      return parse_length(attribute.value(), axis, around.lengths).value_or(whole);
    };
    const double width = size("width", LengthAxis::horizontal);
    const double height = size("height", LengthAxis::vertical);
    if (!(width > 0) || !(height > 0)) return false;
    const auto at = [&](const char* name, LengthAxis axis) {
      return parse_length(element.attribute(name).value(), axis, around.lengths).value_or(0);
    };
    around.to_canvas = around.to_canvas *
                       translation(at("x", LengthAxis::horizontal), at("y", LengthAxis::vertical));
    if (around.style.clips_overflow) clip_to_viewport(width, height, around);
    around.lengths.viewport_width = width;
    around.lengths.viewport_height = height;
    enter_view_box(element, width, height, around);
    return true;
  }

  void clip_to_viewport(double width, double height, Surroundings& around) {
    const Affine2& map = around.to_canvas;
    const Polyline box{{map({0, 0}), map({width, 0}), map({width, height}), map({0, height})},
                       true};
    add_clip(fill_region({box}, FillRule::nonzero, drawing_.canvas()), around);
  }

  void add_clip(Region region, Surroundings& around) {
    drawing_.clips.push_back(std::move(region));
    around.clips.push_back(static_cast<int>(drawing_.clips.size()) - 1);
  }

  void enter_clip(Surroundings& around) {
    const auto found = document_.ids.find(around.style.clip_path);
    if (found == document_.ids.end() || local_name(found->second.name()) != "clipPath") return;
    const pugi::xml_node& clip = found->second;
    if (std::string_view(clip.attribute("clipPathUnits").value()) == "objectBoundingBox") {
      return warn("clip paths in units of the bounding box are ignored");
    }
    if (!begin_reference(clip)) return;
    Surroundings inside = around;
    inside.in_clip = true;
    inside.clips.clear();
    inside.style = {};
    const auto transform = parse_transform(clip.attribute("transform").value());
    if (transform) inside.to_canvas = inside.to_canvas * *transform;
    std::vector<SvgShape> shapes = std::exchange(drawing_.shapes, {});
    read_children(clip, inside);
    std::vector<Region> regions;
    for (const SvgShape& shape : drawing_.shapes) regions.push_back(fill_of(shape, drawing_));
    drawing_.shapes = std::move(shapes);
    open_references_.pop_back();
    add_clip(unite(regions), around);
  }

  /// An element as warnings name it.
  std::string whereabouts(const pugi::xml_node& element, const Surroundings& around) const {
    const std::string name = name_of(element);
    const std::string layer = inherited_name(drawing_, around.group);
    return std::string(local_name(element.name())) + (name.empty() ? "" : " " + name) +
           (layer.empty() ? "" : " in " + layer);
  }

  void enter_mask(const pugi::xml_node& element, Surroundings& around) {
    const auto found = document_.ids.find(around.style.mask);
    if (found == document_.ids.end() || local_name(found->second.name()) != "mask") return;
    const pugi::xml_node& mask = found->second;
    if (std::string_view(mask.attribute("maskContentUnits").value()) == "objectBoundingBox")
      return warn(whereabouts(element, around) +
                  ": a mask in units of the bounding box is ignored");
    if (!begin_reference(mask)) return;
    Surroundings inside = around;
    inside.clips.clear();
    inside.style = {};
    inside.opacity = 1;
    const size_t groups = drawing_.groups.size();
    std::vector<SvgShape> shapes = std::exchange(drawing_.shapes, {});
    read_children(mask, inside);
    std::swap(shapes, drawing_.shapes);
    drawing_.groups.resize(groups);
    open_references_.pop_back();
    add_clip(light_region(shapes, drawing_), around);
  }

  /// Guards against references that lead back to themselves.
  bool begin_reference(const pugi::xml_node& target) {
    if (std::find(open_references_.begin(), open_references_.end(), target) !=
        open_references_.end()) {
      warn("a reference to itself is ignored");
      return false;
    }
    open_references_.push_back(target);
    return true;
  }

  void read_use(const pugi::xml_node& element, Surroundings& around) {
    const pugi::xml_node target = referenced_element(document_, element);
    if (!target) return warn("a reference that is missing or outside the file is ignored");
    if (!begin_reference(target)) return;
    const auto at = [&](const char* name, LengthAxis axis) {
      return parse_length(element.attribute(name).value(), axis, around.lengths).value_or(0);
    };
    around.to_canvas = around.to_canvas *
                       translation(at("x", LengthAxis::horizontal), at("y", LengthAxis::vertical));
    const std::string_view name = local_name(target.name());
    if (name == "symbol" || name == "svg") {
      if (enter(target, around) && enter_nested(target, element, around)) {
        read_children(target, around);
      }
    } else {
      read_element(target, around);
    }
    open_references_.pop_back();
  }

  void read_shape(const pugi::xml_node& element, Surroundings& around) {
    SvgShape shape;
    shape.annotation = annotation_of(element);
    shape.join = shape.annotation.mark == SvgMark::join || has_join_class(element);
    shape.cue = !shape.join && (shape.annotation.mark == SvgMark::cue ||
                                !shape.annotation.cue.empty() || has_cue_class(element));
    if (!around.style.visible && !shape.is_note()) return;
    bool complete = true;
    const PathData path = shape_path(element, around.lengths, &complete);
    if (path.empty()) return;
    shape.name = name_of(element);
    const std::string label = shape.name.empty() ? "a shape" : "shape " + shape.name;
    if (!complete) warn(label + ": its data has an error and is used up to there");
    const size_t room = options_.max_points - std::min(points_, options_.max_points);
    shape.lines = flatten(path, around.to_canvas, options_.tolerance, room);
    for (const Polyline& line : shape.lines) points_ += line.points.size();
    if (points_ > options_.max_points) return fail("too many points", options_.max_points);
    if (!all_in_reach(shape.lines)) return warn(label + " is ignored: it reaches too far");
    const double tangled = tangle(shape.lines);
    if (tangled > options_.max_tangle) return warn(label + " is ignored: its outline is a tangle");
    tangle_ += tangled;
    if (tangle_ > options_.max_total_tangle) {
      return fail("outlines too tangled", static_cast<size_t>(options_.max_total_tangle));
    }
    set_paint(shape, around);
    shape.clips = around.clips;
    shape.blurred = around.blurred;
    shape.element = element;
    if (element.attribute("data-relievo") || !shape.annotation.empty()) {
      add_group(element, false, shape.annotation, around);
    }
    shape.group = around.group;
    drawing_.shapes.push_back(std::move(shape));
  }

  void set_paint(SvgShape& shape, const Surroundings& around) const {
    const SvgStyle& style = around.style;
    shape.fill_rule = around.in_clip ? style.clip_rule : style.fill_rule;
    shape.fill = representative_color(style.fill, document_);
    if (shape.fill) shape.fill->a *= style.fill_opacity * around.opacity;
    shape.pen = {style.stroke_width * around.to_canvas.mean_scale(), style.cap, style.join,
                 style.miter_limit};
    if (shape.pen.width > 0) shape.stroke = representative_color(style.stroke, document_);
    if (shape.stroke) shape.stroke->a *= style.stroke_opacity * around.opacity;
  }

  const SvgDocument& document_;
  const SvgOptions& options_;
  SvgDrawing drawing_;
  std::vector<pugi::xml_node> open_references_;
  size_t elements_ = 0;
  size_t points_ = 0;
  double tangle_ = 0;
  std::optional<Error> error_;
};

/// Right and bottom of all shapes as seen from the origin of user units.
Result<RootSize> extent(const SvgDocument& document, const SvgOptions& options) {
  const auto drawing = DrawingReader(document, options).read({1, 1}, 1);
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
    return Error{ErrorCode::bad_input, "the drawing is more than 1000 times longer than wide",
                 "svg"};
  }
  const bool keep = longest >= options.min_side && longest <= options.max_side;
  return DrawingReader(document, options).read(*size, keep ? 1 : options.scaled_side / longest);
}

}  // namespace relievo
