#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"

namespace relievo {

constexpr double max_coordinate = 1e6;  ///< bound of every coordinate and canvas side, px
constexpr double min_canvas = 1e-3;     ///< least canvas side, px
constexpr double min_inflation = 1e-3;  ///< bounds of c and |d|
constexpr double max_inflation = 1e3;
constexpr double max_lean = 2;      ///< bound of both numbers of a lean
constexpr double max_rho = 1e3;     ///< bound of rho
constexpr double min_bulge = 0.05;  ///< bounds of the value of a bulge
constexpr double max_bulge = 10;
constexpr double max_cue_angle = 75;  ///< bound of the magnitude of the angle of a slope or crease
constexpr int max_cues = 256;
constexpr int max_cue_points = 1000;  ///< of one cue

/// A semantically meaningful region of the drawing, completed where occluded [P §3].
struct Part {
  std::string id;   ///< unique, 1 to 200 bytes of UTF-8 without control characters
  Outline outline;  ///< canvas px, non-zero rule, at least one ring with area
  double c = 4;     ///< amount of inflation (4: a disc becomes a hemisphere) [P eq 1]
  double d = 1;     ///< depth scale, not 0; negative inflates away from the viewer [P eq 8]
  double flat = 0;  ///< profile, 0 (semi-elliptical) to 1 (a flat top with round edges)
  Point2 lean{};    ///< how much nearer it comes per px to the right (x) and downwards (y)
};

/// An interconnection line [P Fig. 3, blue]: along it the upper part is seamlessly one surface
/// with the lower one.
struct Join {
  int upper = -1;            ///< index of the part in front
  int lower = -1;            ///< index of the part behind
  std::vector<Point2> line;  ///< polyline near the upper part's outline, at least 2 points, px
};

/// `equal` holds where the lower part is the nearest behind; where another lies between, as
/// `above`. `below`, only of a range, puts the upper part behind the lower one there. `joined` is
/// the join of a lower part that grows out from behind the upper one, as a far leg does: both meet
/// along the upper outline, which stays an edge of the surface. Heights are as with `equal`.
enum class RelationKind { equal, above, free, below, joined };

/// Whether the kind makes heights equal along the upper outline.
constexpr bool is_tie(RelationKind kind) {
  return kind == RelationKind::equal || kind == RelationKind::joined;
}

/// The kind as scene files spell it.
const char* name(RelationKind kind);

/// What holds between two overlapping parts instead of the default [P eq 11].
struct Relation {
  int upper = -1;
  int lower = -1;
  RelationKind kind = RelationKind::above;
  /// Restricts the relation to the run of the upper outline from the first to the second point,
  /// in the direction of the outline; everywhere when absent.
  std::optional<std::pair<Point2, Point2>> range;
};

/// A run of the upper outline inside the lower part along which alpha goes from alpha0 at `from`
/// to 1 at `to`, linear in arc length [P eq 9, Fig. 5]; the shorter way round the outline.
struct RobinRange {
  int upper = -1;
  int lower = -1;
  Point2 from;
  Point2 to;
  std::optional<double> alpha0;  ///< in [0, 1); default of the options when absent
  std::optional<double> rho;     ///< length scale / range length, > 0; likewise
};

enum class CueKind {
  bulge,   ///< value: factor by which round parts are higher there
  slope,   ///< value: degrees by which the surface rises along the line
  crease,  ///< value: degrees by which it rises to the line from both sides; negative: a fold
           ///< inwards
};

/// The kind as scene files spell it.
const char* name(CueKind kind);

/// What the profile of a part is like along a line on it [P §5, after Yeh et al. 2017]; it acts
/// where the line lies in the part.
struct Cue {
  int part = -1;  ///< index
  CueKind kind = CueKind::bulge;
  std::vector<Point2> line;  ///< polyline, at least 2 points, px
  double value = 1;
};

/// Whether the value lies within the bounds of its kind.
bool has_sound_value(const Cue& cue);

/// Everything that is known of a drawing before reconstruction.
struct Scene {
  double width = 0;         ///< canvas, px
  double height = 0;        ///< canvas, px
  std::string drawing;      ///< path inside the scene file's folder, with '/'; may be empty
  std::vector<Part> parts;  ///< back to front
  std::vector<Join> joins;
  std::vector<Relation> relations;
  std::vector<RobinRange> robin;
  std::vector<Cue> cues;
};

/// Makes relations of the joins whose upper part lies behind the lower one: such a limb is joined
/// along the run of the front part's outline that the line follows. Joins without a line, or of
/// parts that do not exist, stay. Linear in points, times those of the lines.
void turn_joins_from_behind(Scene& scene);

/// Checks what the types cannot say: a canvas and coordinates in bounds, unique ids,
/// indices in range, outlines with area, upper in front of lower, ranges where they are needed,
/// sound c, d, alpha0, rho and cues. The error's code is bad_input and its `where` the path of the
/// offending key, such as "parts[2].outline[0][5]". Linear in points.
Status validate(const Scene& scene);

}  // namespace relievo
