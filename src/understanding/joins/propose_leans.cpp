#include "understanding/joins/propose_leans.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "understanding/joins/roots.h"

namespace relievo::understanding {
namespace {

constexpr double assumed_depth = 0.8;  ///< q: depth of a trunk over its width
/// Distances of roots over the trunk's width: nearer ones than the first tell nothing, and farther
/// ones than the second count fully.
constexpr double least_distance = 0.25;
constexpr double sure_distance = 0.4;
/// The least size of a part of the trunk, over that of the largest part to which it is joined.
constexpr double least_trunk = 0.25;
constexpr double largest_limb = 0.25;  ///< size of a limb over the trunk's
/// Counterparts: the least ratio of their sizes, the largest difference of their roots' heights
/// over the trunk's, and the largest distance of the middle between the roots from the trunk's,
/// over the roots' distance.
constexpr double least_alike = 0.4;
constexpr double largest_step = 0.25;
constexpr double largest_shift = 0.3;
constexpr double least_confidence = 0.2;  ///< of a proposed tilt

/// A part that comes out from the trunk.
struct Limb {
  int part = -1;
  double size = 0;        ///< px
  Point2 root;            ///< mean of the pixels that it has in common with the trunk
  double confidence = 0;  ///< of its order relative to the trunk
};

/// A limb in front of the trunk and one behind it.
struct LimbPair {
  double alike = 0;     ///< smaller size over larger one
  double step = 0;      ///< difference of the roots' heights over the trunk's
  double distance = 0;  ///< of the roots over the trunk's width; positive where the near is right
  double shift = 0;     ///< of the roots' middle from the trunk's, over their distance

  bool are_counterparts() const { return alike >= least_alike && step <= largest_step; }
  double cost() const { return 1 - alike + step / largest_step + std::abs(distance); }
  double confidence() const {
    return alike * (1 - step / largest_step) * std::max(0.0, 1 - shift / largest_shift);
  }
};

class LeanProposer {
 public:
  LeanProposer(const PartRegions& regions, const std::vector<OrderArrow>& order,
               const Completion& shapes, const std::vector<ProposedJoin>& joins)
      : regions_(regions), order_(order), shapes_(shapes), in_trunk_(shapes.size(), 0) {
    for (int part = 0; part < regions.count(); ++part)
      around_.push_back(surroundings(regions, part));
    find_trunk(joins);
    measure_trunk();
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
    for (const int part : trunk_) leans.push_back({part, {sum / weight, 0}, confidence});
    return leans;
  }

 private:
  double size_of(int part) const { return static_cast<double>(pixel_count(shapes_[part].shape)); }

  void find_trunk(const std::vector<ProposedJoin>& joins) {
    const std::vector<int> parts = regions_.by_label();
    int largest = parts.front();
    for (const int part : parts)
      if (size_of(part) > size_of(largest)) largest = part;
    in_trunk_[largest] = 1;
    const double least = least_trunk * size_of(largest);
    for (const ProposedJoin& proposed : joins) {
      const Join& join = proposed.join;
      if (join.upper != largest && join.lower != largest) continue;
      const int other = join.upper == largest ? join.lower : join.upper;
      if (size_of(other) >= least) in_trunk_[other] = 1;
    }
    for (int part = 0; part < regions_.count(); ++part) {
      const std::vector<int>& lower = around_[part].lower;
      const auto of_trunk = [&](int k) { return in_trunk_[k] != 0; };
      if (around_[part].enclosed && !lower.empty() &&
          std::all_of(lower.begin(), lower.end(), of_trunk))
        in_trunk_[part] = 1;
    }
    for (const int part : parts)
      if (in_trunk_[part] != 0) trunk_.push_back(part);
  }

