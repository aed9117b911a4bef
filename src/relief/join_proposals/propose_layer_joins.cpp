#include "relief/join_proposals/propose_layer_joins.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/geometry/polygon.h"
#include "kernel/image/filters.h"
#include "relief/join_proposals/roots.h"

namespace relievo {
namespace {

constexpr int grid_side = 512;
constexpr double sample_step = 1.5;  ///< along outlines, grid pixels
constexpr int root_samples = 200;
/// A limb lies beside the part that it grows out of with this share of its area,
constexpr double least_protrusion = 0.3;
/// or with this where both have one colour,
constexpr double least_same_color = 0.1;
/// is at most so much larger than that,
constexpr double limb_to_body = 1.2;
/// has its root on such a share of its outline,
constexpr double least_root = 0.08;
constexpr double most_root = 0.85;
/// and no second run there that is longer than this times the first.
constexpr double second_run = 0.4;
/// The cap of a root stays away from its ends by this share of it.
constexpr double root_margin = 0.18;
constexpr double cap_angle = 1;  ///< radians between the normals of the cap and the limb's axis
/// A cap is no longer than this times the root of the limb's area; of round parts, whose necks are
/// narrower than they are, the other.
constexpr double long_cap = 0.65;
constexpr double round_cap = 0.45;
/// The part's area over that of a disc of the same perimeter, from where it counts as round.
constexpr double hardly_round = 0.75;
constexpr double fully_round = 0.95;
constexpr double smoothing = 0.05;  ///< of normals, share of the root to either side
/// and nothing lies between the two along more than this share of the join.
constexpr double most_between = 0.5;
/// A limb behind another part comes out from there with this share of its area.
constexpr double least_behind = 0.4;
/// Differences of colours (of at most sqrt 3) that say nothing, and that speak against a join;
constexpr double same_color = 0.15;
constexpr double other_color = 0.6;
constexpr double foreign_color = 0.75;  ///< a part of such a colour is held, and does not grow,
constexpr double clothing = 0.35;       ///< unless it covers this share of the other
constexpr double least_trust = 0.25;    ///< of a join; what is less sure is tied
/// A part this many times as thick as another is a body, and not a limb beside it.
constexpr double thick_body = 1.35;
/// What covers the root of a limb does not grow out of it: shares of the limb's reach from its own
/// root, up to where nothing does, and from where anything may.
constexpr double at_root = 0.2;
constexpr double off_root = 0.5;

/// A run of one ring of a part inside another part.
struct RingRun {
  const Ring* ring = nullptr;
  RingMeasure measure;
  double from = 0;
  double length = 0;  ///< the whole ring's where it does not leave

  Point2 at(double s) const { return point_at(*ring, measure, from + s); }
};

/// The stretches of the ring inside `other`, single samples apart taken together.
std::vector<RingRun> runs_inside(const LayerGrid& grid, const Ring& ring, int other) {
  const RingMeasure m = measure(ring);
  const int count = std::max(16, static_cast<int>(m.length * grid.scale / sample_step));
  const double step = m.length / count;
  std::vector<uint8_t> inside(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) inside[i] = grid.has(other, point_at(ring, m, i * step));
  for (int i = 0; i < count; ++i)
    if (inside[(i + count - 1) % count] != 0 && inside[(i + 1) % count] != 0) inside[i] = 1;
  const auto start = std::find(inside.begin(), inside.end(), 0) - inside.begin();
  if (start == count) return {{&ring, m, 0, m.length}};
  std::vector<RingRun> runs;
  for (int i = 0; i < count; ++i) {
    const int at = static_cast<int>(start) + i;
    if (inside[at % count] == 0) continue;
    if (inside[(at + count - 1) % count] == 0) runs.push_back({&ring, m, at * step, 0});
    runs.back().length += step;
  }
  return runs;
}

/// All runs of the outer rings of a part, the longest first.
std::vector<RingRun> runs_inside(const LayerGrid& grid, const Outline& outline, int other) {
  std::vector<RingRun> runs;
  for (const Ring& ring : outline)
    if (signed_area(ring) > 0)
      for (RingRun& run : runs_inside(grid, ring, other)) runs.push_back(std::move(run));
  std::stable_sort(runs.begin(), runs.end(),
                   [](const RingRun& a, const RingRun& b) { return a.length > b.length; });
  return runs;
}

Point2 unit(Point2 p) {
  const double length = norm(p);
  return length > 0 ? 1 / length * p : Point2{};
}

/// The cap of a limb's root, as arc lengths of the run.
struct RootCap {
  double from = 0;
  double to = 0;
};

class CapFinder {
 public:
  CapFinder(const LayerGrid& grid, const RingRun& run, int part, int other)
      : grid_(grid), run_(run), part_(part), other_(other) {
    for (int i = 0; i <= root_samples; ++i)
      points_.push_back(run.at(run.length * i / root_samples));
  }

