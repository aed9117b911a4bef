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
constexpr double max_lean = 2;      ///< bound of both slopes of a tilt
constexpr double max_rho = 1e3;     ///< bound of rho
constexpr double min_bulge = 0.05;  ///< bounds of the value of a bulge
constexpr double max_bulge = 10;
constexpr double max_cue_angle = 75;  ///< degrees, bound of |angle| of a slope or crease
constexpr int max_cues = 256;
constexpr int max_cue_points = 1000;  ///< of the line of one cue

/// A semantically meaningful region of the drawing, completed where occluded [P §3].
struct Part {
  std::string id;   ///< unique, 1 to 200 bytes of UTF-8 without control characters
  Outline outline;  ///< canvas px, non-zero rule, at least one ring with area
  double c = 4;     ///< amount of inflation (4: a disc becomes a hemisphere) [P eq 1]
  double d = 1;     ///< depth scale, not 0; negative inflates away from the viewer [P eq 8]
  double flat = 0;  ///< profile, 0 (semi-elliptical) to 1 (a flat top with round edges)
  Point2 lean{};    ///< tilt: rise towards the viewer per px to the right (x) and downwards (y)
};

/// An interconnection line [P Fig. 3, blue]: along it the upper part is seamlessly one surface
/// with the lower one.
struct Join {
  int upper = -1;            ///< index of the part in front
  int lower = -1;            ///< index of the part behind
  std::vector<Point2> line;  ///< polyline near the upper part's outline, at least 2 points, px
};

/// The relation of two overlapping parts along the upper outline.
enum class RelationKind {
  equal,   ///< heights are equal if no other part lies between, else as `above`
  above,   ///< the upper part is in front
  free,    ///< heights are not related
  below,   ///< the upper part is behind; only with a range
  joined,  ///< heights are equal, at an edge of the surface: the lower part grows out from behind
           ///< the upper one, as a far leg does
};

/// Returns whether the kind makes heights equal along the upper outline.
constexpr bool is_tie(RelationKind kind) {
  return kind == RelationKind::equal || kind == RelationKind::joined;
}

/// Returns the kind as scene files spell it.
const char* name(RelationKind kind);

/// A relation of two overlapping parts in place of the default [P eq 11].
struct Relation {
  int upper = -1;
  int lower = -1;
  RelationKind kind = RelationKind::above;
  /// The run of the upper outline for which the relation holds, from the first to the second point
  /// in the direction of the outline; default: all of it.
  std::optional<std::pair<Point2, Point2>> range;
};

/// A run of the upper outline inside the lower part along which alpha rises from alpha0 at `from`
/// to 1 at `to`, linear in arc length [P eq 9, Fig. 5]; the shorter way round the outline.
struct RobinRange {
  int upper = -1;
  int lower = -1;
  Point2 from;
  Point2 to;
  std::optional<double> alpha0;  ///< in [0, 1); default: that of the options
  std::optional<double> rho;     ///< length scale / range length, > 0; default: that of the options
};

enum class CueKind {
  bulge,   ///< value: factor of the height of round parts
  slope,   ///< value: degrees by which the surface rises along the line
  crease,  ///< value: degrees by which the surface rises to the line from both sides; negative: a
           ///< fold inwards
};

/// Returns the kind as scene files spell it.
const char* name(CueKind kind);

/// A cue for the profile of a part along a line on it [P §5, after Yeh et al. 2017]. Only the run
/// of the line inside the part counts.
struct Cue {
  int part = -1;  ///< index
  CueKind kind = CueKind::bulge;
  std::vector<Point2> line;  ///< polyline, at least 2 points, px
  double value = 1;
};

/// Returns whether the value lies within the bounds of its kind.
bool has_sound_value(const Cue& cue);

/// The annotations of a drawing: the input of reconstruction.
struct Scene {
  double width = 0;         ///< canvas, px
  double height = 0;        ///< canvas, px
  std::string drawing;      ///< path inside the scene file's folder, with '/', or empty
  std::vector<Part> parts;  ///< back to front
  std::vector<Join> joins;
  std::vector<Relation> relations;
  std::vector<RobinRange> robin;
  std::vector<Cue> cues;
};

/// Turns joins whose upper part lies behind the lower one into relations: such a limb is joined
/// along the run of the front part's outline that the line follows. Joins without a line, or of
/// parts that do not exist, stay. Linear in the points of outlines times those of lines.
void turn_joins_from_behind(Scene& scene);

/// Checks that canvas and coordinates are in bounds, ids unique, indices in range, outlines have
/// area, upper parts are in front of lower ones, ranges are there if they are needed, and c, d,
/// alpha0, rho and cues are in bounds. The error's code is bad_input and its `where` the path of
/// the offending key, such as "parts[2].outline[0][5]". Linear in points.
Status validate(const Scene& scene);

}  // namespace relievo
