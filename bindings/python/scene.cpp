#include "bindings/python/scene.h"

#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bindings/python/arrays.h"
#include "bindings/python/errors.h"

namespace relievo::python {
namespace {

namespace py = pybind11;

/// A Python value with its path, for errors.
struct Value {
  py::object value;
  std::string path;

  Value operator[](const char* name) const {
    return {value.attr(name), path.empty() ? name : path + "." + name};
  }

  template <class T>
  T as(const char* kind) const {
    try {
      return value.cast<T>();
    } catch (const py::cast_error&) {
      raise({ErrorCode::bad_input, std::string("must be ") + kind, path});
    }
  }
  double number() const { return as<double>("a number"); }
  std::string text() const { return as<std::string>("a text"); }
  std::vector<Point2> points() const { return to_points(value, path); }

  std::vector<Value> items() const {
    const auto list = as<py::sequence>("a list");
    std::vector<Value> items;
    for (size_t i = 0; i < list.size(); ++i)
      items.push_back({list[i], path + "[" + std::to_string(i) + "]"});
    return items;
  }

  Point2 point() const {
    const auto numbers = items();
    if (numbers.size() != 2) raise({ErrorCode::bad_input, "must be two numbers", path});
    return {numbers[0].number(), numbers[1].number()};
  }

  std::optional<double> number_or_none() const {
    return value.is_none() ? std::nullopt : std::optional(number());
  }
};

using PartNumbers = std::map<std::string, int>;

int part_number(const Value& id, const PartNumbers& numbers) {
  const auto found = numbers.find(id.text());
  if (found == numbers.end())
    raise({ErrorCode::bad_input, "there is no part \"" + id.text() + "\"", id.path});
  return found->second;
}

/// Returns the kind with the given name, one of the first `count`.
template <class Kind>
Kind kind_named(const Value& text, int count) {
  const std::string wanted = text.text();
  std::string names;
  for (int i = 0; i < count; ++i) {
    if (wanted == name(Kind(i))) return Kind(i);
    names += (i == 0 ? "" : ", ") + std::string(name(Kind(i)));
  }
  raise({ErrorCode::bad_input, "must be one of " + names, text.path});
}

Part to_part(const Value& from) {
  Part part;
  part.id = from["id"].text();
  for (const Value& ring : from["outline"].items()) part.outline.push_back(ring.points());
  part.c = from["c"].number();
  part.d = from["d"].number();
  part.flat = from["flat"].number();
  part.lean = from["lean"].point();
  return part;
}

Relation to_relation(const Value& from, const PartNumbers& parts) {
  Relation relation{part_number(from["upper"], parts), part_number(from["lower"], parts),
                    kind_named<RelationKind>(from["kind"], 5), std::nullopt};
  const Value range = from["range"];
  if (range.value.is_none()) return relation;
  const auto ends = range.points();
  if (ends.size() != 2) raise({ErrorCode::bad_input, "must be two points", range.path});
  relation.range = {ends[0], ends[1]};
  return relation;
}

RobinRange to_ramp(const Value& from, const PartNumbers& parts) {
  return {part_number(from["upper"], parts),
          part_number(from["lower"], parts),
          from["start"].point(),
          from["end"].point(),
          from["alpha0"].number_or_none(),
          from["rho"].number_or_none()};
}

py::object from_part(const py::module_& scenes, const Part& part) {
  py::list outline;
  for (const Ring& ring : part.outline) outline.append(to_array(ring));
  return scenes.attr("Part")(part.id, outline, part.c, part.d, part.flat,
                             py::make_tuple(part.lean.x, part.lean.y));
}

py::tuple pair(Point2 point) { return py::make_tuple(point.x, point.y); }

py::object range_of(const Relation& relation) {
  if (!relation.range) return py::none();
  return py::make_tuple(pair(relation.range->first), pair(relation.range->second));
}

}  // namespace

Scene to_scene(const py::handle& object) {
  const Value from{py::reinterpret_borrow<py::object>(object), ""};
  Scene scene;
  scene.width = from["width"].number();
  scene.height = from["height"].number();
  PartNumbers parts;
  for (const Value& part : from["parts"].items()) {
    scene.parts.push_back(to_part(part));
    parts.emplace(scene.parts.back().id, static_cast<int>(scene.parts.size()) - 1);
  }
  for (const Value& join : from["joins"].items())
    scene.joins.push_back({part_number(join["upper"], parts), part_number(join["lower"], parts),
                           join["line"].points()});
  for (const Value& relation : from["relations"].items())
    scene.relations.push_back(to_relation(relation, parts));
  for (const Value& ramp : from["ramps"].items()) scene.robin.push_back(to_ramp(ramp, parts));
  for (const Value& cue : from["cues"].items())
    scene.cues.push_back({part_number(cue["part"], parts), kind_named<CueKind>(cue["kind"], 3),
                          cue["line"].points(), cue["value"].number()});
  turn_joins_from_behind(scene);
  return scene;
}

py::object to_python(const Scene& scene) {
  const auto scenes = py::module_::import("relievo.scene");
  const auto id = [&scene](int part) { return scene.parts[part].id; };
  py::list parts;
  py::list joins;
  py::list relations;
  py::list ramps;
  py::list cues;
  for (const Part& part : scene.parts) parts.append(from_part(scenes, part));
  for (const Join& join : scene.joins)
    joins.append(scenes.attr("Join")(id(join.upper), id(join.lower), to_array(join.line)));
  for (const Relation& relation : scene.relations)
    relations.append(scenes.attr("Relation")(id(relation.upper), id(relation.lower),
                                             name(relation.kind), range_of(relation)));
  for (const RobinRange& ramp : scene.robin)
    ramps.append(scenes.attr("Ramp")(id(ramp.upper), id(ramp.lower), pair(ramp.from), pair(ramp.to),
                                     ramp.alpha0, ramp.rho));
  for (const Cue& cue : scene.cues)
    cues.append(scenes.attr("Cue")(id(cue.part), name(cue.kind), to_array(cue.line), cue.value));
  return scenes.attr("Scene")(scene.width, scene.height, parts, joins, relations, ramps, cues);
}

}  // namespace relievo::python
