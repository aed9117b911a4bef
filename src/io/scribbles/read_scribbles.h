#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/scene/json_reader.h"
#include "relief/drawing/scribbles.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

struct ScribbleLimits {
  size_t max_bytes = size_t{16} << 20;
  size_t max_strokes = 100'000;
  size_t max_points = 1'000'000;  ///< of all strokes together
};

/// A scribble file, version 1: {"format": "relievo-scribbles", "version": 1, "parts": [id, ...],
/// "strokes": [{"kind": "soft" | "hard" | "outside" | "hole", "part": id, "width": px, "points":
/// [[x, y], ...]}, ...]} in drawing px. `part` belongs to soft and hard strokes only. "complete":
/// false leaves what no stroke touches as it is proposed. Errors:
/// `bad_input` with the place in `where`, `limit`.
Result<Scribbles> read_scribbles(std::string_view json, const ScribbleLimits& limits = {});

/// Reads strokes as scribble files and project files have them: the lists `parts` and `strokes` of
/// an object, whether the parts are `complete`, and the `count` of parts that is wanted. Strokes of
/// parts name one of `parts`, the others none; coordinates and widths are bounded, so that what
/// follows need not mind.
class ScribblesReader final : public JsonReader {
 public:
  explicit ScribblesReader(const ScribbleLimits& limits)
      : JsonReader(limits.max_points), max_strokes_(limits.max_strokes) {}

  /// A whole scribble file; complete unless it says otherwise.
  Scribbles file(const Json& json);

  /// The object that a project has; complete where it says so.
  Scribbles object(const Json& json, const JsonPath& path);

 private:
  Scribbles lists(const Json& json, const JsonPath& path, bool complete);
  int count(const Json& json, const JsonPath& path);
  void read_parts(const Json& json, const JsonPath& path);
  void read_strokes(const Json& json, const JsonPath& path);
  Scribble stroke(const Json& json, const JsonPath& path);
  ScribbleKind kind(const Json& json, const JsonPath& path);
  int part(const Json& json, const JsonPath& path);
  double width(const Json& json, const JsonPath& path);
  std::vector<Point2> line(const Json& json, const JsonPath& path);

  size_t max_strokes_;
  Scribbles scribbles_;
};

/// A stroke as these files have it.
nlohmann::ordered_json stroke_json(const Scribble& stroke, const Scribbles& scribbles);

/// Reads strokes from a picture painted over the drawing (RGBA, 4 channels, the drawing's size):
///   transparent or white       nothing
///   black                      outside
///   mid grey (128, 128, 128)   hole
///   any other colour           a part; its id is the colour, as "#ff8000"
/// Opaque colours are hard strokes, half transparent ones (alpha 64 to 191) soft. Only colours that
/// fill a square of 3 x 3 px somewhere count, so that the blended rims of strokes say nothing.
/// Parts come in the order of their first pixels. Pixels of one colour that hang together become
/// one stroke of width 1 that covers exactly them. Such strokes are complete.
/// Errors: `bad_input` where the sizes differ or no colour counts, `limit` above 1000 colours.
Result<Scribbles> scribbles_from_image(const Image8& rgba, int width, int height);

}  // namespace relievo
