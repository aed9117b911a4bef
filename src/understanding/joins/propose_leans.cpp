#include "understanding/joins/propose_leans.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "understanding/joins/roots.h"

namespace relievo::understanding {
namespace {

/// Depth of a trunk over its width.
constexpr double assumed_depth = 0.8;
/// Roots that are nearer to each other, relative to the trunk's width, tell nothing; those that are
/// farther apart than the second all that the rule says.
constexpr double least_distance = 0.25;
constexpr double sure_distance = 0.4;
/// Parts joined to the largest one belong to the trunk where they have this share of its size.
constexpr double least_trunk = 0.25;
/// Limbs have at most this share of the trunk's.
constexpr double largest_limb = 0.25;
/// Counterparts: the smaller one has at least this share of the other's size,
constexpr double least_alike = 0.4;
/// their roots differ in height by less than this share of the trunk's,
constexpr double largest_step = 0.25;
/// and the middle between them is off the trunk's by less than this share of their distance.
constexpr double largest_shift = 0.3;
/// A lean that is less sure is not proposed.
constexpr double least_confidence = 0.2;

double size_of(const Completion& shapes, int part) {
  return static_cast<double>(pixel_count(shapes.parts[part].shape));
}

/// The parts that make the trunk, and which pixels they cover.
struct Trunk {
  std::vector<uint8_t> has;  ///< per part
  std::vector<int> parts;
  double size = 0;  ///< px
  double height = 0;
};

/// Left and right end of a row.
struct Span {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();
};

Span span_at(const Completion& shapes, const Trunk& trunk, double y) {
  Span span;
  const int row = static_cast<int>(std::floor(y));
  for (const int part : trunk.parts) {
    const Mask& mask = shapes.parts[part].shape;
    for (int x = mask.left; x < mask.right(); ++x) {
      if (!mask.has(x, row)) continue;
      span.from = std::min<double>(span.from, x);
      span.to = std::max<double>(span.to, x + 1);
    }
  }
  return span;
}

/// A part that comes out from the trunk.
struct Limb {
  int part = -1;
  double size = 0;        ///< px
  Point2 root;            ///< middle of what it has in common with the trunk
  double confidence = 0;  ///< that it lies in front of the trunk, or behind it
};

/// Two limbs on either side of the trunk, or the reasons why they are none.
struct LimbPair {
  double alike = 0;     ///< smaller size over larger one
  double step = 0;      ///< difference of the roots' heights over the trunk's
  double distance = 0;  ///< of the roots over the trunk's width, positive where the near is right
  double shift = 0;     ///< of their middle against the trunk's, over their distance

  bool are_counterparts() const { return alike >= least_alike && step <= largest_step; }
  double cost() const { return 1 - alike + step / largest_step + std::abs(distance); }
  double confidence() const {
    return alike * (1 - step / largest_step) * std::max(0.0, 1 - shift / largest_shift);
  }
};

class LeanProposer {
 public:
  LeanProposer(const PartRegions& regions, const Stacking& stacking, const Completion& shapes,
               const JoinProposals& joining)
      : regions_(regions), stacking_(stacking), shapes_(shapes), joining_(joining) {
    for (int part = 0; part < regions.count(); ++part)
      around_.push_back(surroundings(regions, stacking, part));
    find_trunk();
  }

  std::vector<ProposedLean> run() const {
    const std::vector<Limb> near = limbs(true);
    const std::vector<Limb> far = limbs(false);
    double sum = 0;
    double weight = 0;
    double confidence = 0;
    for (size_t i = 0; i < near.size(); ++i) {
      const std::optional<size_t> other = counterpart(near[i], far);
      if (!other || counterpart(far[*other], near) != i) continue;
      const LimbPair pair = compare(near[i], far[*other]);
      const double sure = pair.confidence() * std::min(near[i].confidence, far[*other].confidence);
      sum += sure * std::copysign(lean_of_roots(std::abs(pair.distance)), pair.distance);
      weight += sure;
      confidence = std::max(confidence, sure);
    }
    std::vector<ProposedLean> leans;
    if (confidence < least_confidence || sum == 0) return leans;
    for (const int part : trunk_.parts) leans.push_back({part, {sum / weight, 0}, confidence});
    return leans;
  }

 private:
  void find_trunk() {
    const int count = regions_.count();
    trunk_.has.assign(static_cast<size_t>(count), 0);
    int largest = 0;
    for (int part = 1; part < count; ++part)
      if (size_of(shapes_, part) > size_of(shapes_, largest)) largest = part;
    trunk_.has[largest] = 1;
    const double least = least_trunk * size_of(shapes_, largest);
    for (const ProposedJoin& proposed : joining_.joins) {
      const Join& join = proposed.join;
      if (join.upper != largest && join.lower != largest) continue;
      const int other = join.upper == largest ? join.lower : join.upper;
      if (size_of(shapes_, other) >= least) trunk_.has[other] = 1;
    }
    for (const int part : stacking_.back_to_front) {
      const std::vector<int>& lower = around_[part].lower;
      const auto of_trunk = [&](int k) { return trunk_.has[k] != 0; };
      if (around_[part].enclosed && !lower.empty() &&
          std::all_of(lower.begin(), lower.end(), of_trunk))
        trunk_.has[part] = 1;
    }
    measure_trunk();
  }

