#include "io/svg/resolve_cuts.h"

#include <algorithm>
#include <string>
#include <vector>

#include "io/files/number_text.h"
#include "io/svg/object_box.h"
#include "io/svg/svg_attributes.h"
#include "io/svg/svg_style.h"
#include "io/svg/svg_transform.h"
#include "io/svg/svg_values.h"
#include "io/svg/svg_viewport.h"

namespace relievo {
namespace {

/// Returns whether an attribute says that lengths are fractions of the object's box.
bool is_of_box(const pugi::xml_node& element, const char* name, bool by_default) {
  const std::string_view units = element.attribute(name).value();
  return units.empty() ? by_default : units == "objectBoundingBox";
}

/// Returns the map of the unit square to the box.
Affine2 map_to(const Box2& box) {
  return translation(box.min.x, box.min.y) * scaling(box.max.x - box.min.x, box.max.y - box.min.y);
}

bool has_text(const pugi::xml_node& element) {
  if (local_name(element.name()) == "text") return true;
  const auto children = element.children();
  return std::any_of(children.begin(), children.end(),
                     [](const pugi::xml_node& child) { return has_text(child); });
}

bool is_inside_cut(const pugi::xml_node& element) {
  for (pugi::xml_node at = element.parent(); at; at = at.parent())
    if (local_name(at.name()) == "clipPath" || local_name(at.name()) == "mask") return true;
  return false;
}

/// States the value of a property where the element states it now.
void restate(pugi::xml_node element, const std::string& name, const std::string& value) {
  std::vector<Declaration> style = parse_declarations(element.attribute("style").value());
  const auto found = std::find_if(style.begin(), style.end(),
                                  [&](const Declaration& d) { return d.name == name; });
  if (found == style.end()) return set_attribute(element, name.c_str(), value);
  std::erase_if(style, [&](const Declaration& d) { return d.name == name; });
  style.push_back({name, value});
  set_style(element, style);
}

void convert_clip(pugi::xml_node clip, const Box2& box) {
  const auto own = parse_transform(clip.attribute("transform").value());
  set_attribute(clip, "transform", transform_text(own.value_or(Affine2()) * map_to(box)));
  set_attribute(clip, "clipPathUnits", "userSpaceOnUse");
}

void convert_mask_rectangle(pugi::xml_node mask, const Box2& box, const LengthContext& lengths) {
  const LengthContext fractions{lengths.font_size, 1, 1};
  const auto fraction = [&](const char* name, double by_default) {
    return parse_length(mask.attribute(name).value(), LengthAxis::horizontal, fractions)
        .value_or(by_default);
  };
  const Point2 size = box.max - box.min;
  const auto set = [&](const char* name, double value) {
    set_attribute(mask, name, shortest_text(value));
  };
  const double x = box.min.x + fraction("x", -0.1) * size.x;
  const double y = box.min.y + fraction("y", -0.1) * size.y;
  set("width", fraction("width", 1.2) * size.x);
  set("height", fraction("height", 1.2) * size.y);
  set("x", x);
  set("y", y);
  set_attribute(mask, "maskUnits", "userSpaceOnUse");
}

/// Puts what is in the mask into a group that maps the unit square to the box.
void convert_mask_content(pugi::xml_node mask, const Box2& box) {
  set_attribute(wrap_children(mask), "transform", transform_text(map_to(box)));
  set_attribute(mask, "maskContentUnits", "userSpaceOnUse");
}

class CutResolver {
 public:
  CutResolver(SvgDocument& document, const SvgOptions& options)
      : document_(document), options_(options), search_{document} {}

  Status run() {
    visit_elements(document_, [this](pugi::xml_node element, const LengthContext& lengths) {
      for (const char* property : {"clip-path", "mask"})
        if (is_of_object(cut_of(element, property))) cut_.push_back({element, property, lengths});
    });
    // A clip path or mask is copied together with those that it uses, which come first.
    std::stable_partition(cut_.begin(), cut_.end(),
                          [](const Cut& cut) { return is_inside_cut(cut.element); });
    for (const Cut& cut : cut_) {
      resolve(cut);
      if (search_.gave_up() || copied_ > options_.max_elements)
        return Error{ErrorCode::limit,
                     "has too many clip paths and masks that refer to boxes of objects", "svg"};
    }
    return Done{};
  }

 private:
  /// An element and a property that cuts it.
  struct Cut {
    pugi::xml_node element;
    std::string property;
    LengthContext lengths;
  };

  /// Returns the clip path or mask that the property names; none where there is no such.
  pugi::xml_node cut_of(const pugi::xml_node& element, const std::string& property) const {
    return named_element(document_, local_reference(stated_value(element, property)),
                         property == "mask" ? "mask" : "clipPath");
  }

  static bool is_of_object(const pugi::xml_node& cut) {
    if (local_name(cut.name()) == "clipPath") return is_of_box(cut, "clipPathUnits", false);
    return local_name(cut.name()) == "mask" &&
           (is_of_box(cut, "maskUnits", true) || is_of_box(cut, "maskContentUnits", false));
  }

  void resolve(const Cut& cut) {
    Box2 box = object_box(cut.element, cut.lengths, search_);
    if (box.empty() || has_text(cut.element)) return;
    if (local_name(cut.element.name()) == "use") {
      // A clip path or mask of a <use> moves with it.
      const Point2 moved = placement_of(cut.element, cut.lengths)({0, 0});
      box = {box.min - moved, box.max - moved};
    }
    pugi::xml_node original = cut_of(cut.element, cut.property);
    pugi::xml_node copy = original.parent().insert_copy_after(original, original);
    copied_ += rename_copy(copy, document_);
    if (cut.property == "clip-path") {
      convert_clip(copy, box);
    } else {
      if (is_of_box(copy, "maskUnits", true)) convert_mask_rectangle(copy, box, cut.lengths);
      if (is_of_box(copy, "maskContentUnits", false)) convert_mask_content(copy, box);
    }
    restate(cut.element, cut.property, "url(#" + std::string(copy.attribute("id").value()) + ")");
  }

  SvgDocument& document_;
  const SvgOptions& options_;
  BoxSearch search_;
  std::vector<Cut> cut_;
  size_t copied_ = 0;  ///< elements
};

}  // namespace

Status resolve_cuts(SvgDocument& document, const SvgOptions& options) {
  return CutResolver(document, options).run();
}

}  // namespace relievo
