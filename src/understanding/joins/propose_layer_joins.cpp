#include "understanding/joins/propose_layer_joins.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "understanding/joins/layer_grid.h"
#include "understanding/joins/part_profile.h"
#include "understanding/joins/root_caps.h"

namespace relievo::understanding {
namespace {

constexpr int grid_side = 512;  ///< grid pixels along the longest side of the canvas
/// The least share of a limb's area outside the part of its colour from which it grows. For other
/// colours it is `least_protrusion`.
constexpr double least_same_color = 0.1;
constexpr double limb_to_body = 1.2;  ///< largest area of a limb over that of its body
/// Bounds of the share of a limb's outline that its root takes.
constexpr double least_root = 0.08;
constexpr double most_root = 0.85;
constexpr double second_run = 0.4;  ///< largest length of a second run over that of the root
/// The largest share of a join's line along which a third part lies between limb and body.
constexpr double most_between = 0.5;
/// The least share of a limb's area that is seen of it where it comes out from behind a part.
constexpr double least_behind = 0.4;
/// Distances of colours, which are at most sqrt 3: up to the first they are the same, from the
/// second on they count fully against a join, and above the third a part is an object of its own.
constexpr double same_color = 0.15;
constexpr double other_color = 0.6;
constexpr double foreign_color = 0.75;
/// The least share of the lower part that hair or clothes of a foreign colour cover.
constexpr double clothing = 0.35;
constexpr double least_trust = 0.25;  ///< least confidence of a join; others become ties
/// A join with less than the first confidence becomes a tie where the upper part covers at least
/// the second share of the lower one's outline, as hair does.
constexpr double sure_join = 0.5;
constexpr double least_cover = 0.5;
/// The thickness over that of a limb from which on a part is a body and not another limb beside it.
constexpr double thick_body = 1.35;
/// Distances from a limb's root, over the limb's reach: up to the first nothing that covers the
/// limb grows out of it, and from the second on anything may.
constexpr double at_root = 0.2;
constexpr double off_root = 0.5;
/// The largest area of a feature over that of the part that it lies within, and its least
/// round_inflation, that of an ellipse of two to one.
constexpr double largest_feature = 0.1;
constexpr double least_round = 2.5;

bool is_larger(const LayerGrid& grid, int part, int other, double factor) {
  return static_cast<double>(grid.areas[part]) > factor * static_cast<double>(grid.areas[other]);
}

/// The share of the points at which a third part lies between two.
double share_between(const LayerGrid& grid, const std::vector<Point2>& line, const Overlap& pair) {
  double between = 0;
  for (const Point2 p : line) {
    int part = pair.lower + 1;
    while (part < pair.upper && !grid.has(part, p)) ++part;
    between += part < pair.upper ? 1 : 0;
  }
  return between / static_cast<double>(line.size());
}

void tie(const Overlap& pair, JoinProposals& joining) {
  joining.relations.push_back({{pair.upper, pair.lower, RelationKind::equal, std::nullopt}, false});
}

/// The features, and their share of the smallest part that they lie within, which determines how
/// much they bulge, as the white of an eye does for a pupil. A part is a feature of the largest
/// part that it lies within.
std::vector<std::pair<int, double>> features(const LayerGrid& grid,
                                             const std::vector<Overlap>& overlaps,
                                             const std::vector<uint8_t>& joined) {
  std::map<int, std::vector<double>> shares;
  for (const Overlap& pair : overlaps)
    if (joined[pair.upper] == 0 && pair.upper_beside <= most_outside &&
        round_inflation(grid.masks[pair.upper]) >= least_round)
      shares[pair.upper].push_back(static_cast<double>(grid.areas[pair.upper]) /
                                   static_cast<double>(grid.areas[pair.lower]));
  std::vector<std::pair<int, double>> found;
  for (const auto& [part, of] : shares)
    if (const auto [least, most] = std::minmax_element(of.begin(), of.end());
        *least <= largest_feature)
      found.emplace_back(part, *most);
  return found;
}

/// The distance of a limb's main colour from the nearest colour of a body; 0 where one is unknown.
double color_difference(const PartColors& colors, int limb, int body) {
  const size_t known = colors.size();
  if (std::max<size_t>(limb, body) >= known || colors[limb].empty() || colors[body].empty())
    return 0;
  double least = 2;
  const std::array<double, 3>& own = colors[limb].front();
  for (const auto& color : colors[body])
    least = std::min(least, std::hypot(own[0] - color[0], own[1] - color[1], own[2] - color[2]));
  return least;
}

/// Whether the upper part is an object of its own, as one in a hand, and does not grow out of the
/// lower one. Hair and clothes, which cover much of it, are not.
bool is_object(const Overlap& pair, double difference) {
  return difference > foreign_color && pair.lower_beside > 1 - clothing;
}

/// Per part, 1 where it lies within a larger one behind it, as eyes do.
std::vector<uint8_t> lying_parts(const LayerGrid& grid, const std::vector<Overlap>& overlaps) {
  std::vector<uint8_t> lying(grid.masks.size());
  for (const Overlap& pair : overlaps)
    if (pair.upper_beside <= most_outside && is_larger(grid, pair.lower, pair.upper, 1))
      lying[pair.upper] = 1;
  return lying;
}

class Connector {
 public:
  Connector(const Scene& scene, const PartColors& colors, const std::vector<Point2>& anchors)
      : grid_(make_layer_grid(scene, grid_side)), colors_(colors), anchors_(anchors) {
    for (const Part& part : scene.parts) orient_by_nesting(outlines_.emplace_back(part.outline));
  }