  void measure_trunk() {
    int top = std::numeric_limits<int>::max();
    int bottom = std::numeric_limits<int>::min();
    for (int part = 0; part < regions_.count(); ++part) {
      if (trunk_.has[part] == 0) continue;
      trunk_.parts.push_back(part);
      if (!around_[part].enclosed) trunk_.size += size_of(shapes_, part);
      top = std::min(top, shapes_.parts[part].shape.top);
      bottom = std::max(bottom, shapes_.parts[part].shape.bottom());
    }
    trunk_.height = bottom - top;
  }

  bool touches(int upper, int lower) const {
    return std::binary_search(around_[upper].lower.begin(), around_[upper].lower.end(), lower);
  }

  /// How sure it is that one of two parts is in front of the other; 0 where they do not touch.
  double arrow(int upper, int lower) const {
    if (!touches(upper, lower)) return 0;
    for (const OrderArrow& arrow : stacking_.arrows)
      if (arrow.upper == upper && arrow.lower == lower && arrow.kept) return arrow.confidence;
    return 0;
  }

  /// Those in front of the trunk, or behind it. Of parts that touch each other, as those of an arm
  /// do, only the largest is rooted in the trunk.
  std::vector<Limb> limbs(bool near) const {
    std::vector<Limb> all;
    for (int part = 0; part < regions_.count(); ++part)
      if (const auto limb = limb_of(part, near)) all.push_back(*limb);
    std::vector<Limb> rooted;
    for (const Limb& limb : all) {
      const auto hides = [&](const Limb& other) {
        const bool together = touches(limb.part, other.part) || touches(other.part, limb.part);
        return together && other.size > limb.size;
      };
      if (std::none_of(all.begin(), all.end(), hides)) rooted.push_back(limb);
    }
    return rooted;
  }

  std::optional<Limb> limb_of(int part, bool near) const {
    if (trunk_.has[part] != 0 || around_[part].enclosed) return std::nullopt;
    Limb limb{part, size_of(shapes_, part), {}, 0};
    if (limb.size > largest_limb * trunk_.size) return std::nullopt;
    for (const int other : trunk_.parts)
      limb.confidence = std::max(limb.confidence, near ? arrow(part, other) : arrow(other, part));
    if (limb.confidence == 0) return std::nullopt;
    double common = 0;
    for_each_pixel(shapes_.parts[part].shape, [&](int x, int y) {
      const auto covers = [&](int k) { return shapes_.parts[k].shape.has(x, y); };
      if (std::none_of(trunk_.parts.begin(), trunk_.parts.end(), covers)) return;
      limb.root = limb.root + Point2{x + 0.5, y + 0.5};
      common += 1;
    });
    if (common == 0) return std::nullopt;
    limb.root = 1 / common * limb.root;
    return limb;
  }

  LimbPair compare(const Limb& near, const Limb& far) const {
    LimbPair pair;
    pair.alike = std::min(near.size, far.size) / std::max(near.size, far.size);
    pair.step = std::abs(near.root.y - far.root.y) / trunk_.height;
    const Span span = span_at(shapes_, trunk_, (near.root.y + far.root.y) / 2);
    if (!(span.to > span.from) || near.root.x == far.root.x) return LimbPair();
    pair.distance = (near.root.x - far.root.x) / (span.to - span.from);
    pair.shift = std::abs((near.root.x + far.root.x - span.from - span.to) / 2) /
                 std::abs(near.root.x - far.root.x);
    return pair;
  }

  /// The most alike of the others.
  std::optional<size_t> counterpart(const Limb& limb, const std::vector<Limb>& others) const {
    std::optional<size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < others.size(); ++i) {
      const LimbPair pair = compare(limb, others[i]);
      if (!pair.are_counterparts() || pair.cost() >= least) continue;
      least = pair.cost();
      best = i;
    }
    return best;
  }

  const PartRegions& regions_;
  const Stacking& stacking_;
  const Completion& shapes_;
  const JoinProposals& joining_;
  std::vector<Surroundings> around_;
  Trunk trunk_;
};

}  // namespace

double lean_of_roots(double relative_distance) {
  const double r = std::min(relative_distance, 1.0);
  const double trust =
      std::clamp((r - least_distance) / (sure_distance - least_distance), 0.0, 1.0);
  return trust * (1 / assumed_depth - assumed_depth) * r * std::sqrt(1 - r * r);
}

std::vector<ProposedLean> propose_leans(const PartRegions& regions, const Stacking& stacking,
                                        const Completion& shapes, const JoinProposals& joining) {
  if (regions.count() == 0) return {};
  return LeanProposer(regions, stacking, shapes, joining).run();
}

}  // namespace relievo::understanding
