#include "support/ugly_scene.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/random_scene.h"

namespace relievo::testing {
namespace {

constexpr double side = 1000;

class UglyScene {
 public:
  explicit UglyScene(uint64_t seed) : random_(seed) {}

  Scene make() {
    scene_.width = scene_.height = side;
    const int parts = random_.integer(1, 7);
    for (int p = 0; p < parts; ++p) add_part();
    if (parts > 1) {
      const int most_joins = chance(0.5) ? 0 : chance(0.6) ? 2 : 6;
      for (int joins = random_.integer(0, most_joins); joins > 0; --joins) add_join();
      for (int relations = random_.integer(0, 3); relations > 0; --relations) add_relation();
      for (int ranges = random_.integer(0, 2); ranges > 0; --ranges) add_range();
    }
    if (chance(0.2)) add_cue();
    scale();
    return std::move(scene_);
  }

 private:
  bool chance(double share) { return random_.uniform(0, 1) < share; }

  Point2 place() { return {random_.uniform(0, side), random_.uniform(0, side)}; }

  /// A length between tiny and a third of the canvas, all magnitudes alike.
  double any_size() { return 300 * std::pow(10, random_.uniform(-11, 0)); }

  Ring star() {
    const int n = 2 * random_.integer(2, 20) + 1;
    const int step = random_.integer(1, (n - 1) / 2);
    const Point2 centre = place();
    const double radius = random_.uniform(20, 300);
    Ring ring;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * M_PI * i * step / n;
      ring.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
    }
    return ring;
  }

  Ring on_a_grid(double cell) {
    const auto line = [&] { return cell * random_.integer(1, static_cast<int>(side / cell) - 1); };
    const double x = line();
    const double y = line();
    return rectangle(x, y, x + cell * random_.integer(1, 4), y + cell * random_.integer(1, 4));
  }

  Ring tangle() {
    Ring ring;
    for (int n = random_.integer(3, 14); n > 0; --n) ring.push_back(place());
    return ring;
  }

  /// As another ring, all of it or with some points moved a little.
  Ring twin() {
    if (scene_.parts.empty()) return tangle();
    const Outline& outline = any_part().outline;
    Ring ring = outline[random_.integer(0, static_cast<int>(outline.size()) - 1)];
    const double shift = chance(0.4) ? 0 : any_size() / 30;
    const bool all = chance(0.5);
    for (Point2& p : ring)
      if (all || chance(0.3)) p = {p.x + shift, p.y - shift};
    if (chance(0.3)) std::reverse(ring.begin(), ring.end());
    return ring;
  }

  Ring comb() {
    const double gap = any_size();
    const Point2 at = place();
    Ring ring;
    const int teeth = random_.integer(2, 12);
    for (int i = 0; i < teeth; ++i) {
      ring.push_back({at.x + 2 * i * gap, at.y});
      ring.push_back({at.x + (2 * i + 1) * gap, at.y + random_.uniform(0, 200)});
    }
    ring.push_back({at.x + 2 * teeth * gap, at.y - random_.uniform(1e-3, 100)});
    ring.push_back({at.x, at.y - random_.uniform(1e-3, 100)});
    return ring;
  }

