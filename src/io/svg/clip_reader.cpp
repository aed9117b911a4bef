#include "io/svg/clip_reader.h"

#include <string_view>
#include <utility>

#include "io/svg/drawing_reader.h"
#include "io/svg/svg_attributes.h"
#include "io/svg/svg_transform.h"

namespace relievo {
namespace {

/// Closes an open reference and returns its shapes, which the drawing itself does not show.
std::vector<SvgShape> shapes_apart(const pugi::xml_node& parent, const InheritedState& inside,
                                   Reading& reading) {
  const size_t groups = reading.drawing.groups.size();
  std::vector<SvgShape> shapes = std::exchange(reading.drawing.shapes, {});
  read_children(parent, inside, reading);
  std::swap(shapes, reading.drawing.shapes);
  reading.drawing.groups.resize(groups);
  reading.open_references.pop_back();
  return shapes;
}

/// Computes the style of an element where it stands in the document.
SvgStyle style_in_place(const pugi::xml_node& element, const LengthContext& lengths) {
  if (element.type() != pugi::node_element) return {};
  return computed_style(element, style_in_place(element.parent(), lengths), lengths);
}

void enter_clip(const pugi::xml_node& clip, InheritedState& around, Reading& reading) {
  if (std::string_view(clip.attribute("clipPathUnits").value()) == "objectBoundingBox")
    return reading.warn("a clip path in units of the box of a text is ignored");
  if (!reading.begin_reference(clip)) return;
  InheritedState inside = around;
  inside.in_clip = true;
  inside.clips.clear();
  inside.style = style_in_place(clip, around.lengths);
  const auto transform = parse_transform(clip.attribute("transform").value());
  if (transform) inside.to_canvas = inside.to_canvas * *transform;
  std::vector<Region> regions;
  for (const SvgShape& shape : shapes_apart(clip, inside, reading))
    regions.push_back(fill_of(shape, reading.drawing));
  add_clip(unite(regions), around, reading);
}

/// Cuts what is in the mask to its rectangle, where that is in user units.
void enter_mask_rectangle(const pugi::xml_node& mask, InheritedState& inside, Reading& reading) {
  if (std::string_view(mask.attribute("maskUnits").value()) != "userSpaceOnUse") return;
  const auto length = [&](const char* name, LengthAxis axis, double by_default) {
    return parse_length(mask.attribute(name).value(), axis, inside.lengths)
        .value_or(by_default * reference_length(axis, inside.lengths));
  };
  const Point2 corner{length("x", LengthAxis::horizontal, -0.1),
                      length("y", LengthAxis::vertical, -0.1)};
  const Point2 size{length("width", LengthAxis::horizontal, 1.2),
                    length("height", LengthAxis::vertical, 1.2)};
  const Polyline line = rectangle_line({corner, corner + size}, inside.to_canvas);
  add_clip(fill_region({line}, FillRule::nonzero, reading.drawing.canvas()), inside, reading);
}

void enter_mask(const pugi::xml_node& mask, InheritedState& around, Reading& reading) {
  if (std::string_view(mask.attribute("maskContentUnits").value()) == "objectBoundingBox")
    return reading.warn("a mask in units of the box of a text is ignored");
  if (!reading.begin_reference(mask)) return;
  InheritedState inside = around;
  inside.clips.clear();
  inside.style = style_in_place(mask, around.lengths);
  inside.opacity = 1;
  enter_mask_rectangle(mask, inside, reading);
  const std::vector<SvgShape> shapes = shapes_apart(mask, inside, reading);
  const bool by_alpha = stated_value(mask, "mask-type") == "alpha";
  add_clip(
      by_alpha ? opaque_region(shapes, reading.drawing) : light_region(shapes, reading.drawing),
      around, reading);
}

}  // namespace

void add_clip(Region region, InheritedState& around, Reading& reading) {
  reading.drawing.clips.push_back(std::move(region));
  around.clips.push_back(static_cast<int>(reading.drawing.clips.size()) - 1);
}

void enter_clips(InheritedState& around, Reading& reading) {
  const std::string mask_id = around.style.mask;
  if (const auto clip = named_element(reading.document, around.style.clip_path, "clipPath"))
    enter_clip(clip, around, reading);
  if (const auto mask = named_element(reading.document, mask_id, "mask"))
    enter_mask(mask, around, reading);
}

}  // namespace relievo