  RootCap find() const {
    const std::vector<Point2> normals = outward_normals();
    const int low = static_cast<int>(root_margin * root_samples);
    const int high = root_samples - low;
    const int tip = find_tip(normals, low, high);
    const Point2 axis = axis_at(tip, normals);
    const auto in_cap = [&](int i) { return dot(normals[i], axis) > std::cos(cap_angle); };
    int first = tip;
    int last = tip;
    while (first > low && in_cap(first - 1)) --first;
    while (last < high && in_cap(last + 1)) ++last;
    const double step = run_.length / root_samples;
    const double room = longest() / std::max(step * (last - first), 1e-9);
    const double keep = std::min(1.0, room);
    return {step * (tip - keep * (tip - first)), step * (tip + keep * (last - tip))};
  }

 private:
  static constexpr int reach = static_cast<int>(smoothing * root_samples);

  double longest() const {
    return (long_cap + roundness() * (round_cap - long_cap)) * std::sqrt(signed_area(*run_.ring));
  }

  double roundness() const {
    const double length = run_.measure.length;
    const double disc = 4 * M_PI * signed_area(*run_.ring) / (length * length);
    return std::clamp((disc - hardly_round) / (fully_round - hardly_round), 0.0, 1.0);
  }

  /// Outer rings have positive area with y down: outwards is to the left of the direction.
  std::vector<Point2> outward_normals() const {
    std::vector<Point2> normals;
    for (int i = 0; i <= root_samples; ++i) {
      const Point2 along =
          unit(points_[std::min(i + reach, root_samples)] - points_[std::max(i - reach, 0)]);
      normals.push_back({along.y, -along.x});
    }
    return normals;
  }

  /// Of a limb what is farthest on its way into the other part, of a round one or one that lies
  /// mostly on the other what is farthest from its free end.
  int find_tip(const std::vector<Point2>& normals, int low, int high) const {
    const double common = static_cast<double>(common_area(grid_, part_, other_));
    const double beside = 1 - common / static_cast<double>(grid_.areas[part_]);
    const double t = beside < least_protrusion ? 1 : roundness();
    const Point2 inwards = way_inwards();
    const auto farthest =
        std::max_element(points_.begin() + low, points_.begin() + high + 1,
                         [&](Point2 a, Point2 b) { return dot(a, inwards) < dot(b, inwards); });
    const auto by_way = static_cast<double>(farthest - points_.begin());
    return static_cast<int>(std::lround((1 - t) * by_way + t * innermost(normals, low, high)));
  }

  int innermost(const std::vector<Point2>& normals, int low, int high) const {
    const std::vector<double> distance = distance_from_free_end(grid_, part_, other_);
    const Mask& mask = grid_.masks[part_];
    int tip = (low + high) / 2;
    double farthest = -1;
    for (int i = low; i <= high; ++i) {
      const Point2 p = grid_.scale * points_[i] - 1.5 * normals[i];
      const int x = static_cast<int>(std::floor(p.x));
      const int y = static_cast<int>(std::floor(p.y));
      if (!mask.has(x, y)) continue;
      const double d = distance[(y - mask.top) * mask.inside.width + x - mask.left];
      if (!std::isfinite(d) || d <= farthest) continue;
      farthest = d;
      tip = i;
    }
    return tip;
  }

