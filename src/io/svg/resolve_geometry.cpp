#include "io/svg/resolve_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/svg/basic_shapes.h"
#include "io/svg/object_box.h"
#include "io/svg/svg_attributes.h"
#include "io/svg/svg_transform.h"
#include "io/svg/svg_viewport.h"

namespace relievo {
namespace {

constexpr std::array<std::string_view, 9> lengths_of_shapes = {"x",  "y", "width", "height", "cx",
                                                               "cy", "r", "rx",    "ry"};
constexpr std::array<std::string_view, 6> transform_properties = {
    "transform", "transform-origin", "transform-box", "translate", "rotate", "scale"};

template <class Names>
bool is_one_of(std::string_view name, const Names& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns the data in `path("...")`; empty for any other text.
std::string path_of(std::string_view text) {
  const size_t open = text.find_first_of("\"'");
  if (!text.starts_with("path(") || open == std::string_view::npos) return "";
  const std::string_view inside = text.substr(open + 1);
  return std::string(inside.substr(0, inside.find(text[open])));
}

/// Moves geometry from the style of a shape to its attributes.
void move_geometry(pugi::xml_node element, std::vector<Declaration>& style) {
  const std::string_view name = local_name(element.name());
  const bool sized = is_shape_element(name) || name == "image" || name == "use";
  if (!sized) return;
  std::erase_if(style, [&](const Declaration& d) {
    if (name == "path" && d.name == "d") {
      set_attribute(element, "d", path_of(d.value));
      return true;
    }
    if (!is_one_of(d.name, lengths_of_shapes)) return false;
    if (d.value == "auto")
      element.remove_attribute(d.name.c_str());
    else
      set_attribute(element, d.name.c_str(), d.value);
    return true;
  });
}

/// The transform properties of an element.
struct StatedTransform {
  std::string transform;
  std::string origin;
  std::string box;
  /// translate, rotate and scale as functions.
  std::string before;
  bool plain = true;  ///< only by its attribute

  std::string transform_function() const {
    return trimmed_svg(transform) == "none" ? "" : transform;
  }
};

/// Takes the transform properties out of the style and the attributes of an element.
StatedTransform take_transform(pugi::xml_node element, std::vector<Declaration>& style) {
  StatedTransform stated;
  stated.transform = element.attribute("transform").value();
  for (const auto& [name, text] :
       {std::pair("transform-origin", &stated.origin), std::pair("transform-box", &stated.box)})
    if (const pugi::xml_attribute attribute = element.attribute(name)) {
      *text = attribute.value();
      stated.plain = false;
      element.remove_attribute(attribute);
    }
  std::string translate, rotate, scale;
  std::erase_if(style, [&](const Declaration& d) {
    if (!is_one_of(d.name, transform_properties)) return false;
    std::string& text = d.name == "transform"          ? stated.transform
                        : d.name == "transform-origin" ? stated.origin
                        : d.name == "transform-box"    ? stated.box
                        : d.name == "translate"        ? translate
                        : d.name == "rotate"           ? rotate
                                                       : scale;
    text = d.value;
    stated.plain = false;
    return true;
  });
  for (const auto& [name, text] :
       {std::pair("translate", translate), std::pair("rotate", rotate), std::pair("scale", scale)})
    if (!text.empty() && text != "none") stated.before += std::string(name) + "(" + text + ")";
  return stated;
}

bool has_numbers(const Affine2& m) { return std::isfinite(m.a + m.b + m.c + m.d + m.e + m.f); }

/// Returns whether the transform of the element is a property of its own kind.
bool is_paint_server(std::string_view name) {
  return name == "linearGradient" || name == "radialGradient" || name == "pattern";
}

/// Returns whether the reference box is that of the object, not of the viewport.
bool is_of_object(const std::string& box) { return !box.empty() && box != "view-box"; }

class GeometryResolver {
 public:
  explicit GeometryResolver(SvgDocument& document) : document_(document), search_{document} {}

  Status run() {
    visit_elements(document_, [this](pugi::xml_node element, const LengthContext& lengths) {
      visit(element, lengths);
    });
    resolve_root();
    for (const Pending& one : pending_) {
      const Box2 box = object_box(one.element, one.lengths, search_);
      if (box.empty()) continue;
      LengthContext lengths_of_box = one.lengths;
      lengths_of_box.viewport_width = box.max.x - box.min.x;
      lengths_of_box.viewport_height = box.max.y - box.min.y;
      write(one.element, map_of(one.stated, {box.min, lengths_of_box}));
    }
    if (!search_.gave_up()) return Done{};
    return Error{ErrorCode::limit,
                 "has transforms that refer to too many boxes of groups; export it with matrices",
                 "svg"};
  }

 private:
  /// A transform that refers to the box of its object, which others may change.
  struct Pending {
    pugi::xml_node element;
    StatedTransform stated;
    LengthContext lengths;
  };

  void visit(pugi::xml_node element, const LengthContext& lengths) {
    std::vector<Declaration> style = parse_declarations(element.attribute("style").value());
    const size_t count = style.size();
    move_geometry(element, style);
    if (!is_paint_server(local_name(element.name())))
      resolve(element, take_transform(element, style), lengths);
    if (style.size() != count) set_style(element, style);
  }

  void resolve(pugi::xml_node element, const StatedTransform& stated,
               const LengthContext& lengths) {
    if (stated.plain && is_plain_transform(stated.transform)) return;
    element.remove_attribute("transform");
    if (is_of_object(stated.box))
      pending_.push_back({element, stated, lengths});
    else
      write(element, map_of(stated, {{}, lengths}));
  }

  /// The root turns in its viewport, round the middle unless it says otherwise; what is in it does
  /// so in place of it.
  void resolve_root() {
    pugi::xml_node root = document_.root;
    std::vector<Declaration> style = parse_declarations(root.attribute("style").value());
    const size_t count = style.size();
    StatedTransform stated = take_transform(root, style);
    if (style.size() != count) set_style(root, style);
    if (stated.transform.empty() && stated.before.empty()) return;
    root.remove_attribute("transform");
    if (stated.origin.empty()) stated.origin = "center";
    LengthContext ignored;
    const RootSize size = root_size(root).value_or(RootSize{});
    const Affine2 view = size.width > 0 ? enter_viewport(root, size, ignored) : Affine2();
    const std::optional<Affine2> map = map_of(stated, {{}, {16, size.width, size.height}});
    write(wrap_children(root), map ? std::optional(inverse(view) * *map * view) : map);
  }

  /// Returns the whole map; nothing where it cannot be read.
  static std::optional<Affine2> map_of(const StatedTransform& stated, const TransformBox& box) {
    const auto map = parse_transform(stated.before + stated.transform_function(), box);
    const auto origin = stated.origin.empty() ? std::optional(box.corner)
                                              : parse_transform_origin(stated.origin, box);
    if (!map || !origin) return std::nullopt;
    return translation(origin->x, origin->y) * *map * translation(-origin->x, -origin->y);
  }

  void write(pugi::xml_node element, const std::optional<Affine2>& map) {
    if (map && has_numbers(*map)) return set_attribute(element, "transform", transform_text(*map));
    const std::string text = "an unreadable transform is ignored";
    auto& list = document_.warnings;
    if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
  }

  SvgDocument& document_;
  BoxSearch search_;
  std::vector<Pending> pending_;
};

}  // namespace

Status resolve_geometry(SvgDocument& document) { return GeometryResolver(document).run(); }

}  // namespace relievo
