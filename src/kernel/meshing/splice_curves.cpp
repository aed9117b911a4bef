#include "kernel/meshing/splice_curves.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "kernel/meshing/segment_grid.h"
#include "kernel/meshing/triangulate.h"

namespace relievo {
namespace {

constexpr int max_rounds = 40;
constexpr size_t max_points = 10000000;

/// A point to be inserted into an edge at parameter t of it.
struct Insertion {
  int edge;
  double t;
  int point;
};

using Edges = std::vector<std::array<int, 2>>;

/// Removes repeated points and spikes a-b-a, whose edges cancel.
std::vector<int> tidied(const std::vector<int>& loop, bool open) {
  std::vector<int> tidy;
  for (const int p : loop) {
    if (!tidy.empty() && tidy.back() == p) continue;
    if (tidy.size() >= 2 && tidy[tidy.size() - 2] == p)
      tidy.pop_back();
    else
      tidy.push_back(p);
  }
  size_t first = 0;
  while (!open && tidy.size() - first > 1) {
    const bool spiky = tidy.size() - first > 2;
    if (tidy[first] == tidy.back() || (spiky && tidy[first] == tidy[tidy.size() - 2])) {
      tidy.pop_back();
    } else if (spiky && tidy[first + 1] == tidy.back()) {
      ++first;
    } else {
      break;
    }
  }
  tidy.erase(tidy.begin(), tidy.begin() + static_cast<std::ptrdiff_t>(first));
  if (tidy.size() < (open ? 2 : 3)) tidy.clear();
  return tidy;
}

SegmentGrid edge_grid(const std::vector<Point2>& points, const Edges& edges) {
  return {edges.size(),
          [&](size_t e) { return std::pair(points[edges[e][0]], points[edges[e][1]]); }};
}

/// Returns whether a point lies on, or nearly on, the inside of an edge; t is the parameter there.
bool touches(const std::vector<Point2>& points, int p, const std::array<int, 2>& edge, double reach,
             double grain, double& t) {
  if (p == edge[0] || p == edge[1]) return false;
  const Point2 a = points[edge[0]];
  const Point2 d = points[edge[1]] - a;
  const double length = norm(d);
  t = dot(points[p] - a, d) / (length * length);
  if (t <= 0 || t >= 1) return false;
  const double bound = std::max(0.5 * grain, std::min(reach, snap_to_edge * length));
  return std::abs(cross(d, points[p] - a)) <= bound * length;
}

/// Appends the points inserted into the edge between `ends`. Precondition: insertions are sorted.
void append_between(const std::array<int, 2>& ends, const Edges& edges,
                    const std::vector<Insertion>& insertions, std::vector<int>& loop) {
  const auto [a, b] = ends;
  const std::array<int, 2> key = {std::min(a, b), std::max(a, b)};
  const auto at = std::lower_bound(edges.begin(), edges.end(), key);
  if (at == edges.end() || *at != key) return;
  const int edge = static_cast<int>(at - edges.begin());
  auto first = std::lower_bound(insertions.begin(), insertions.end(), edge,
                                [](const Insertion& x, int e) { return x.edge < e; });
  const size_t before = loop.size();
  for (; first != insertions.end() && first->edge == edge; ++first) loop.push_back(first->point);
  if (a > b) std::reverse(loop.begin() + static_cast<std::ptrdiff_t>(before), loop.end());
}

/// A point of a curve and the distance by which it may move to another.
struct Item {
  int curve;
  int index;
  bool kept;
  double reach;
};

/// Welds the points of all curves, the first `closed` of them closed: each becomes a point of its
/// own or that of an earlier one close to it. Kept points come first, so that others move to them.
SplicedCurves welded(const std::vector<InputCurve>& curves, size_t closed) {
  SplicedCurves out;
  std::vector<Item> items;
  for (size_t c = 0; c < curves.size(); ++c) {
    const Ring& ring = curves[c].points;
    const size_t n = ring.size();
    for (size_t i = 0; i < n; ++i) {
      const bool first = c >= closed && i == 0;
      const bool last = c >= closed && i + 1 == n;
      const double edge = std::min(distance(ring[i], ring[last ? i - 1 : (i + 1) % n]),
                                   distance(ring[i], ring[first ? 1 : (i + n - 1) % n]));
      items.push_back(
          {static_cast<int>(c), static_cast<int>(i), curves[c].kept[i], snap_to_vertex * edge});
    }
    out.image.emplace_back(n);
  }
  std::stable_partition(items.begin(), items.end(), [](const Item& item) { return item.kept; });
  const auto position = [&](const Item& item) { return curves[item.curve].points[item.index]; };
  const SegmentGrid grid(
      items.size(), [&](size_t i) { return std::pair(position(items[i]), position(items[i])); });
  std::vector<int> point_of(items.size(), -1);
  for (size_t i = 0; i < items.size(); ++i) {
    const Point2 p = position(items[i]);
    int found = -1;
    double nearest = std::numeric_limits<double>::infinity();
    grid.for_each_near(p, p, items[i].reach, [&](int j) {
      if (static_cast<size_t>(j) >= i) return;
      const double gap = distance(p, out.points[point_of[j]]);
      if (gap > std::min(items[i].reach, items[j].reach) || gap >= nearest) return;
      nearest = gap;
      found = point_of[j];
    });
    if (found < 0) {
      found = static_cast<int>(out.points.size());
      out.points.push_back(p);
    }
    point_of[i] = found;
    out.image[items[i].curve][items[i].index] = found;
  }
  out.loops = out.image;
  return out;
}

/// Splits edges at contacts and crossings until there are none.
class Splicer {
 public:
  Splicer(const std::vector<InputCurve>& curves, const std::vector<InputCurve>& lines, double grain)
      : curves_(curves), closed_(curves.size()), grain_(grain) {
    curves_.insert(curves_.end(), lines.begin(), lines.end());
    out_ = welded(curves_, closed_);
  }