  void measure_trunk() {
    int top = std::numeric_limits<int>::max();
    int bottom = std::numeric_limits<int>::min();
    for (const int part : trunk_) {
      if (!around_[part].enclosed) trunk_size_ += size_of(part);
      top = std::min(top, shapes_[part].shape.top);
      bottom = std::max(bottom, shapes_[part].shape.bottom());
    }
    trunk_height_ = bottom - top;
  }

  /// The left and right end of the trunk in the row of y, as a box without height.
  Box2 trunk_at(double y) const {
    Box2 span;
    const int row = static_cast<int>(std::floor(y));
    for (const int part : trunk_) {
      const Mask& mask = shapes_[part].shape;
      for (int x = mask.left; x < mask.right(); ++x) {
        if (!mask.has(x, row)) continue;
        span.add(Point2{x * 1.0, y});
        span.add(Point2{x + 1.0, y});
      }
    }
    return span;
  }

  bool touches(int upper, int lower) const {
    const std::vector<int>& touched = around_[upper].lower;
    return std::find(touched.begin(), touched.end(), lower) != touched.end();
  }

  /// The confidence that one of two parts is in front of the other; 0 where they do not touch.
  double arrow(int upper, int lower) const {
    if (!touches(upper, lower)) return 0;
    for (const OrderArrow& arrow : order_)
      if (arrow.upper == regions_.labels[upper] && arrow.lower == regions_.labels[lower] &&
          arrow.kept)
        return arrow.confidence;
    return 0;
  }

  /// The limbs in front of the trunk (`near`), or behind it. Of parts that touch each other, as
  /// those of an arm do, only the largest is rooted in the trunk.
  std::vector<Limb> limbs(bool near) const {
    std::vector<Limb> all;
    for (const int part : regions_.by_label())
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
    if (in_trunk_[part] != 0 || around_[part].enclosed) return std::nullopt;
    Limb limb{part, size_of(part), {}, 0};
    if (limb.size > largest_limb * trunk_size_) return std::nullopt;
    for (const int other : trunk_)
      limb.confidence = std::max(limb.confidence, near ? arrow(part, other) : arrow(other, part));
    if (limb.confidence == 0) return std::nullopt;
    double common = 0;
    for_each_pixel(shapes_[part].shape, [&](int x, int y) {
      const auto covers = [&](int k) { return shapes_[k].shape.has(x, y); };
      if (std::none_of(trunk_.begin(), trunk_.end(), covers)) return;
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
    pair.step = std::abs(near.root.y - far.root.y) / trunk_height_;
    const Box2 span = trunk_at((near.root.y + far.root.y) / 2);
    if (span.empty() || near.root.x == far.root.x) return LimbPair();
    pair.distance = (near.root.x - far.root.x) / (span.max.x - span.min.x);
    pair.shift = std::abs((near.root.x + far.root.x - span.min.x - span.max.x) / 2) /
                 std::abs(near.root.x - far.root.x);
    return pair;
  }

  /// The index of the counterpart with the least cost among others.
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
  const std::vector<OrderArrow>& order_;
  const Completion& shapes_;
  std::vector<Surroundings> around_;
  std::vector<uint8_t> in_trunk_;  ///< per part
  std::vector<int> trunk_;         ///< its parts
  double trunk_size_ = 0;          ///< px, without enclosed parts
  double trunk_height_ = 0;        ///< px
};

}  // namespace

double lean_of_roots(double relative_distance) {
  const double r = std::min(relative_distance, 1.0);
  const double trust =
      std::clamp((r - least_distance) / (sure_distance - least_distance), 0.0, 1.0);
  return trust * (1 / assumed_depth - assumed_depth) * r * std::sqrt(1 - r * r);
}

std::vector<ProposedLean> propose_leans(const PartRegions& regions,
                                        const std::vector<OrderArrow>& order,
                                        const Completion& shapes,
                                        const std::vector<ProposedJoin>& joins) {
  if (regions.count() == 0) return {};
  return LeanProposer(regions, order, shapes, joins).run();
}

}  // namespace relievo::understanding
