#include "io/scene/scene_json.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "io/scene/json_reader.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

using Json = nlohmann::json;
using Path = JsonPath;

class SceneReader final : public JsonReader {
 public:
  explicit SceneReader(const JsonLimits& limits)
      : JsonReader(limits.max_points), max_parts_(limits.max_parts) {}

  Scene scene(const Json& json) {
    const Path root;
    Scene scene;
    if (!is_file(json, "scene", 1)) return scene;
    keys(json, root, {"format", "version", "canvas", "parts"},
         {"drawing", "joins", "relations", "robin", "cues"});
    if (error()) return scene;
    canvas(json["canvas"], root.member("canvas"), scene);
    if (json.contains("drawing"))
      scene.drawing = path_text(json["drawing"], root.member("drawing"));
    parts(json["parts"], root.member("parts"), scene);
    check(scene);
    list(json, root, "joins", scene.joins, &SceneReader::join);
    list(json, root, "relations", scene.relations, &SceneReader::relation);
    list(json, root, "robin", scene.robin, &SceneReader::robin);
    list(json, root, "cues", scene.cues, &SceneReader::cue);
    if (!error()) turn_joins_from_behind(scene);
    check(scene);
    return scene;
  }

 private:
  void check(const Scene& scene) {
    if (error()) return;
    if (Status status = validate(scene); !status) fail(status.error());
  }

  std::string path_text(const Json& json, const Path& path) {
    std::string name = text(json, path);
    if (name.empty()) fail(path, "is empty; remove the key if there is no drawing");
    return name;
  }

  void canvas(const Json& json, const Path& path, Scene& scene) {
    if (!keys(json, path, {"width", "height"}, {})) return;
    set(json, path, "width", scene.width, &SceneReader::number);
    set(json, path, "height", scene.height, &SceneReader::number);
  }

  void parts(const Json& json, const Path& path, Scene& scene) {
    if (!is_list(json, path, "parts, back to front")) return;
    if (json.size() > max_parts_)
      return fail(path, "has more than " + std::to_string(max_parts_) + " parts", ErrorCode::limit);
    for (size_t i = 0; i < json.size() && !error(); ++i) {
      scene.parts.push_back(part(json[i], path.element(i)));
      index_.emplace(scene.parts.back().id, static_cast<int>(i));
    }
  }

  Part part(const Json& json, const Path& path) {
    Part part;
    if (!keys(json, path, {"id", "outline"}, {"c", "d", "flat", "lean"})) return part;
    part_values(json, path, part);
    return part;
  }

  int part_reference(const Json& json, const Path& path) override {
    const std::string id = text(json, path);
    const auto found = index_.find(id);
    if (found == index_.end()) {
      fail(path, "no part has the id \"" + id + "\"");
      return -1;
    }
    return found->second;
  }

  size_t max_parts_;
  std::map<std::string, int> index_;
};

/// Returns the shortest text that reads back as the same number; whole numbers have no fraction.
std::string number(double value) {
  const bool whole = std::abs(value) < 1e15 && value == std::floor(value) && !std::signbit(value);
  if (whole) return std::to_string(static_cast<long long>(value));
  return nlohmann::json(value).dump();
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string point(Point2 p) { return "[" + number(p.x) + "," + number(p.y) + "]"; }

std::string points(const std::vector<Point2>& list) {
  std::string text = "[";
  for (size_t i = 0; i < list.size(); ++i) text += (i > 0 ? "," : "") + point(list[i]);
  return text + "]";
}

/// Returns a list with one item a line.
template <class Item, class Write>
std::string lines(const std::vector<Item>& items, const std::string& indent, Write write) {
  if (items.empty()) return "[]";
  std::string text = "[";
  for (size_t i = 0; i < items.size(); ++i)
    text += (i > 0 ? ",\n" : "\n") + indent + "  " + write(items[i]);
  return text + "\n" + indent + "]";
}

std::string part_text(const Part& part) {
  const std::string flat = part.flat != 0 ? ", \"flat\": " + number(part.flat) : "";
  const std::string lean = part.lean != Point2{} ? ", \"lean\": " + point(part.lean) : "";
  return "{ \"id\": " + quoted(part.id) + ", \"c\": " + number(part.c) +
         ", \"d\": " + number(part.d) + flat + lean +
         ", \"outline\": " + lines(part.outline, "    ", points) + " }";
}

/// Opens the object of an annotation of two parts.
template <class Item>
std::string pair_text(const Scene& scene, const Item& item) {
  return "{ \"upper\": " + quoted(scene.parts[item.upper].id) +
         ", \"lower\": " + quoted(scene.parts[item.lower].id);
}

std::string join_text(const Scene& scene, const Join& join) {
  return pair_text(scene, join) + ", \"line\": " + points(join.line) + " }";
}

std::string relation_text(const Scene& scene, const Relation& relation) {
  std::string text = pair_text(scene, relation) + ", \"relation\": \"" + name(relation.kind) + "\"";
  if (relation.range)
    text += ", \"range\": " + points({relation.range->first, relation.range->second});
  return text + " }";
}

std::string robin_text(const Scene& scene, const RobinRange& range) {
  std::string text =
      pair_text(scene, range) + ", \"from\": " + point(range.from) + ", \"to\": " + point(range.to);
  if (range.alpha0) text += ", \"alpha0\": " + number(*range.alpha0);
  if (range.rho) text += ", \"rho\": " + number(*range.rho);
  return text + " }";
}

std::string cue_text(const Scene& scene, const Cue& cue) {
  return "{ \"part\": " + quoted(scene.parts[cue.part].id) + ", \"kind\": \"" + name(cue.kind) +
         "\", \"line\": " + points(cue.line) + ", \"value\": " + number(cue.value) + " }";
}

}  // namespace

Result<Scene> read_scene(std::string_view json, const JsonLimits& limits) {
  const auto parsed = parse_json(json, limits);
  if (!parsed) return parsed.error();
  SceneReader reader(limits);
  Scene scene = reader.scene(*parsed);
  if (reader.error()) return *reader.error();
  for (Part& part : scene.parts) orient_by_nesting(part.outline);
  return scene;
}

Result<std::string> write_scene(const Scene& scene) {
  if (Status status = validate(scene); !status) return status.error();
  const auto in_scene = [&](auto write) {
    return [&scene, write](const auto& item) { return write(scene, item); };
  };
  std::string text =
      "{\n  \"format\": \"relievo-scene\",\n  \"version\": 1,\n  \"canvas\": { \"width\": " +
      number(scene.width) + ", \"height\": " + number(scene.height) + " },\n";
  if (!scene.drawing.empty()) text += "  \"drawing\": " + quoted(scene.drawing) + ",\n";
  text += "  \"parts\": " + lines(scene.parts, "  ", part_text);
  text += ",\n  \"joins\": " + lines(scene.joins, "  ", in_scene(join_text));
  text += ",\n  \"relations\": " + lines(scene.relations, "  ", in_scene(relation_text));
  text += ",\n  \"robin\": " + lines(scene.robin, "  ", in_scene(robin_text));
  if (!scene.cues.empty()) text += ",\n  \"cues\": " + lines(scene.cues, "  ", in_scene(cue_text));
  return text + "\n}\n";
}

}  // namespace relievo
