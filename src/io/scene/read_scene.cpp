#include "io/scene/read_scene.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "io/scene/json_parse.h"

namespace relievo {
namespace {

using Json = nlohmann::json;

/// Where a value is, as a list towards the root; written out only for an error.
struct Path {
  const Path* parent = nullptr;
  std::string_view key;  ///< empty: an element
  size_t index = 0;

  Path member(std::string_view name) const { return {this, name, 0}; }
  Path element(size_t i) const { return {this, {}, i}; }
};

std::string to_string(const Path& path) {
  if (path.parent == nullptr) return "";
  const std::string before = to_string(*path.parent);
  if (path.key.empty()) return before + "[" + std::to_string(path.index) + "]";
  return before + (before.empty() ? "" : ".") + std::string(path.key);
}

/// Turns JSON values into a scene. The first failure is kept; after it, whatever is returned is
/// of no use and is thrown away by the caller.
class SceneReader {
 public:
  explicit SceneReader(const SceneLimits& limits) : limits_(limits) {}

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
    if (error_) return scene;
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

  const std::optional<Error>& error() const { return error_; }

 private:
  void fail(const Path& path, std::string message, ErrorCode code = ErrorCode::bad_input) {
    if (!error_) error_ = Error{code, std::move(message), to_string(path)};
  }

  void check(const Scene& scene) {
    if (error_) return;
    if (Status status = validate(scene); !status) error_ = status.error();
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

  /// The keys of an object: all of `required`, any of `optional`, nothing else.
  bool keys(const Json& json, const Path& path, std::initializer_list<const char*> required,
            std::initializer_list<const char*> optional) {
    if (!json.is_object()) {
      fail(path, "must be an object { ... }");
      return false;
    }
    for (const char* key : required)
      if (!json.contains(key)) fail(path.member(key), "is missing");
    for (const auto& item : json.items()) {
      const auto is = [&](const char* key) { return item.key() == key; };
      if (!std::any_of(required.begin(), required.end(), is) &&
          !std::any_of(optional.begin(), optional.end(), is))
        fail(path.member(item.key().empty() ? "\"\"" : item.key()),
             "is not a known key; remove it or correct its name");
    }
    return !error_;
  }

  bool is_list(const Json& json, const Path& path, const char* what) {
    if (!json.is_array()) fail(path, std::string("must be a list of ") + what);
    return json.is_array();
  }

  double number(const Json& json, const Path& path) {
    if (!json.is_number()) {
      fail(path, "must be a number");
      return 0;
    }
    return json.get<double>();
  }

  std::string text(const Json& json, const Path& path) {
    if (json.is_string()) return json.get<std::string>();
    fail(path, "must be a text in quotes");
    return "";
  }

  std::string path_text(const Json& json, const Path& path) {
    std::string name = text(json, path);
    if (name.empty()) fail(path, "is empty; leave the key out where there is no drawing");
    return name;
  }

  Point2 point(const Json& json, const Path& path) {
    if (!json.is_array() || json.size() != 2) {
      fail(path, "must be a point [x, y]");
      return {};
    }
    return {number(json[0], path.element(0)), number(json[1], path.element(1))};
  }

  std::vector<Point2> points(const Json& json, const Path& path) {
    std::vector<Point2> list;
    if (!is_list(json, path, "points [[x, y], ...]")) return list;
    point_count_ += json.size();
    if (point_count_ > limits_.max_points) {
      fail(path, "the scene has more than " + std::to_string(limits_.max_points) + " points",
           ErrorCode::limit);
      return list;
    }
    list.reserve(json.size());
    for (size_t i = 0; i < json.size() && !error_; ++i)
      list.push_back(point(json[i], path.element(i)));
    return list;
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
    for (size_t i = 0; i < json.size() && !error_; ++i) {
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
    const Path outline = path.member("outline");
    if (!is_list(json["outline"], outline, "rings [[[x, y], ...], ...]")) return part;
    for (size_t r = 0; r < json["outline"].size() && !error_; ++r)
      part.outline.push_back(points(json["outline"][r], outline.element(r)));
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
    if (error_ || !json.contains(key)) return;
    const Json& array = json[key];
    const Path path = root.member(key);
    if (!is_list(array, path, "objects")) return;
    for (size_t i = 0; i < array.size() && !error_; ++i)
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

  RelationKind relation_kind(const Json& json, const Path& path) {
    if (json == "equal") return RelationKind::equal;
    if (json == "free") return RelationKind::free;
    if (json != "above") fail(path, "must be \"equal\", \"above\" or \"free\"");
    return RelationKind::above;
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
  std::optional<Error> error_;
  std::map<std::string, int> index_;
  size_t point_count_ = 0;
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