  /// Lets every limb grow out of the part with the most confidence; where that lies in front of the
  /// limb, there is no join.
  JoinProposals run() const {
    JoinProposals joining;
    const std::vector<Overlap> overlaps = find_overlaps(grid_);
    std::vector<std::optional<ProposedJoin>> joins;
    for (const Overlap& pair : overlaps) joins.push_back(join_of(pair));
    doubt_roots(overlaps, joins);
    const Rooted roots = rooted(overlaps, joins);
    const std::vector<uint8_t> lying = lying_parts(grid_, overlaps);
    std::vector<uint8_t> joined(grid_.masks.size());
    std::vector<uint8_t> attached(grid_.masks.size());
    for (size_t k = 0; k < overlaps.size(); ++k) {
      const Overlap& pair = overlaps[k];
      const bool is_joined =
          joins[k] && joins[k]->confidence >= std::max(roots.confidence[pair.upper], least_trust);
      if (is_joined && joins[k]->confidence < sure_join && is_cap(pair)) {
        attached[pair.upper] = 1;
        tie(pair, joining);
      } else if (is_joined) {
        joined[pair.upper] = 1;
        joining.joins.push_back(std::move(*joins[k]));
      } else if (is_behind(pair)) {
        attached[pair.lower] = 1;
        const bool grows = roots.body[pair.lower] == pair.upper && lying[pair.lower] == 0;
        joining.relations.push_back(hang_behind(pair, grows));
      }
    }
    tie_lying(overlaps, joined, attached, joining);
    tie_hidden(overlaps, attached, joining);
    joining.hollows = hollow_parts(grid_, colors_, limbs(overlaps, joining));
    joining.features = features(grid_, overlaps, joined);
    return joining;
  }

 private:
  /// Per part, the one that it most likely grows out of, -1 for none, and the confidence.
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
        note(pair.lower, pair.upper, trust_behind(pair));
    }
    return result;
  }

  /// Reduces the confidence of joins of parts that cover the root of a limb, as a foot covers the
  /// root of a tail, since they stand beside it. Joins to a much thicker part keep theirs, as do
  /// joins of a part out of which others grow, which is no foot.
  void doubt_roots(const std::vector<Overlap>& overlaps,
                   std::vector<std::optional<ProposedJoin>>& joins) const {
    const std::vector<int> bodies = rooted(overlaps, joins).body;
    std::vector<uint8_t> carries(bodies.size());
    for (const int body : bodies)
      if (body >= 0) carries[body] = 1;
    for (size_t k = 0; k < overlaps.size(); ++k) {
      const int limb = overlaps[k].upper;
      const int body = overlaps[k].lower;
      const int root = bodies[body];
      if (!joins[k] || carries[limb] || root < 0 || root == limb) continue;
      const double share = share_from_root(grid_, body, root, limb);
      if (share >= off_root ||
          thickness_at(grid_, body, limb) >= thick_body * thickness_at(grid_, limb, limb))
        continue;
      joins[k]->confidence *= std::max(0.0, (share - at_root) / (off_root - at_root));
    }
  }

  /// Ties parts without a join to the larger parts behind them. A part that hangs on one in front
  /// is tied only to those that it does not cross: otherwise it would be drawn back to the
  /// farthest. Marks the parts that are attached.
  void tie_lying(const std::vector<Overlap>& overlaps, const std::vector<uint8_t>& joined,
                 std::vector<uint8_t>& attached, JoinProposals& joining) const {
    const std::vector<uint8_t> hangs = attached;
    for (const Overlap& pair : overlaps) {
      const bool crosses = pair.upper_beside >= least_protrusion;
      const bool is_free = joined[pair.upper] == 0 && (hangs[pair.upper] == 0 || !crosses);
      if (!is_free || is_larger(grid_, pair.upper, pair.lower, 1)) continue;
      attached[pair.upper] = 1;
      tie(pair, joining);
    }
    for (size_t part = 0; part < attached.size(); ++part)
      if (joined[part] != 0) attached[part] = 1;
  }

