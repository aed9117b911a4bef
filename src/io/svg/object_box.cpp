#include "io/svg/object_box.h"

#include <limits>

#include "io/svg/basic_shapes.h"
#include "io/svg/path_data.h"
#include "io/svg/svg_attributes.h"
#include "io/svg/svg_transform.h"
#include "io/svg/svg_viewport.h"

namespace relievo {
namespace {

constexpr int deepest = 200;  ///< nesting, <use> included

struct Place {
  Affine2 map;  ///< to the units of the box
  LengthContext lengths;
  int depth = 0;
};

void add_element(const pugi::xml_node& element, Place place, BoxSearch& search, Box2& box);

void add_children(const pugi::xml_node& parent, const Place& place, BoxSearch& search, Box2& box) {
  for (const pugi::xml_node& child : parent.children()) {
    if (child.type() != pugi::node_element) continue;
    if (stated_value(child, "display") == "none") continue;
    Place inside = place;
    inside.map =
        place.map * parse_transform(child.attribute("transform").value()).value_or(Affine2());
    add_element(child, inside, search, box);
  }
}

void add_rectangle(RootSize size, const Affine2& map, Box2& box) {
  for (const double x : {0.0, size.width})
    for (const double y : {0.0, size.height}) box.add(map({x, y}));
}

void add_shape(const pugi::xml_node& element, const Place& place, BoxSearch& search, Box2& box) {
  bool complete = true;
  const PathData path = shape_path(element, place.lengths, complete);
  search.work += path.size();
  for (const Polyline& line :
       flatten(path, place.map, search.tolerance, std::numeric_limits<size_t>::max()))
    for (const Point2 p : line.points) box.add(p);
}

void add_used(const pugi::xml_node& use, Place place, BoxSearch& search, Box2& box) {
  const pugi::xml_node target = referenced_element(search.document, use);
  const std::string_view name = local_name(target.name());
  place.map = place.map * placement_of(use, place.lengths) *
              parse_transform(target.attribute("transform").value()).value_or(Affine2());
  if (name != "symbol") return add_element(target, place, search, box);
  const RootSize size = viewport_of(target, use, place.lengths);
  place.map = place.map * enter_viewport(target, size, place.lengths);
  add_children(target, place, search, box);
}

void add_element(const pugi::xml_node& element, Place place, BoxSearch& search, Box2& box) {
  if (++place.depth > deepest || search.gave_up()) return;
  ++search.work;
  const std::string_view name = local_name(element.name());
  if (is_shape_element(name)) return add_shape(element, place, search, box);
  if (name == "use") return add_used(element, place, search, box);
  if (name == "image") {
    place.map = place.map * placement_of(element, place.lengths);
    return add_rectangle(viewport_of(element, element, place.lengths), place.map, box);
  }
  if (name == "svg") {
    place.map = place.map * placement_of(element, place.lengths);
    const RootSize size = viewport_of(element, element, place.lengths);
    place.map = place.map * enter_viewport(element, size, place.lengths);
  }
  if (is_container(name)) add_children(element, place, search, box);
}

}  // namespace

Box2 object_box(const pugi::xml_node& element, const LengthContext& lengths, BoxSearch& search) {
  Box2 box;
  add_element(element, {Affine2(), lengths}, search, box);
  return search.gave_up() ? Box2() : box;
}

}  // namespace relievo
