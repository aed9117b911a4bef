#include "io/scribbles/scribbles_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace relievo {
namespace {

using understanding::Scribble;
using understanding::ScribbleKind;
using understanding::Scribbles;

constexpr int max_count = 1000;

/// In the order of ScribbleKind.
const std::vector<const char*> kind_names = {"soft", "hard", "outside", "hole"};

class ScribblesReader final : public JsonReader {
 public:
  explicit ScribblesReader(const JsonLimits& limits)
      : JsonReader(limits.max_points), max_strokes_(limits.max_strokes) {}

  Scribbles file(const Json& json) {
    const JsonPath root;
    if (!is_file(json, "scribbles", 1)) return {};
    if (!keys(json, root, {"format", "version", "parts", "strokes"}, {"complete", "count"}))
      return {};
    return lists(json, root, true);
  }

  Scribbles object(const Json& json, const JsonPath& path) {
    if (!keys(json, path, {"parts", "strokes"}, {"complete", "count"})) return {};
    return lists(json, path, false);
  }

 private:
  Scribbles lists(const Json& json, const JsonPath& path, bool complete) {
    scribbles_.complete = complete;
    set(json, path, "complete", scribbles_.complete, &ScribblesReader::flag);
    if (json.contains("count"))
      scribbles_.count = whole_number(json["count"], path.member("count"), max_count);
    read_parts(json["parts"], path.member("parts"));
    if (!error() && json["strokes"].size() > max_strokes_)
      fail(path.member("strokes"), "holds more than " + std::to_string(max_strokes_) + " strokes",
           ErrorCode::limit);
    list(json, path, "strokes", scribbles_.strokes, &ScribblesReader::stroke);
    return std::move(scribbles_);
  }

  void read_parts(const Json& json, const JsonPath& path) {
    if (!is_list(json, path, "ids")) return;
    std::vector<std::string>& parts = scribbles_.parts;
    for (size_t k = 0; k < json.size() && !error(); ++k) {
      std::string id = text(json[k], path.element(k));
      if (!error() && id.empty()) fail(path.element(k), "is empty");
      if (std::find(parts.begin(), parts.end(), id) != parts.end())
        fail(path.element(k), "has the id \"" + id + "\", which an earlier part has");
      parts.push_back(std::move(id));
    }
  }

  Scribble stroke(const Json& json, const JsonPath& path) {
    Scribble stroke;
    if (!keys(json, path, {"kind", "width", "points"}, {"part"})) return stroke;
    stroke.kind = static_cast<ScribbleKind>(choice(json["kind"], path.member("kind"), kind_names));
    if (is_for_part(stroke.kind) != json.contains("part"))
      fail(path.member("part"),
           is_for_part(stroke.kind) ? "is missing" : "is for soft and hard strokes only");
    if (error()) return stroke;
    if (is_for_part(stroke.kind)) stroke.part = part_reference(json["part"], path.member("part"));
    stroke.width = width(json["width"], path.member("width"));
    stroke.points = line(json["points"], path.member("points"));
    return stroke;
  }

  int part_reference(const Json& json, const JsonPath& path) override {
    const std::string id = text(json, path);
    const auto found = std::find(scribbles_.parts.begin(), scribbles_.parts.end(), id);
    if (found == scribbles_.parts.end()) fail(path, "\"" + id + "\" is not in the list of parts");
    return error() ? 0 : static_cast<int>(found - scribbles_.parts.begin());
  }

  double width(const Json& json, const JsonPath& path) {
    const double value = number(json, path);
    if (!(value > 0 && value < max_coordinate))
      fail(path, "must be above 0 and below a million px");
    return value;
  }

  std::vector<Point2> line(const Json& json, const JsonPath& path) {
    std::vector<Point2> list = points(json, path);
    if (!error() && list.empty()) fail(path, "has no points");
    for (size_t k = 0; k < list.size(); ++k)
      if (!(std::max(std::abs(list[k].x), std::abs(list[k].y)) < max_coordinate))
        fail(path.element(k), "lies more than a million px away");
    return list;
  }

  size_t max_strokes_;
  Scribbles scribbles_;
};

}  // namespace

Result<Scribbles> read_scribbles(std::string_view json, const JsonLimits& limits) {
  const auto parsed = parse_json(json, limits);
  if (!parsed) return parsed.error();
  ScribblesReader reader(limits);
  Scribbles scribbles = reader.file(*parsed);
  if (reader.error()) return *reader.error();
  return scribbles;
}

Result<Scribbles> scribbles_of(const nlohmann::json& json, const JsonPath& path) {
  ScribblesReader reader({});
  Scribbles scribbles = reader.object(json, path);
  if (reader.error()) return *reader.error();
  return scribbles;
}

nlohmann::ordered_json stroke_json(const Scribble& stroke, const Scribbles& scribbles) {
  nlohmann::ordered_json json;
  json["kind"] = kind_names[static_cast<size_t>(stroke.kind)];
  if (is_for_part(stroke.kind)) json["part"] = scribbles.parts[stroke.part];
  json["width"] = stroke.width;
  json["points"] = nlohmann::ordered_json::array();
  for (const Point2 p : stroke.points) json["points"].push_back({p.x, p.y});
  return json;
}

}  // namespace relievo
