#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "io/scene/json_reader.h"
#include "understanding/labels/scribbles.h"

namespace relievo {

struct ScribbleLimits {
  size_t max_bytes = size_t{16} << 20;
  size_t max_strokes = 100'000;
  size_t max_points = 1'000'000;  ///< of all strokes together
};

/// Reads strokes as scribble files and project files have them: the lists `parts` and `strokes` of
/// an object, whether the parts are `complete`, and the `count` of parts that is wanted. Strokes of
/// parts name one of `parts`, the others none; coordinates and widths are bounded, so that what
/// follows need not mind.
class ScribblesReader final : public JsonReader {
 public:
  explicit ScribblesReader(const ScribbleLimits& limits)
      : JsonReader(limits.max_points), max_strokes_(limits.max_strokes) {}

  /// A whole scribble file; complete unless it says otherwise.
  understanding::Scribbles file(const Json& json);

  /// The object that a project has; complete where it says so.
  understanding::Scribbles object(const Json& json, const JsonPath& path);

 private:
  understanding::Scribbles lists(const Json& json, const JsonPath& path, bool complete);
  int count(const Json& json, const JsonPath& path);
  void read_parts(const Json& json, const JsonPath& path);
  void read_strokes(const Json& json, const JsonPath& path);
  understanding::Scribble stroke(const Json& json, const JsonPath& path);
  understanding::ScribbleKind kind(const Json& json, const JsonPath& path);
  int part(const Json& json, const JsonPath& path);
  double width(const Json& json, const JsonPath& path);
  std::vector<Point2> line(const Json& json, const JsonPath& path);

  size_t max_strokes_;
  understanding::Scribbles scribbles_;
};

}  // namespace relievo
