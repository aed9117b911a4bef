#include "io/scene/read_scene.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "io/scene/json_parse.h"
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

}  // namespace relievo
