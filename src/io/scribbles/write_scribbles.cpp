#include "io/scribbles/write_scribbles.h"

#include <array>
#include <nlohmann/json.hpp>

namespace relievo {
namespace {

constexpr std::array<const char*, 4> kind_names = {"soft", "hard", "outside", "hole"};

nlohmann::ordered_json stroke_json(const Scribble& stroke, const Scribbles& scribbles) {
  nlohmann::ordered_json json;
  json["kind"] = kind_names[static_cast<size_t>(stroke.kind)];
  if (stroke.kind == ScribbleKind::soft || stroke.kind == ScribbleKind::hard)
    json["part"] = scribbles.parts[stroke.part];
  json["width"] = stroke.width;
  json["points"] = nlohmann::ordered_json::array();
  for (const Point2 p : stroke.points) json["points"].push_back({p.x, p.y});
  return json;
}

}  // namespace

std::string write_scribbles(const Scribbles& scribbles) {
  std::string text = "{\n  \"format\": \"relievo-scribbles\",\n  \"version\": 1,\n  \"parts\": ";
  text += nlohmann::json(scribbles.parts).dump() + ",\n  \"strokes\": [";
  for (size_t k = 0; k < scribbles.strokes.size(); ++k)
    text += (k > 0 ? ",\n    " : "\n    ") + stroke_json(scribbles.strokes[k], scribbles).dump();
  return text + "\n  ]\n}\n";
}

}  // namespace relievo