  /// Ties each part that nothing holds to the larger part that hides most of it, behind which it
  /// would float otherwise.
  void tie_hidden(const std::vector<Overlap>& overlaps, const std::vector<uint8_t>& attached,
                  JoinProposals& joining) const {
    std::vector<const Overlap*> nearest(grid_.masks.size());
    for (const Overlap& pair : overlaps)
      if (attached[pair.lower] == 0 && is_larger(grid_, pair.upper, pair.lower, 1) &&
          (nearest[pair.lower] == nullptr || pair.lower_beside < nearest[pair.lower]->lower_beside))
        nearest[pair.lower] = &pair;
    for (const Overlap* pair : nearest)
      if (pair != nullptr) tie(*pair, joining);
  }

  /// Per part, 1 where it is a limb, joined or behind.
  std::vector<uint8_t> limbs(const std::vector<Overlap>& overlaps,
                             const JoinProposals& joining) const {
    std::vector<uint8_t> limb(grid_.masks.size());
    for (const ProposedJoin& proposed : joining.joins) limb[proposed.join.upper] = 1;
    for (const Overlap& pair : overlaps)
      if (is_behind(pair)) limb[pair.lower] = 1;
    return limb;
  }

  /// The factor of confidence by colours, 1 to one half, and by sizes, 1 to 0.4.
  double likeness(int limb, int body) const {
    const double change =
        (color_difference(colors_, limb, body) - same_color) / (other_color - same_color);
    const double ratio =
        static_cast<double>(grid_.areas[body]) / static_cast<double>(grid_.areas[limb]);
    return (1 - 0.5 * std::clamp(change, 0.0, 1.0)) * std::clamp(0.45 * ratio, 0.4, 1.0);
  }

  /// The join of the upper part, where it is a limb of the lower one.
  std::optional<ProposedJoin> join_of(const Overlap& pair) const {
    const double difference = color_difference(colors_, pair.upper, pair.lower);
    const bool alike = !colors_.empty() && difference < same_color;
    if (pair.upper_beside < (alike ? least_same_color : least_protrusion) ||
        is_object(pair, difference) || is_larger(grid_, pair.upper, pair.lower, limb_to_body))
      return std::nullopt;
    const auto runs = runs_inside(grid_, outlines_[pair.upper], pair.lower);
    if (runs.empty()) return std::nullopt;
    const RingRun& root = runs.front();
    const double share = root.length / root.measure.length;
    const double second = runs.size() > 1 ? runs[1].length / root.length : 0;
    if (share < least_root || share > most_root || second > second_run) return std::nullopt;
    const RootCap cap = find_root_cap(grid_, root, pair.upper, pair.lower, anchors_);
    const double step = root_step / grid_.scale;
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

  /// The confidence that the lower part grows out from behind the upper one.
  double trust_behind(const Overlap& pair) const {
    return likeness(pair.lower, pair.upper) * pair.lower_beside;
  }

  /// The relation of a part that comes out from behind the upper one: joined where it `grows` and
  /// has no foreign colour, as a weapon behind a hand has, and tied otherwise.
  ProposedRelation hang_behind(const Overlap& pair, bool grows) const {
    const double trust = trust_behind(pair);
    const bool is_limb = grows && trust >= least_trust &&
                         color_difference(colors_, pair.lower, pair.upper) <= foreign_color;
    const RelationKind kind = is_limb ? RelationKind::joined : RelationKind::equal;
    return {{pair.upper, pair.lower, kind, std::nullopt}, false, is_limb ? trust : 0};
  }

  /// Whether the upper part covers the outline of the lower one, as hair or a hat does.
  bool is_cap(const Overlap& pair) const {
    double length = 0;
    double whole = 0;
    for (const RingRun& run : runs_inside(grid_, outlines_[pair.lower], pair.upper)) {
      length += run.length;
      whole = std::max(whole, run.measure.length);
    }
    return length > least_cover * whole;
  }

  /// Whether the lower part is a limb that comes out from behind the upper one.
  bool is_behind(const Overlap& pair) const {
    return is_larger(grid_, pair.upper, pair.lower, 1) && pair.lower_beside > least_behind;
  }

  LayerGrid grid_;
  const PartColors& colors_;
  const std::vector<Point2>& anchors_;
  std::vector<Outline> outlines_;
};

}  // namespace

JoinProposals propose_layer_joins(const Scene& scene, const PartColors& colors,
                                  const std::vector<Point2>& anchors) {
  return scene.parts.empty() ? JoinProposals() : Connector(scene, colors, anchors).run();
}

}  // namespace relievo::understanding
