#include "io/scribbles/read_scribbles.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "io/scene/json_parse.h"

namespace relievo {
namespace {

using Json = nlohmann::json;

/// Turns JSON values into scribbles; the first failure is kept.
class ScribbleReader {
 public:
  explicit ScribbleReader(const ScribbleLimits& limits) : limits_(limits) {}

  Result<Scribbles> read(const Json& json) {
    if (!json.is_object() || json.value("format", Json()) != "relievo-scribbles")
      return Error{ErrorCode::bad_input, "is not a scribble file", "format"};
    if (json.value("version", Json()) != 1)
      return Error{ErrorCode::bad_input, "this program reads version 1 only", "version"};
    if (has_keys(json, {"format", "version", "parts", "strokes"}, 4, "")) {
      read_parts(json["parts"]);
      read_strokes(json["strokes"]);
    }
    if (error_) return *error_;
    return std::move(scribbles_);
  }

 private:
  void fail(const std::string& where, const std::string& message,
            ErrorCode code = ErrorCode::bad_input) {
    if (!error_) error_ = Error{code, message, where};
  }

  /// Whether an object has the first `required` of these keys and no others.
  bool has_keys(const Json& json, const std::vector<std::string>& known, size_t required,
                const std::string& where) {
    if (!json.is_object()) fail(where, "must be an object { ... }");
    for (size_t k = 0; k < required && !error_; ++k)
      if (!json.contains(known[k])) fail(where + known[k], "is missing");
    if (error_) return false;
    for (const auto& item : json.items())
      if (std::find(known.begin(), known.end(), item.key()) == known.end())
        fail(where + item.key(), "is not a known key; remove it or correct its name");
    return !error_;
  }

  void read_parts(const Json& json) {
    if (!json.is_array()) return fail("parts", "must be a list of ids");
    for (const Json& id : json) {
      if (!id.is_string() || id.get<std::string>().empty())
        return fail("parts", "must be ids in quotes");
      if (index_of(id.get<std::string>()) >= 0)
        return fail("parts", "has the id \"" + id.get<std::string>() + "\" twice");
      scribbles_.parts.push_back(id.get<std::string>());
    }
  }

  int index_of(const std::string& id) const {
    const auto found = std::find(scribbles_.parts.begin(), scribbles_.parts.end(), id);
    return found == scribbles_.parts.end() ? -1
                                           : static_cast<int>(found - scribbles_.parts.begin());
  }

  void read_strokes(const Json& json) {
    if (error_) return;
    if (!json.is_array()) return fail("strokes", "must be a list of strokes");
    if (json.size() > limits_.max_strokes) return fail("strokes", "are too many", ErrorCode::limit);
    for (size_t k = 0; k < json.size() && !error_; ++k)
      read_stroke(json[k], "strokes[" + std::to_string(k) + "].");
  }

  void read_stroke(const Json& json, const std::string& where) {
    if (!has_keys(json, {"kind", "width", "points", "part"}, 3, where)) return;
    Scribble stroke;
    stroke.kind = kind(json["kind"], where + "kind");
    const bool for_part = stroke.kind == ScribbleKind::soft || stroke.kind == ScribbleKind::hard;
    if (json.contains("part") != for_part)
      return fail(where + "part", for_part ? "is missing" : "belongs to soft and hard strokes");
    if (for_part && json["part"].is_string()) stroke.part = index_of(json["part"]);
    if (for_part && (!json["part"].is_string() || stroke.part < 0))
      return fail(where + "part", "is not one of the parts");
    stroke.width = number(json["width"], where + "width");
    if (!(stroke.width > 0 && stroke.width <= 1000))
      return fail(where + "width", "must lie in (0, 1000] px");
    read_points(json["points"], where + "points", stroke);
    scribbles_.strokes.push_back(std::move(stroke));
  }

  ScribbleKind kind(const Json& json, const std::string& where) {
    if (json == "soft") return ScribbleKind::soft;
    if (json == "outside") return ScribbleKind::outside;
    if (json == "hole") return ScribbleKind::hole;
    if (json != "hard") fail(where, "must be \"soft\", \"hard\", \"outside\" or \"hole\"");
    return ScribbleKind::hard;
  }

  double number(const Json& json, const std::string& where) {
    if (json.is_number() && std::abs(json.get<double>()) < 1e6) return json.get<double>();
    fail(where, "must be a number of px");
    return 0;
  }

  void read_points(const Json& json, const std::string& where, Scribble& stroke) {
    if (!json.is_array() || json.empty()) return fail(where, "must be points [[x, y], ...]");
    point_count_ += json.size();
    if (point_count_ > limits_.max_points) return fail(where, "are too many", ErrorCode::limit);
    for (const Json& point : json) {
      if (!point.is_array() || point.size() != 2) return fail(where, "must be points [x, y]");
      stroke.points.push_back(Point2{number(point[0], where), number(point[1], where)});
    }
  }

  const ScribbleLimits& limits_;
  Scribbles scribbles_;
  std::optional<Error> error_;
  size_t point_count_ = 0;
};

}  // namespace

Result<Scribbles> read_scribbles(std::string_view json, const ScribbleLimits& limits) {
  JsonLimits json_limits;
  json_limits.max_bytes = limits.max_bytes;
  const auto parsed = parse_json(json, json_limits);
  if (!parsed) return parsed.error();
  return ScribbleReader(limits).read(*parsed);
}

}  // namespace relievo