  Ring with_spike(Ring ring) {
    const size_t i = random_.integer(0, static_cast<int>(ring.size()) - 1);
    const Point2 p = ring[i];
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i), {p, place()});
    return ring;
  }

  Ring any_ring() {
    switch (random_.integer(0, 9)) {
      case 0:
        return star();
      case 1:
        return on_a_grid(chance(0.5) ? 100 : 50);
      case 2:
        return tangle();
      case 3:
      case 4:
        return twin();
      case 5:
        return comb();
      case 6:
        return with_spike(blob(random_, place(), 150, 90, 0.2));
      case 7:
        return blob(random_, place(), any_size(), any_size(), random_.uniform(0, 0.9));
      default:
        return blob(random_, place(), random_.uniform(40, 300), random_.uniform(40, 200),
                    random_.uniform(0, 0.3));
    }
  }

  void add_part() {
    Part part;
    part.id = "p" + std::to_string(scene_.parts.size());
    for (int rings = chance(0.7) ? 1 : random_.integer(2, 6); rings > 0; --rings)
      part.outline.push_back(any_ring());
    if (chance(0.3)) part.c = chance(0.5) ? 1e-3 : 50;
    if (chance(0.2)) part.d = chance(0.5) ? -1 : 1e-3;
    if (chance(0.2)) part.flat = chance(0.5) ? 0.999999 : 1;
    if (chance(0.2)) part.lean = {random_.uniform(-2, 2), random_.uniform(-2, 2)};
    scene_.parts.push_back(std::move(part));
  }

  const Part& any_part() {
    return scene_.parts[random_.integer(0, static_cast<int>(scene_.parts.size()) - 1)];
  }

  std::pair<int, int> any_pair() {
    const int upper = random_.integer(1, static_cast<int>(scene_.parts.size()) - 1);
    return {upper, random_.integer(0, upper - 1)};
  }

  const Ring& any_ring_of(int part) {
    const Outline& outline = scene_.parts[part].outline;
    return outline[random_.integer(0, static_cast<int>(outline.size()) - 1)];
  }

  /// Any stretch of the upper outline, or the one inside the lower part.
  std::vector<Point2> stretch(int upper, int lower) {
    if (chance(0.85)) {
      std::vector<Point2> line =
          inside_run(scene_.parts[upper].outline, scene_.parts[lower].outline);
      if (!line.empty()) return line;
    }
    const Ring& ring = any_ring_of(upper);
    const size_t n = ring.size();
    const size_t first = random_.integer(0, static_cast<int>(n) - 1);
    std::vector<Point2> line;
    for (size_t k = 0; k <= n / 4 + 1; ++k) line.push_back(ring[(first + k) % n]);
    return line;
  }

  void add_join() {
    Join join;
    std::tie(join.upper, join.lower) = any_pair();
    if (!scene_.joins.empty() && chance(0.3)) {
      join.upper = scene_.joins.back().upper;
      if (chance(0.5) || join.upper < 2) join.lower = scene_.joins.back().lower;
      join.lower = std::min(join.lower, join.upper - 1);
    }
    join.line = stretch(join.upper, join.lower);
    if (chance(0.3)) std::reverse(join.line.begin(), join.line.end());
    scene_.joins.push_back(std::move(join));
  }

  Point2 near_outline(int part) {
    const Ring& ring = any_ring_of(part);
    return ring[random_.integer(0, static_cast<int>(ring.size()) - 1)];
  }

  void add_relation() {
    Relation relation;
    std::tie(relation.upper, relation.lower) = any_pair();
    const auto kinds = {RelationKind::equal, RelationKind::above, RelationKind::free,
                        RelationKind::below};
    relation.kind = *(kinds.begin() + random_.integer(0, 3));
    if (relation.kind == RelationKind::below || chance(0.5))
      relation.range = {near_outline(relation.upper), near_outline(relation.upper)};
    scene_.relations.push_back(relation);
  }

  void add_range() {
    RobinRange range;
    std::tie(range.upper, range.lower) = any_pair();
    range.from = near_outline(range.upper);
    range.to = near_outline(range.upper);
    if (chance(0.5)) range.alpha0 = chance(0.5) ? 0 : 0.999999;
    if (chance(0.5)) range.rho = chance(0.5) ? 1e-3 : max_rho;
    scene_.robin.push_back(range);
  }

  void add_cue() {
    Cue cue;
    cue.part = random_.integer(0, static_cast<int>(scene_.parts.size()) - 1);
    cue.kind = chance(0.3) ? CueKind::bulge : chance(0.5) ? CueKind::slope : CueKind::crease;
    cue.line = {place(), place(), place()};
    cue.value = cue.kind == CueKind::bulge ? random_.uniform(min_bulge, max_bulge)
                                           : random_.uniform(-max_cue_angle, max_cue_angle);
    scene_.cues.push_back(std::move(cue));
  }

  /// Sometimes the whole drawing is tiny or huge, or lies far from the canvas.
  void scale() {
    if (!chance(0.2)) return;
    const double factor = std::pow(10, random_.uniform(-3, 2.9));
    const auto move = [&](Point2& p) { p = factor * p; };
    for (Part& part : scene_.parts)
      for (Ring& ring : part.outline) std::for_each(ring.begin(), ring.end(), move);
    for (Join& join : scene_.joins) std::for_each(join.line.begin(), join.line.end(), move);
    for (Cue& cue : scene_.cues) std::for_each(cue.line.begin(), cue.line.end(), move);
    for (RobinRange& range : scene_.robin) {
      move(range.from);
      move(range.to);
    }
    for (Relation& relation : scene_.relations)
      if (relation.range) {
        move(relation.range->first);
        move(relation.range->second);
      }
    scene_.width = scene_.height = std::max(1.0, side * factor);
  }

  Random random_;
  Scene scene_;
};

}  // namespace

Scene ugly_scene(uint64_t seed) { return UglyScene(seed).make(); }

}  // namespace relievo::testing