  /// The normal at the tip and, where that agrees, the way from what lies beside the other part to
  /// what lies on it.
  Point2 axis_at(int tip, const std::vector<Point2>& normals) const {
    Point2 sum;
    for (int i = std::max(0, tip - reach); i <= std::min(root_samples, tip + reach); ++i)
      sum = sum + normals[i];
    const Point2 normal = unit(sum);
    const Point2 inwards = way_inwards();
    return dot(normal, inwards) > 0.5 ? unit(normal + inwards) : normal;
  }

  Point2 way_inwards() const {
    Point2 inside, beside;
    double n = 0, m = 0;
    for_each_pixel(grid_.masks[part_], [&](int x, int y) {
      const Point2 p{x + 0.5, y + 0.5};
      if (grid_.masks[other_].has(x, y)) {
        inside = inside + p;
        ++n;
      } else {
        beside = beside + p;
        ++m;
      }
    });
    return n > 0 && m > 0 ? unit(1 / n * inside - 1 / m * beside) : Point2{};
  }

  const LayerGrid& grid_;
  const RingRun& run_;
  int part_;
  int other_;
  std::vector<Point2> points_;
};

bool is_larger(const LayerGrid& grid, int part, int other, double factor) {
  return static_cast<double>(grid.areas[part]) > factor * static_cast<double>(grid.areas[other]);
}

Point2 common_centre(const LayerGrid& grid, int part, int other) {
  Point2 sum;
  double n = 0;
  for_each_pixel(grid.masks[part], [&](int x, int y) {
    if (!grid.masks[other].has(x, y)) return;
    sum = sum + Point2{x + 0.5, y + 0.5};
    ++n;
  });
  return n > 0 ? 1 / n * sum : sum;
}

/// How far from its root on `root` a part meets another, as a share of its reach from there.
double share_from_root(const LayerGrid& grid, int part, int root, int other) {
  const Point2 from = common_centre(grid, part, root);
  double reach = 1;
  for_each_pixel(grid.masks[part], [&](int x, int y) {
    reach = std::max(reach, distance(from, {x + 0.5, y + 0.5}));
  });
  return distance(from, common_centre(grid, part, other)) / reach;
}

/// The radius of the largest disc inside a part that touches another; that part itself for any.
double thickness_at(const LayerGrid& grid, int part, int other) {
  const Mask& mask = grid.masks[part];
  Image8 outside(mask.inside.width + 2, mask.inside.height + 2, 1);
  Image8 common = outside;
  std::fill(outside.pixels.begin(), outside.pixels.end(), uint8_t{1});
  for_each_pixel(mask, [&](int x, int y) {
    outside.at(x - mask.left + 1, y - mask.top + 1) = 0;
    common.at(x - mask.left + 1, y - mask.top + 1) = grid.masks[other].has(x, y) ? 1 : 0;
  });
  const Image<int32_t> radius = squared_distance_to(outside);
  const Image<int32_t> away = squared_distance_to(common);
  int32_t largest = 0;
  for (size_t i = 0; i < radius.pixels.size(); ++i)
    if (away.pixels[i] <= radius.pixels[i]) largest = std::max(largest, radius.pixels[i]);
  return std::sqrt(static_cast<double>(largest));
}

/// The share of the points under which a third part lies between two.
double share_between(const LayerGrid& grid, const std::vector<Point2>& line, const Overlap& pair) {
  double between = 0;
  for (const Point2 p : line) {
    int part = pair.lower + 1;
    while (part < pair.upper && !grid.has(part, p)) ++part;
    between += part < pair.upper ? 1 : 0;
  }
  return between / static_cast<double>(line.size());
}

class Connector {
 public:
  Connector(const Scene& scene, const PartColors& colors)
      : grid_(make_layer_grid(scene, grid_side)), colors_(colors) {
    for (const Part& part : scene.parts) orient_by_nesting(outlines_.emplace_back(part.outline));
  }