  Result<SplicedCurves> run() {
    for (int round = 0; round < max_rounds; ++round) {
      merge_grains();
      tidy_loops();
      collect_edges();
      std::vector<Insertion> insertions = find_contacts();
      if (insertions.empty()) insertions = find_crossings();
      if (insertions.empty()) return separated();
      if (insertions.size() + out_.points.size() > max_points)
        return Error{ErrorCode::limit, "the outlines cross each other too often", ""};
      insert(insertions);
    }
    return Error{ErrorCode::bad_input, "the outlines are too tangled to be separated", ""};
  }

 private:
  /// Returns the number of edges: a loop is closed, a line, which comes after all loops, is not.
  size_t edge_count(const std::vector<int>& loop) const {
    const bool open = &loop >= out_.loops.data() + closed_;
    return loop.size() - (open && !loop.empty() ? 1 : 0);
  }

  /// Returns the result, with loops and lines apart.
  SplicedCurves separated() {
    const auto first = out_.loops.begin() + static_cast<std::ptrdiff_t>(closed_);
    out_.lines.assign(std::make_move_iterator(first), std::make_move_iterator(out_.loops.end()));
    out_.loops.resize(closed_);
    out_.image.resize(closed_);
    return std::move(out_);
  }

  /// Replaces points nearer to an earlier one than the grain by that one.
  void merge_grains() {
    const SegmentGrid grid(out_.points.size(),
                           [&](size_t i) { return std::pair(out_.points[i], out_.points[i]); });
    std::vector<int> stands_for(out_.points.size());
    bool any = false;
    for (size_t i = 0; i < stands_for.size(); ++i) {
      const Point2 p = out_.points[i];
      int found = static_cast<int>(i);
      grid.for_each_near(p, p, grain_, [&](int j) {
        if (j < found && stands_for[j] == j && distance(p, out_.points[j]) <= grain_) found = j;
      });
      stands_for[i] = found;
      any = any || found != static_cast<int>(i);
    }
    if (!any) return;
    for (std::vector<std::vector<int>>* curves : {&out_.loops, &out_.image})
      for (std::vector<int>& curve : *curves)
        for (int& p : curve) p = stands_for[p];
  }

  void tidy_loops() {
    for (std::vector<int>& loop : out_.loops) loop = tidied(loop, edge_count(loop) < loop.size());
  }

  /// Collects the distinct undirected edges of all loops, sorted.
  void collect_edges() {
    edges_.clear();
    for (const std::vector<int>& loop : out_.loops)
      for (size_t i = 0; i < edge_count(loop); ++i) {
        const int a = loop[i];
        const int b = loop[(i + 1) % loop.size()];
        edges_.push_back({std::min(a, b), std::max(a, b)});
      }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    shortest_.assign(out_.points.size(), std::numeric_limits<double>::infinity());
    for (const auto& [a, b] : edges_) {
      const double length = distance(out_.points[a], out_.points[b]);
      shortest_[a] = std::min(shortest_[a], length);
      shortest_[b] = std::min(shortest_[b], length);
    }
  }

  /// Finds vertices that lie on, or nearly on, the inside of an edge.
  std::vector<Insertion> find_contacts() const {
    std::vector<Insertion> found;
    const SegmentGrid grid = edge_grid(out_.points, edges_);
    for (size_t p = 0; p < out_.points.size(); ++p) {
      if (shortest_[p] == std::numeric_limits<double>::infinity()) continue;
      const Point2 x = out_.points[p];
      const double reach = std::max(0.5 * grain_, snap_to_edge * shortest_[p]);
      const size_t first = found.size();
      grid.for_each_near(x, x, reach, [&](int e) {
        double t = 0;
        if (!touches(out_.points, static_cast<int>(p), edges_[e], reach, grain_, t)) return;
        const auto same = [&](const Insertion& other) { return other.edge == e; };
        if (std::none_of(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(), same))
          found.push_back({e, t, static_cast<int>(p)});
      });
    }
    return found;
  }

