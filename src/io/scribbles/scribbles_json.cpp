#include "io/scribbles/scribbles_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/scene/json_parse.h"
#include "io/scene/json_reader.h"
#include "io/scribbles/read_scribbles.h"

namespace relievo {
namespace {

/// In the order of ScribbleKind.
constexpr std::array<const char*, 4> kind_names = {"soft", "hard", "outside", "hole"};

const char* name_of(understanding::ScribbleKind kind) {
  return kind_names[static_cast<size_t>(kind)];
}

}  // namespace

understanding::Scribbles ScribblesReader::file(const Json& json) {
  const JsonPath root;
  if (!json.is_object() || json.value("format", Json()) != "relievo-scribbles")
    fail(root.member("format"), "is not a scribble file");
  else if (json.value("version", Json()) != 1)
    fail(root.member("version"), "this program reads version 1 only");
  else if (keys(json, root, {"format", "version", "parts", "strokes"}, {"complete", "count"}))
    return lists(json, root, true);
  return {};
}

understanding::Scribbles ScribblesReader::object(const Json& json, const JsonPath& path) {
  return keys(json, path, {"parts", "strokes"}, {"complete", "count"}) ? lists(json, path, false)
                                                                       : understanding::Scribbles();
}

understanding::Scribbles ScribblesReader::lists(const Json& json, const JsonPath& path,
                                                bool complete) {
  scribbles_ = {};
  scribbles_.complete = complete;
  if (json.contains("complete")) {
    if (!json["complete"].is_boolean()) fail(path.member("complete"), "must be true or false");
    scribbles_.complete = json["complete"] == true;
  }
  if (json.contains("count")) scribbles_.count = count(json["count"], path.member("count"));
  read_parts(json["parts"], path.member("parts"));
  read_strokes(json["strokes"], path.member("strokes"));
  return std::move(scribbles_);
}

int ScribblesReader::count(const Json& json, const JsonPath& path) {
  const bool sound = json.is_number_integer() && json >= 1 && json <= 1000;
  if (!sound) fail(path, "must be a whole number of parts from 1 to 1000");
  return sound ? json.get<int>() : 0;
}

void ScribblesReader::read_parts(const Json& json, const JsonPath& path) {
  if (!is_list(json, path, "ids")) return;
  std::vector<std::string>& parts = scribbles_.parts;
  for (size_t k = 0; k < json.size() && !error(); ++k) {
    std::string id = text(json[k], path.element(k));
    if (!error() && id.empty()) fail(path.element(k), "is empty");
    if (std::find(parts.begin(), parts.end(), id) != parts.end())
      fail(path.element(k), "has the id \"" + id + "\" a second time");
    parts.push_back(std::move(id));
  }
}

void ScribblesReader::read_strokes(const Json& json, const JsonPath& path) {
  if (error() || !is_list(json, path, "strokes")) return;
  if (json.size() > max_strokes_) return fail(path, "are too many", ErrorCode::limit);
  for (size_t k = 0; k < json.size() && !error(); ++k)
    scribbles_.strokes.push_back(stroke(json[k], path.element(k)));
}

understanding::Scribble ScribblesReader::stroke(const Json& json, const JsonPath& path) {
  understanding::Scribble stroke;
  if (!keys(json, path, {"kind", "width", "points"}, {"part"})) return stroke;
  stroke.kind = kind(json["kind"], path.member("kind"));
  if (is_for_part(stroke.kind) != json.contains("part"))
    fail(path.member("part"),
         is_for_part(stroke.kind) ? "is missing" : "belongs to soft and hard strokes");
  if (error()) return stroke;
  if (is_for_part(stroke.kind)) stroke.part = part(json["part"], path.member("part"));
  stroke.width = width(json["width"], path.member("width"));
  stroke.points = line(json["points"], path.member("points"));
  return stroke;
}

understanding::ScribbleKind ScribblesReader::kind(const Json& json, const JsonPath& path) {
  for (const understanding::ScribbleKind kind :
       {understanding::ScribbleKind::soft, understanding::ScribbleKind::hard,
        understanding::ScribbleKind::outside, understanding::ScribbleKind::hole})
    if (json == name_of(kind)) return kind;
  fail(path, "must be \"soft\", \"hard\", \"outside\" or \"hole\"");
  return understanding::ScribbleKind::hard;
}

int ScribblesReader::part(const Json& json, const JsonPath& path) {
  const auto found = std::find(scribbles_.parts.begin(), scribbles_.parts.end(), text(json, path));
  if (!error() && found == scribbles_.parts.end()) fail(path, "is not one of the parts");
  return error() ? 0 : static_cast<int>(found - scribbles_.parts.begin());
}

double ScribblesReader::width(const Json& json, const JsonPath& path) {
  const double value = number(json, path);
  if (!(value > 0 && value < max_coordinate))
    fail(path, "must be positive, and less than a million px");
  return value;
}

std::vector<Point2> ScribblesReader::line(const Json& json, const JsonPath& path) {
  std::vector<Point2> list = points(json, path);
  if (!error() && list.empty()) fail(path, "has no points");
  for (size_t k = 0; k < list.size(); ++k)
    if (!(std::max(std::abs(list[k].x), std::abs(list[k].y)) < max_coordinate))
      fail(path.element(k), "lies farther than a million px away");
  return list;
}

nlohmann::ordered_json stroke_json(const understanding::Scribble& stroke,
                                   const understanding::Scribbles& scribbles) {
  nlohmann::ordered_json json;
  json["kind"] = name_of(stroke.kind);
  if (is_for_part(stroke.kind)) json["part"] = scribbles.parts[stroke.part];
  json["width"] = stroke.width;
  json["points"] = nlohmann::ordered_json::array();
  for (const Point2 p : stroke.points) json["points"].push_back({p.x, p.y});
  return json;
}

Result<understanding::Scribbles> read_scribbles(std::string_view json,
                                                const ScribbleLimits& limits) {
  JsonLimits json_limits;
  json_limits.max_bytes = limits.max_bytes;
  const auto parsed = parse_json(json, json_limits);
  if (!parsed) return parsed.error();
  ScribblesReader reader(limits);
  understanding::Scribbles scribbles = reader.file(*parsed);
  if (reader.error()) return *reader.error();
  return scribbles;
}

}  // namespace relievo