  /// A limb grows out of one part. Of those that it may grow out of, in front of it or behind, that
  /// is the one with the most confidence; where that lies in front, there is no join.
  JoinProposals run() const {
    JoinProposals joining;
    const std::vector<Overlap> overlaps = find_overlaps(grid_);
    std::vector<std::optional<ProposedJoin>> joins;
    for (const Overlap& pair : overlaps) joins.push_back(join_of(pair));
    doubt_roots(overlaps, joins);
    const std::vector<double> most = rooted(overlaps, joins).confidence;
    std::vector<uint8_t> joined(grid_.masks.size());
    std::vector<uint8_t> held(grid_.masks.size());
    for (size_t k = 0; k < overlaps.size(); ++k) {
      const Overlap& pair = overlaps[k];
      if (joins[k] && joins[k]->confidence >= std::max(most[pair.upper], least_trust)) {
        joined[pair.upper] = 1;
        joining.joins.push_back(std::move(*joins[k]));
      } else if (is_behind(pair)) {
        held[pair.lower] = 1;
        tie(pair, joining);
      }
    }
    tie_lying(overlaps, joined, held, joining);
    tie_hidden(overlaps, held, joining);
    joining.hollows = hollow_parts(grid_, colors_, limbs(overlaps, joining));
    return joining;
  }

 private:
  /// Of each part, the one that it most likely grows out of, -1 for none, and how likely.
  struct Rooted {
    std::vector<int> body;
    std::vector<double> confidence;
  };

  Rooted rooted(const std::vector<Overlap>& overlaps,
                const std::vector<std::optional<ProposedJoin>>& joins) const {
    Rooted result{std::vector<int>(grid_.masks.size(), -1),
                  std::vector<double>(grid_.masks.size())};
    const auto note = [&](int limb, int body, double confidence) {
      if (confidence <= result.confidence[limb]) return;
      result.body[limb] = body;
      result.confidence[limb] = confidence;
    };
    for (size_t k = 0; k < overlaps.size(); ++k) {
      const Overlap& pair = overlaps[k];
      if (joins[k])
        note(pair.upper, pair.lower, joins[k]->confidence);
      else if (is_behind(pair))
        note(pair.lower, pair.upper, likeness(pair.lower, pair.upper) * pair.lower_beside);
    }
    return result;
  }

  /// A foot before the root of a tail, or a leg before that of another, stands beside it: such
  /// joins lose their confidence, unless what they would join is much thicker.
  void doubt_roots(const std::vector<Overlap>& overlaps,
                   std::vector<std::optional<ProposedJoin>>& joins) const {
    const std::vector<int> bodies = rooted(overlaps, joins).body;
    for (size_t k = 0; k < overlaps.size(); ++k) {
      const int limb = overlaps[k].upper;
      const int body = overlaps[k].lower;
      const int root = bodies[body];
      if (!joins[k] || root < 0 || root == limb) continue;
      const double share = share_from_root(grid_, body, root, limb);
      if (share >= off_root ||
          thickness_at(grid_, body, limb) >= thick_body * thickness_at(grid_, limb, limb))
        continue;
      joins[k]->confidence *= std::max(0.0, (share - at_root) / (off_root - at_root));
    }
  }

  static void tie(const Overlap& pair, JoinProposals& joining) {
    joining.relations.push_back(
        {{pair.upper, pair.lower, RelationKind::equal, std::nullopt}, false});
  }

  /// What has no join lies on the larger parts behind it, and what hangs on one in front only on
  /// those that it does not cross: tied to all, it would be drawn back to what is farthest. Marks
  /// what is held.
  void tie_lying(const std::vector<Overlap>& overlaps, const std::vector<uint8_t>& joined,
                 std::vector<uint8_t>& held, JoinProposals& joining) const {
    const std::vector<uint8_t> hangs = held;
    for (const Overlap& pair : overlaps) {
      const bool crosses = pair.upper_beside >= least_protrusion;
      const bool is_free = joined[pair.upper] == 0 && (hangs[pair.upper] == 0 || !crosses);
      if (!is_free || is_larger(grid_, pair.upper, pair.lower, 1)) continue;
      held[pair.upper] = 1;
      tie(pair, joining);
    }
    for (size_t part = 0; part < held.size(); ++part)
      if (joined[part] != 0) held[part] = 1;
  }

  /// What nothing holds and a larger part mostly hides would float behind that.
  void tie_hidden(const std::vector<Overlap>& overlaps, const std::vector<uint8_t>& held,
                  JoinProposals& joining) const {
    std::vector<const Overlap*> nearest(grid_.masks.size());
    for (const Overlap& pair : overlaps)
      if (held[pair.lower] == 0 && is_larger(grid_, pair.upper, pair.lower, 1) &&
          (nearest[pair.lower] == nullptr || pair.lower_beside < nearest[pair.lower]->lower_beside))
        nearest[pair.lower] = &pair;
    for (const Overlap* pair : nearest)
      if (pair != nullptr) tie(*pair, joining);
  }

