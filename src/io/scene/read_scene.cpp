#include "io/scene/read_scene.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "io/scene/annotation_reader.h"
#include "io/scene/json_parse.h"
#include "io/scene/json_reader.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

using Json = nlohmann::json;
using Path = JsonPath;

/// Turns JSON values into a scene. The first failure is kept; after it, whatever is returned is
/// of no use and is thrown away by the caller.
class SceneReader final : public AnnotationReader {
 public:
  explicit SceneReader(const SceneLimits& limits)
      : AnnotationReader(limits.max_points), limits_(limits) {}

  Scene scene(const Json& json) {
    const Path root;
    Scene scene;
    if (!json.is_object()) {
      fail(root, "is not a scene: the file must hold one JSON object");
      return scene;
    }
    check_format(json, root);
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
    if (!keys(json, path, {"id", "outline"}, {"c", "d", "flat", "lean"})) return part;
    part.id = text(json["id"], path.member("id"));
    if (json.contains("c")) part.c = number(json["c"], path.member("c"));
    if (json.contains("d")) part.d = number(json["d"], path.member("d"));
    if (json.contains("flat")) part.flat = number(json["flat"], path.member("flat"));
    if (json.contains("lean")) part.lean = point(json["lean"], path.member("lean"));
    part.outline = outline(json["outline"], path.member("outline"));
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