  /// Finds proper crossings of two edges; each becomes a vertex of both.
  std::vector<Insertion> find_crossings() {
    std::vector<Insertion> found;
    const SegmentGrid grid = edge_grid(out_.points, edges_);
    std::vector<int> seen(edges_.size(), -1);
    for (size_t e = 0; e < edges_.size(); ++e) {
      const Point2 a = out_.points[edges_[e][0]];
      const Point2 b = out_.points[edges_[e][1]];
      grid.for_each_near(a, b, 0, [&](int f) {
        if (static_cast<size_t>(f) <= e || seen[f] == static_cast<int>(e)) return;
        seen[f] = static_cast<int>(e);
        add_crossing(static_cast<int>(e), f, found);
      });
    }
    return found;
  }

  void add_crossing(int e, int f, std::vector<Insertion>& found) {
    const auto [a, b] = edges_[e];
    const auto [c, d] = edges_[f];
    if (a == c || a == d || b == c || b == d) return;
    const Point2 pa = out_.points[a], pb = out_.points[b], pc = out_.points[c], pd = out_.points[d];
    if (orientation(pa, pb, pc) * orientation(pa, pb, pd) >= 0) return;
    if (orientation(pc, pd, pa) * orientation(pc, pd, pb) >= 0) return;
    const double denominator = cross(pb - pa, pd - pc);
    const double t = std::clamp(cross(pc - pa, pd - pc) / denominator, 0.0, 1.0);
    const Point2 x = pa + t * (pb - pa);
    const double reach =
        std::max(grain_, snap_to_vertex * std::min(distance(pa, pb), distance(pc, pd)));
    int vertex = -1;
    double nearest = reach;
    for (const int p : {a, b, c, d})
      if (distance(x, out_.points[p]) <= nearest) {
        nearest = distance(x, out_.points[p]);
        vertex = p;
      }
    if (vertex < 0) {
      vertex = static_cast<int>(out_.points.size());
      out_.points.push_back(x);
    }
    const double s = dot(x - pc, pd - pc) / dot(pd - pc, pd - pc);
    if (vertex != a && vertex != b) found.push_back({e, t, vertex});
    if (vertex != c && vertex != d) found.push_back({f, s, vertex});
  }

  /// Threads the inserted points into every loop that has the edge.
  void insert(std::vector<Insertion>& insertions) {
    std::sort(insertions.begin(), insertions.end(), [](const Insertion& x, const Insertion& y) {
      return x.edge != y.edge ? x.edge < y.edge : (x.t != y.t ? x.t < y.t : x.point < y.point);
    });
    for (std::vector<int>& loop : out_.loops) {
      std::vector<int> longer;
      for (size_t i = 0; i < loop.size(); ++i) {
        const int a = loop[i];
        const int b = loop[(i + 1) % loop.size()];
        longer.push_back(a);
        if (i < edge_count(loop)) append_between({a, b}, edges_, insertions, longer);
      }
      loop = std::move(longer);
    }
  }

  std::vector<InputCurve> curves_;  ///< closed ones, then open ones
  size_t closed_;                   ///< number of closed ones
  double grain_;                    ///< least distance of two vertices
  SplicedCurves out_;
  Edges edges_;
  std::vector<double> shortest_;  ///< length of the shortest edge at each point
};

using Segment = std::pair<Point2, Point2>;

bool cross_inside(const Segment& s, const Segment& t) {
  return orientation(s.first, s.second, t.first) * orientation(s.first, s.second, t.second) < 0 &&
         orientation(t.first, t.second, s.first) * orientation(t.first, t.second, s.second) < 0;
}

Point2 meeting_point(const Segment& s, const Segment& t) {
  const Point2 along = s.second - s.first;
  const Point2 other = t.second - t.first;
  return s.first + (cross(t.first - s.first, other) / cross(along, other)) * along;
}

}  // namespace

Result<SplicedCurves> splice_curves(const std::vector<InputCurve>& curves,
                                    const std::vector<InputCurve>& lines, double grain) {
  return Splicer(curves, lines, grain).run();
}

std::optional<Point2> find_self_crossing(const Outline& outline) {
  std::vector<Segment> edges;
  for (const Ring& ring : outline)
    for (size_t i = 0; i < ring.size(); ++i)
      edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  const SegmentGrid grid(edges.size(), [&](size_t e) { return edges[e]; });
  std::optional<Point2> found;
  for (size_t e = 0; e < edges.size() && !found; ++e)
    grid.for_each_near(edges[e].first, edges[e].second, 0, [&](int other) {
      if (!found && cross_inside(edges[e], edges[other]))
        found = meeting_point(edges[e], edges[other]);
    });
  return found;
}

}  // namespace relievo
