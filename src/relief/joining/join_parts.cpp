#include "relief/joining/join_parts.h"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/image/mask_outline.h"
#include "relief/joining/roots.h"

namespace relievo {
namespace {

using Pair = std::pair<int, int>;

constexpr int line_smoothing = 4;
constexpr size_t line_step = 4;  ///< sides between the points of a join's line

class Proposer {
 public:
  Proposer(const PartRegions& regions, const Stacking& stacking,
           const JoiningCorrections& corrections, const JoiningOptions& options)
      : regions_(regions), stacking_(stacking), options_(options) {
    for (const Join& join : corrections.joins) add_user(join);
    for (const Pair& pair : corrections.no_joins) unjoined_.insert(pair);
    for (const Relation& relation : corrections.relations) {
      out_.relations.push_back({relation, true});
      related_.insert({relation.upper, relation.lower});
    }
    out_.robin = corrections.robin;
    for (const RobinRange& range : corrections.robin) ramped_.insert({range.upper, range.lower});
  }

  Joining run() {
    for (int part = 0; part < regions_.count(); ++part) propose(part);
    return std::move(out_);
  }

 private:
  void add_user(const Join& join) {
    out_.joins.push_back({join, 1, true});
    joined_.insert({join.upper, join.lower});
  }

  void propose(int part) {
    const Surroundings around = surroundings(regions_, stacking_, part);
    for (const Root& root : around.roots) propose_join(part, root, around);
    for (const int lower : around.lower) propose_relation(part, lower, around.enclosed);
  }

  void propose_join(int part, const Root& root, const Surroundings& around) {
    const auto same = [&](const Root& other) { return other.lower == root.lower; };
    const bool only = std::count_if(around.roots.begin(), around.roots.end(), same) == 1;
    const Pair pair{part, root.lower};
    const bool decided = joined_.count(pair) + unjoined_.count(pair) + related_.count(pair) > 0;
    if (around.enclosed || !only || decided) return;
    const double length = static_cast<double>(root.count);
    const double share = length / static_cast<double>(root.ring->size());
    if (share < options_.min_root || root.count < static_cast<size_t>(options_.min_root_sides))
      return;
    lay_join(part, root, std::min(1.0, 0.5 + share));
  }

  void lay_join(int part, const Root& root, double confidence) {
    const Ring ring = smoothed(root.ring->sides, line_smoothing);
    const size_t ramp = ramp_sides(root);
    const auto at = [&](size_t side) { return ring[(root.first + side) % ring.size()]; };
    const size_t last = root.count - 1 - ramp;
    ProposedJoin proposed;
    proposed.join = {part, root.lower, {}};
    for (size_t i = ramp; i < last; i += line_step) proposed.join.line.push_back(at(i));
    proposed.join.line.push_back(at(last));
    proposed.confidence = confidence;
    joined_.insert({part, root.lower});
    if (ramped_.count({part, root.lower}) == 0) {
      if (root.opens_before) lay_ramp(part, root.lower, at(ramp), at(0));
      if (root.opens_after) lay_ramp(part, root.lower, at(last), at(root.count - 1));
    }
    out_.joins.push_back(std::move(proposed));
  }

  void lay_ramp(int upper, int lower, Point2 from, Point2 to) {
    out_.robin.push_back({upper, lower, from, to, std::nullopt, std::nullopt});
  }

  /// Sides of the root beside each end of the join.
  size_t ramp_sides(const Root& root) const {
    const Ring& sides = root.ring->sides;
    const Point2 a = sides[root.first];
    const Point2 b = sides[(root.first + root.count - 1) % sides.size()];
    double length = 0;
    for (size_t i = 1; i < root.count; ++i)
      length += distance(sides[(root.first + i - 1) % sides.size()],
                         sides[(root.first + i) % sides.size()]);
    const double ramp = 0.75 * (length - distance(a, b)) / (2 * length);
    const double share = std::clamp(ramp, options_.shortest_ramp, options_.longest_ramp);
    return std::max<size_t>(1, static_cast<size_t>(share * static_cast<double>(root.count)));
  }

  void propose_relation(int upper, int lower, bool enclosed) {
    const Pair pair{upper, lower};
    if (joined_.count(pair) + related_.count(pair) > 0) return;
    const RelationKind kind = enclosed ? RelationKind::equal : RelationKind::above;
    out_.relations.push_back({{upper, lower, kind, std::nullopt}, false});
  }

  const PartRegions& regions_;
  const Stacking& stacking_;
  const JoiningOptions& options_;
  std::set<Pair> joined_;
  std::set<Pair> unjoined_;
  std::set<Pair> related_;
  std::set<Pair> ramped_;
  Joining out_;
};

}  // namespace

Joining join_parts(const PartRegions& regions, const Stacking& stacking,
                   const JoiningCorrections& corrections, const JoiningOptions& options) {
  return Proposer(regions, stacking, corrections, options).run();
}

}  // namespace relievo
