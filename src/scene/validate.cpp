#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "kernel/base/text_rules.h"
#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"

namespace relievo {
namespace {

Error bad(std::string where, std::string message, Culprit culprit = {}) {
  return {ErrorCode::bad_input, std::move(message), std::move(where), culprit};
}

/// An error about a key of a culprit, such as ".outline[0]".
Error bad(Culprit culprit, const std::string& key, std::string message) {
  return bad(to_string(culprit) + key, std::move(message), culprit);
}

std::string element(size_t index) { return "[" + std::to_string(index) + "]"; }

bool in_range(Point2 p) {
  // Written so that a NaN is out of range.
  return std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate;
}

Error out_of_range(Culprit culprit, const std::string& key) {
  return bad(culprit, key, "a coordinate is not a number within ±1000000 px");
}

/// Returns whether the points of a ring do not all lie on one line.
bool has_area(const Ring& ring) {
  if (ring.size() < 3) return false;
  const auto other =
      std::find_if(ring.begin(), ring.end(), [&](Point2 p) { return !(p == ring[0]); });
  if (other == ring.end()) return false;
  const Point2 along = *other - ring[0];
  return std::any_of(other, ring.end(), [&](Point2 p) { return cross(along, p - ring[0]) != 0; });
}

Status check_canvas(const Scene& scene) {
  for (const auto& [key, side] :
       {std::pair{"canvas.width", scene.width}, std::pair{"canvas.height", scene.height}})
    if (!(side >= min_canvas && side <= max_coordinate))
      return bad(key, "must be a number of px, at least 0.001 and at most 1000000");
  return Done{};
}

Status check_outline(const Outline& outline, Culprit part) {
  if (outline.empty())
    return bad(part, ".outline", "has no ring; give at least one list of points");
  for (size_t r = 0; r < outline.size(); ++r) {
    const std::string ring = ".outline" + element(r);
    for (size_t i = 0; i < outline[r].size(); ++i)
      if (!in_range(outline[r][i])) return out_of_range(part, ring + element(i));
    if (!has_area(outline[r]))
      return bad(part, ring, "has no area; a ring needs three points that are not on one line");
  }
  return Done{};
}

Status check_part(const Part& part, Culprit culprit) {
  if (!is_sound_id(part.id))
    return bad(culprit, ".id", "must be 1 to 200 bytes of UTF-8 text without control characters");
  if (!(part.c >= min_inflation && part.c <= max_inflation))
    return bad(culprit, ".c", "must be a number from 0.001 to 1000");
  if (!(std::abs(part.d) >= min_inflation && std::abs(part.d) <= max_inflation))
    return bad(culprit, ".d", "must be a number with a magnitude from 0.001 to 1000");
  if (!(part.flat >= 0 && part.flat <= 1))
    return bad(culprit, ".flat", "must be a number from 0 to 1");
  if (!(std::abs(part.lean.x) <= max_lean && std::abs(part.lean.y) <= max_lean))
    return bad(culprit, ".lean", "must be two numbers from -2 to 2");
  return check_outline(part.outline, culprit);
}

Status check_parts(const Scene& scene) {
  if (scene.parts.empty()) return bad("parts", "is empty; a scene needs at least one part");
  std::map<std::string_view, Culprit> first;
  for (size_t i = 0; i < scene.parts.size(); ++i) {
    const Part& part = scene.parts[i];
    const Culprit culprit{CulpritList::parts, i};
    if (Status status = check_part(part, culprit); !status) return status;
    if (const auto [known, added] = first.emplace(part.id, culprit); !added)
      return bad(culprit, ".id",
                 "the id \"" + part.id + "\" is taken by " + to_string(known->second));
  }
  return Done{};
}

Status check_pair(const Scene& scene, int upper, int lower, Culprit culprit) {
  const int count = static_cast<int>(scene.parts.size());
  if (upper < 0 || upper >= count) return bad(culprit, ".upper", "names no part of the scene");
  if (lower < 0 || lower >= count) return bad(culprit, ".lower", "names no part of the scene");
  if (upper == lower) return bad(culprit, "", "upper and lower are the same part");
  if (upper < lower)
    return bad(culprit, "",
               "upper \"" + scene.parts[upper].id + "\" lies behind lower \"" +
                   scene.parts[lower].id + "\"; swap them, or the order of the parts");
  return Done{};
}

Status check_line(const std::vector<Point2>& line, Culprit culprit) {
  for (size_t k = 0; k < line.size(); ++k)
    if (!in_range(line[k])) return out_of_range(culprit, ".line" + element(k));
  const bool has_length =
      std::any_of(line.begin(), line.end(), [&](Point2 p) { return !(p == line[0]); });
  if (!has_length) return bad(culprit, ".line", "has no length; give at least two points");
  return Done{};
}

Status check_joins(const Scene& scene) {
  for (size_t i = 0; i < scene.joins.size(); ++i) {
    const Join& join = scene.joins[i];
    const Culprit culprit{CulpritList::joins, i};
    if (Status pair = check_pair(scene, join.upper, join.lower, culprit); !pair) return pair;
    if (Status line = check_line(join.line, culprit); !line) return line;
  }
  return Done{};
}

Status check_relations(const Scene& scene) {
  for (size_t i = 0; i < scene.relations.size(); ++i) {
    const Relation& relation = scene.relations[i];
    const Culprit culprit{CulpritList::relations, i};
    if (Status pair = check_pair(scene, relation.upper, relation.lower, culprit); !pair)
      return pair;
    if (!relation.range && relation.kind == RelationKind::below)
      return bad(culprit, ".range",
                 "\"below\" needs a range; where it holds everywhere, swap the order of the parts");
    if (!relation.range) continue;
    if (!in_range(relation.range->first)) return out_of_range(culprit, ".range[0]");
    if (!in_range(relation.range->second)) return out_of_range(culprit, ".range[1]");
    if (relation.range->first == relation.range->second)
      return bad(culprit, ".range", "begins where it ends; give two different points");
  }
  return Done{};
}

Status check_robin(const Scene& scene) {
  for (size_t i = 0; i < scene.robin.size(); ++i) {
    const RobinRange& range = scene.robin[i];
    const Culprit culprit{CulpritList::robin, i};
    if (Status pair = check_pair(scene, range.upper, range.lower, culprit); !pair) return pair;
    if (!in_range(range.from)) return out_of_range(culprit, ".from");
    if (!in_range(range.to)) return out_of_range(culprit, ".to");
    if (range.from == range.to)
      return bad(culprit, "", "begins where it ends; give two different points");
    if (range.alpha0 && !(*range.alpha0 >= 0 && *range.alpha0 < 1))
      return bad(culprit, ".alpha0", "must be at least 0 and below 1");
    if (range.rho && !(*range.rho > 0 && *range.rho <= max_rho))
      return bad(culprit, ".rho", "must be above 0 and at most 1000");
  }
  return Done{};
}

Status check_cues(const Scene& scene) {
  if (scene.cues.size() > max_cues) return bad("cues", "has more than 256 cues");
  for (size_t i = 0; i < scene.cues.size(); ++i) {
    const Cue& cue = scene.cues[i];
    const Culprit culprit{CulpritList::cues, i};
    if (cue.part < 0 || cue.part >= static_cast<int>(scene.parts.size()))
      return bad(culprit, ".part", "names no part of the scene");
    if (cue.line.size() > max_cue_points) return bad(culprit, ".line", "has more than 1000 points");
    if (Status line = check_line(cue.line, culprit); !line) return line;
    if (!has_sound_value(cue))
      return bad(culprit, ".value",
                 cue.kind == CueKind::bulge ? "must be a number from 0.05 to 10"
                                            : "must be a number of degrees from -75 to 75");
  }
  return Done{};
}

Status check_drawing(const Scene& scene) {
  if (scene.drawing.empty() || is_path_inside(scene.drawing)) return Done{};
  return bad("drawing",
             "must be a relative path inside the scene's own folder, written with '/' and without "
             "'..'");
}

/// Returns the ring with the least sum of distances from the points of the line. Precondition: the
/// outline has a ring.
const Ring& followed_ring(const Outline& outline, const std::vector<Point2>& line) {
  const auto gap = [&](const Ring& ring) {
    const RingMeasure m = measure(ring);
    double sum = 0;
    for (const Point2 p : line) sum += nearest_on_ring(ring, m, p).distance;
    return sum;
  };
  return *std::min_element(outline.begin(), outline.end(),
                           [&](const Ring& a, const Ring& b) { return gap(a) < gap(b); });
}

/// Returns whether the points of the ring nearest to those of the line follow its direction.
bool runs_forward(const Ring& ring, const std::vector<Point2>& line) {
  const RingMeasure m = measure(ring);
  const auto foot = [&](Point2 p) { return nearest_on_ring(ring, m, p).s; };
  double forward = 0;
  for (size_t i = 0; i + 1 < line.size(); ++i)
    forward += std::remainder(foot(line[i + 1]) - foot(line[i]), m.length);
  return forward >= 0;
}

/// Returns the relation that a join of a limb behind the part with the outline `front` stands for.
Relation from_behind(const Join& join, Outline front) {
  orient_by_nesting(front);
  Relation relation{join.lower, join.upper, RelationKind::joined, {}};
  relation.range = {join.line.front(), join.line.back()};
  if (!runs_forward(followed_ring(front, join.line), join.line))
    std::swap(relation.range->first, relation.range->second);
  return relation;
}

}  // namespace

void turn_joins_from_behind(Scene& scene) {
  const int count = static_cast<int>(scene.parts.size());
  std::erase_if(scene.joins, [&](const Join& join) {
    if (join.upper < 0 || join.upper >= join.lower || join.lower >= count) return false;
    const Outline& front = scene.parts[join.lower].outline;
    if (join.line.size() < 2 || front.empty()) return false;
    scene.relations.push_back(from_behind(join, front));
    return true;
  });
}

Status validate(const Scene& scene) {
  for (const auto check : {check_canvas, check_drawing, check_parts, check_joins, check_relations,
                           check_robin, check_cues})
    if (Status status = check(scene); !status) return status;
  return Done{};
}

bool has_sound_value(const Cue& cue) {
  if (cue.kind == CueKind::bulge) return cue.value >= min_bulge && cue.value <= max_bulge;
  return std::abs(cue.value) <= max_cue_angle;
}

const char* name(RelationKind kind) {
  switch (kind) {
    case RelationKind::equal:
      return "equal";
    case RelationKind::above:
      return "above";
    case RelationKind::free:
      return "free";
    case RelationKind::below:
      return "below";
    case RelationKind::joined:
      return "joined";
  }
  return "";
}

const char* name(CueKind kind) {
  switch (kind) {
    case CueKind::bulge:
      return "bulge";
    case CueKind::slope:
      return "slope";
    case CueKind::crease:
      return "crease";
  }
  return "";
}

}  // namespace relievo
