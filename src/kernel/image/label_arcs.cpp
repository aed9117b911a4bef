#include "kernel/image/label_arcs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>
#include <utility>

namespace relievo {
namespace {

/// Directions along the sides of pixels, clockwise on the screen: right, down, left, up.
constexpr std::array<int, 4> step_x = {1, 0, -1, 0};
constexpr std::array<int, 4> step_y = {0, 1, 0, -1};

/// Walks the sides of pixels that part labels, each once.
class ArcTracer {
 public:
  explicit ArcTracer(const Image16& labels)
      : labels_(labels),
        across_(labels.width + 1),
        visited_(static_cast<size_t>(across_) * (labels.height + 1), 0) {}

  std::vector<LabelArc> trace() {
    collect_junctions();
    for (const PixelCorner corner : junctions_)
      for (int d = 0; d < 4; ++d) follow(corner, d);
    for (int y = 0; y <= labels_.height; ++y)
      for (int x = 0; x <= labels_.width; ++x)
        if (may_differ(x, y)) follow({x, y}, 0);
    return std::move(arcs_);
  }

 private:
  uint16_t label(int x, int y) const {
    const bool inside = x >= 0 && y >= 0 && x < labels_.width && y < labels_.height;
    return inside ? labels_.at(x, y) : uint16_t{0};
  }

  /// Labels to the right and left of the side that leaves `c` in direction d.
  std::pair<uint16_t, uint16_t> sides(PixelCorner c, int d) const {
    switch (d) {
      case 0:
        return {label(c.x, c.y), label(c.x, c.y - 1)};
      case 1:
        return {label(c.x - 1, c.y), label(c.x, c.y)};
      case 2:
        return {label(c.x - 1, c.y - 1), label(c.x - 1, c.y)};
      default:
        return {label(c.x, c.y - 1), label(c.x - 1, c.y - 1)};
    }
  }

  bool parts(PixelCorner c, int d) const {
    const auto [right, left] = sides(c, d);
    return right != left;
  }

  /// Whether the pixels above and below the side to the right of (x, y) differ.
  bool may_differ(int x, int y) const {
    return x < labels_.width && label(x, y) != label(x, y - 1);
  }

  int degree(PixelCorner c) const {
    int count = 0;
    for (int d = 0; d < 4; ++d) count += parts(c, d) ? 1 : 0;
    return count;
  }

  void collect_junctions() {
    for (int y = 0; y <= labels_.height; ++y)
      for (int x = 0; x <= labels_.width; ++x) {
        const bool uniform = label(x - 1, y - 1) == label(x, y - 1) &&
                             label(x - 1, y) == label(x, y) && label(x, y - 1) == label(x, y);
        if (!uniform && degree({x, y}) > 2) junctions_.push_back({x, y});
      }
  }

  uint8_t& visited(PixelCorner c) { return visited_[static_cast<size_t>(c.y) * across_ + c.x]; }

  /// Follows the boundary from `start` in direction d to the next junction or back to `start`.
  void follow(PixelCorner start, int d) {
    if ((visited(start) >> d & 1) != 0 || !parts(start, d)) return;
    LabelArc arc;
    std::tie(arc.right, arc.left) = sides(start, d);
    arc.corners = {start};
    PixelCorner c = start;
    do {
      visited(c) |= static_cast<uint8_t>(1 << d);
      c = {c.x + step_x[d], c.y + step_y[d]};
      visited(c) |= static_cast<uint8_t>(1 << (d + 2) % 4);
      arc.corners.push_back(c);
      if (c == start || degree(c) > 2) break;
      const int back = (d + 2) % 4;
      d = 0;
      while (d == back || !parts(c, d)) ++d;
    } while (true);
    arcs_.push_back(std::move(arc));
  }

  const Image16& labels_;
  int across_;
  std::vector<uint8_t> visited_;  ///< bit d: the side that leaves the corner in direction d
  std::vector<PixelCorner> junctions_;
  std::vector<LabelArc> arcs_;
};

/// An arc as it leaves a corner with a label to its right.
struct Departure {
  uint16_t label;
  PixelCorner from;
  ArcUse use;
  friend bool operator<(const Departure& a, const Departure& b) {
    return std::tie(a.label, a.from.y, a.from.x, a.use.arc) <
           std::tie(b.label, b.from.y, b.from.x, b.use.arc);
  }
};

/// Joins departures to rings.
class RingJoiner {
 public:
  explicit RingJoiner(const std::vector<LabelArc>& arcs) : arcs_(arcs) {
    for (int a = 0; a < static_cast<int>(arcs.size()); ++a) {
      departures_.push_back({arcs[a].right, arcs[a].corners.front(), {a, true}});
      departures_.push_back({arcs[a].left, arcs[a].corners.back(), {a, false}});
    }
    std::sort(departures_.begin(), departures_.end());
    used_.assign(departures_.size(), false);
  }

  std::vector<std::vector<std::vector<ArcUse>>> rings() {
    std::vector<std::vector<std::vector<ArcUse>>> result(1);
    for (size_t i = 0; i < departures_.size(); ++i) {
      const uint16_t label = departures_[i].label;
      if (used_[i] || label == 0) continue;
      if (result.size() <= label) result.resize(label + size_t{1});
      result[label].push_back(ring_from(i));
    }
    return result;
  }

 private:
  std::vector<ArcUse> ring_from(size_t start) {
    std::vector<ArcUse> ring;
    size_t i = start;
    do {
      used_[i] = true;
      ring.push_back(departures_[i].use);
      i = departure_after(departures_[i]);
    } while (i != start);
    return ring;
  }

  /// The k-th corner of a use of an arc, counted from its end.
  PixelCorner corner_from_end(ArcUse use, size_t k) const {
    const std::vector<PixelCorner>& corners = arcs_[use.arc].corners;
    return use.forward ? corners[corners.size() - 1 - k] : corners[k];
  }

  /// Which departure goes on around the same pixels: the one that turns right most sharply.
  size_t departure_after(const Departure& arrival) const {
    const PixelCorner at = corner_from_end(arrival.use, 0);
    const PixelCorner before = corner_from_end(arrival.use, 1);
    const int dx = at.x - before.x;
    const int dy = at.y - before.y;
    const auto first = std::lower_bound(departures_.begin(), departures_.end(),
                                        Departure{arrival.label, at, {-1, true}});
    size_t best = departures_.size();
    int best_turn = -2;
    for (auto d = first; d != departures_.end() && d->label == arrival.label && d->from == at;
         ++d) {
      const PixelCorner next = corner_from_end({d->use.arc, !d->use.forward}, 1);
      const int turn = dx * (next.y - at.y) - dy * (next.x - at.x);
      if (turn <= best_turn) continue;
      best_turn = turn;
      best = static_cast<size_t>(d - departures_.begin());
    }
    assert(best < departures_.size());
    return best;
  }

  const std::vector<LabelArc>& arcs_;
  std::vector<Departure> departures_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<LabelArc> trace_label_arcs(const Image16& labels) {
  assert(labels.channels == 1);
  return ArcTracer(labels).trace();
}

std::vector<std::vector<std::vector<ArcUse>>> label_rings(const std::vector<LabelArc>& arcs) {
  return RingJoiner(arcs).rings();
}

}  // namespace relievo
