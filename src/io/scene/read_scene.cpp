#include "io/scene/read_scene.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "io/scene/json_parse.h"
#include "io/scene/json_reader.h"

namespace relievo {
namespace {

using Json = nlohmann::json;
using Path = JsonPath;

/// Turns JSON values into a scene. The first failure is kept; after it, whatever is returned is
/// of no use and is thrown away by the caller.
class SceneReader : public JsonReader {
 public:
  explicit SceneReader(const SceneLimits& limits)
      : JsonReader(limits.max_points), limits_(limits) {}

  Scene scene(const Json& json) {
    const Path root;
    Scene scene;
    if (!json.is_object()) {
      fail(root, "is not a scene: the file must hold one JSON object");
      return scene;
    }
    check_format(json, root);
    keys(json, root, {"format", "version", "canvas", "parts"},
         {"drawing", "joins", "relations", "robin"});
    if (error()) return scene;
    canvas(json["canvas"], root.member("canvas"), scene);
    if (json.contains("drawing"))
      scene.drawing = path_text(json["drawing"], root.member("drawing"));
    parts(json["parts"], root.member("parts"), scene);
    check(scene);
    list(json, root, "joins", scene.joins, &SceneReader::join);
    list(json, root, "relations", scene.relations, &SceneReader::relation);
    list(json, root, "robin", scene.robin, &SceneReader::robin);
    check(scene);
    return scene;
  }

 private:
  void check(const Scene& scene) {
    if (error()) return;
    if (Status status = validate(scene); !status) fail(status.error());
  }

  void check_format(const Json& json, const Path& root) {
    const auto format = json.find("format");
    if (format == json.end() || *format != "relievo-scene")
      return fail(root.member("format"), "is not a scene: the key must say \"relievo-scene\"");
    const auto version = json.find("version");
    if (version == json.end() || !version->is_number_integer() || *version != 1)
      fail(root.member("version"),
           "this program reads version 1 only; a newer file needs a newer program");
  }

  std::string path_text(const Json& json, const Path& path) {
    std::string name = text(json, path);
    if (name.empty()) fail(path, "is empty; leave the key out where there is no drawing");
    return name;
  }

  void canvas(const Json& json, const Path& path, Scene& scene) {
    if (!keys(json, path, {"width", "height"}, {})) return;
    scene.width = number(json["width"], path.member("width"));
    scene.height = number(json["height"], path.member("height"));
  }

  void parts(const Json& json, const Path& path, Scene& scene) {
    if (!is_list(json, path, "parts, back to front")) return;
    if (json.size() > limits_.max_parts)
      return fail(path, "has more than " + std::to_string(limits_.max_parts) + " parts",
                  ErrorCode::limit);
    for (size_t i = 0; i < json.size() && !error(); ++i) {
      scene.parts.push_back(part(json[i], path.element(i)));
      index_.emplace(scene.parts.back().id, static_cast<int>(i));
    }
  }

  Part part(const Json& json, const Path& path) {
    Part part;
    if (!keys(json, path, {"id", "outline"}, {"c", "d"})) return part;
    part.id = text(json["id"], path.member("id"));
    if (json.contains("c")) part.c = number(json["c"], path.member("c"));
    if (json.contains("d")) part.d = number(json["d"], path.member("d"));
    part.outline = outline(json["outline"], path.member("outline"));
    return part;
  }

  int part_index(const Json& json, const Path& path) {
    const std::string id = text(json, path);
    const auto found = index_.find(id);
    if (found == index_.end()) {
      fail(path, "no part has the id \"" + id + "\"");
      return -1;
    }
    return found->second;
  }

  template <class Item>
  void list(const Json& json, const Path& root, const char* key, std::vector<Item>& items,
            Item (SceneReader::*read)(const Json&, const Path&)) {
    if (error() || !json.contains(key)) return;
    const Json& array = json[key];
    const Path path = root.member(key);
    if (!is_list(array, path, "objects")) return;
    for (size_t i = 0; i < array.size() && !error(); ++i)
      items.push_back((this->*read)(array[i], path.element(i)));
  }

  /// The parts that a join, relation or Robin range is about.
  template <class Item>
  void pair(const Json& json, const Path& path, Item& item) {
    item.upper = part_index(json["upper"], path.member("upper"));
    item.lower = part_index(json["lower"], path.member("lower"));
  }

  Join join(const Json& json, const Path& path) {
    Join join;
    if (!keys(json, path, {"upper", "lower", "line"}, {})) return join;
    pair(json, path, join);
    join.line = points(json["line"], path.member("line"));
    return join;
  }

  Relation relation(const Json& json, const Path& path) {
    Relation relation;
    if (!keys(json, path, {"upper", "lower", "relation"}, {"range"})) return relation;
    pair(json, path, relation);
    relation.kind = relation_kind(json["relation"], path.member("relation"));
    if (!json.contains("range")) return relation;
    const Json& range = json["range"];
    const Path range_path = path.member("range");
    if (!range.is_array() || range.size() != 2)
      fail(range_path, "must be two points [[x, y], [x, y]]");
    else
      relation.range = {point(range[0], range_path.element(0)),
                        point(range[1], range_path.element(1))};
    return relation;
  }

  RobinRange robin(const Json& json, const Path& path) {
    RobinRange range;
    if (!keys(json, path, {"upper", "lower", "from", "to"}, {"alpha0", "rho"})) return range;
    pair(json, path, range);
    range.from = point(json["from"], path.member("from"));
    range.to = point(json["to"], path.member("to"));
    if (json.contains("alpha0")) range.alpha0 = number(json["alpha0"], path.member("alpha0"));
    if (json.contains("rho")) range.rho = number(json["rho"], path.member("rho"));
    return range;
  }

  const SceneLimits& limits_;
  std::map<std::string, int> index_;
};

}  // namespace

Result<Scene> read_scene(std::string_view json, const SceneLimits& limits) {
  JsonLimits json_limits;
  json_limits.max_bytes = limits.max_bytes;
  const auto parsed = parse_json(json, json_limits);
  if (!parsed) return parsed.error();
  SceneReader reader(limits);
  Scene scene = reader.scene(*parsed);
  if (reader.error()) return *reader.error();
  for (Part& part : scene.parts) orient_by_nesting(part.outline);
  return scene;
}

}  // namespace relievo