  /// Which parts are limbs, joined or behind.
  std::vector<uint8_t> limbs(const std::vector<Overlap>& overlaps,
                             const JoinProposals& joining) const {
    std::vector<uint8_t> limb(grid_.masks.size());
    for (const ProposedJoin& proposed : joining.joins) limb[proposed.join.upper] = 1;
    for (const Overlap& pair : overlaps)
      if (is_behind(pair)) limb[pair.lower] = 1;
    return limb;
  }

  /// How different the main colour of a limb is from all of a body; 0 where one is not known.
  double color_difference(int limb, int body) const {
    const size_t known = colors_.size();
    if (std::max<size_t>(limb, body) >= known || colors_[limb].empty() || colors_[body].empty())
      return 0;
    double least = 2;
    const std::array<double, 3>& own = colors_[limb].front();
    for (const auto& color : colors_[body])
      least = std::min(least, std::hypot(own[0] - color[0], own[1] - color[1], own[2] - color[2]));
    return least;
  }

  /// From 1 to one half.
  double likeness(int limb, int body) const {
    const double change = (color_difference(limb, body) - same_color) / (other_color - same_color);
    const double ratio =
        static_cast<double>(grid_.areas[body]) / static_cast<double>(grid_.areas[limb]);
    return (1 - 0.5 * std::clamp(change, 0.0, 1.0)) * std::clamp(0.45 * ratio, 0.4, 1.0);
  }

  /// The join of a limb, if the upper part is one.
  std::optional<ProposedJoin> join_of(const Overlap& pair) const {
    const double difference = color_difference(pair.upper, pair.lower);
    const bool alike = !colors_.empty() && difference < same_color;
    if (pair.upper_beside < (alike ? least_same_color : least_protrusion) ||
        is_held(pair, difference) || is_larger(grid_, pair.upper, pair.lower, limb_to_body))
      return std::nullopt;
    const auto runs = runs_inside(grid_, outlines_[pair.upper], pair.lower);
    if (runs.empty()) return std::nullopt;
    const RingRun& root = runs.front();
    const double share = root.length / root.measure.length;
    const double second = runs.size() > 1 ? runs[1].length / root.length : 0;
    if (share < least_root || share > most_root || second > second_run) return std::nullopt;
    const RootCap cap = CapFinder(grid_, root, pair.upper, pair.lower).find();
    const double step = sample_step / grid_.scale;
    if (cap.to - cap.from < 4 * step) return std::nullopt;
    ProposedJoin proposed;
    proposed.join = {pair.upper, pair.lower, {}};
    const int pieces = std::max(8, static_cast<int>((cap.to - cap.from) / (2 * step)));
    for (int i = 0; i <= pieces; ++i)
      proposed.join.line.push_back(root.at(cap.from + (cap.to - cap.from) * i / pieces));
    const double between = share_between(grid_, proposed.join.line, pair);
    if (between > most_between) return std::nullopt;
    proposed.confidence = (1 - between) * (1 - second) *
                          std::min(1.0, 0.5 + pair.upper_beside / 2) *
                          likeness(pair.upper, pair.lower);
    return proposed;
  }

  /// Whether the upper part is a thing in front of the lower one; hair and clothes, which cover
  /// much of it, are not.
  static bool is_held(const Overlap& pair, double difference) {
    return difference > foreign_color && pair.lower_beside > 1 - clothing;
  }

  /// Whether the lower part is a limb that comes out from behind the upper one.
  bool is_behind(const Overlap& pair) const {
    return is_larger(grid_, pair.upper, pair.lower, 1) && pair.lower_beside > least_behind;
  }

  LayerGrid grid_;
  const PartColors& colors_;
  std::vector<Outline> outlines_;
};

}  // namespace

JoinProposals propose_layer_joins(const Scene& scene, const PartColors& colors) {
  return scene.parts.empty() ? JoinProposals() : Connector(scene, colors).run();
}

}  // namespace relievo
