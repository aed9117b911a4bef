#include "relief/finish/open_outlines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace relievo::relief {
namespace {

/// An edge from a to b, with its triangle on the left.
struct HalfEdge {
  int a = 0;
  int b = 0;
  int part = 0;
};

/// Returns the edges whose twin is missing or belongs to a part behind, by part and first vertex.
std::vector<HalfEdge> open_edges(const Model& model) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * model.triangles.size());
  for (size_t p = 0; p < model.parts.size(); ++p)
    for (int t = model.parts[p].first_triangle; t < model.parts[p].end(); ++t)
      for (size_t k = 0; k < 3; ++k)
        edges.push_back(
            {model.triangles[t][k], model.triangles[t][(k + 1) % 3], static_cast<int>(p)});
  const auto key = [](const HalfEdge& e) { return std::minmax(e.a, e.b); };
  std::sort(edges.begin(), edges.end(),
            [&key](const HalfEdge& e, const HalfEdge& f) { return key(e) < key(f); });
  std::vector<HalfEdge> open;
  for (size_t i = 0; i < edges.size();) {
    size_t end = i + 1;
    while (end < edges.size() && key(edges[end]) == key(edges[i])) ++end;
    for (size_t e = i; e < end; ++e) {
      const auto is_above = [&](const HalfEdge& other) { return other.part < edges[e].part; };
      if (end == i + 1 || (end == i + 2 && is_above(edges[e == i ? i + 1 : i])))
        open.push_back(edges[e]);
    }
    i = end;
  }
  std::sort(open.begin(), open.end(), [](const HalfEdge& e, const HalfEdge& f) {
    return std::pair(e.part, e.a) < std::pair(f.part, f.a);
  });
  return open;
}

/// Follows open edges from one to the next.
class ChainWalk {
 public:
  explicit ChainWalk(std::vector<HalfEdge> edges)
      : edges_(std::move(edges)), taken_(edges_.size(), false), entered_(edges_.size(), false) {
    for (const HalfEdge& e : edges_)
      if (const auto next = from(e.part, e.b); next < edges_.size()) entered_[next] = true;
  }

  std::vector<OpenOutline> walk() {
    std::vector<OpenOutline> chains;
    for (const bool loops : {false, true})
      for (size_t e = 0; e < edges_.size(); ++e)
        if (!taken_[e] && (loops || !entered_[e])) chains.push_back(follow(e));
    std::stable_sort(chains.begin(), chains.end(),
                     [](const OpenOutline& a, const OpenOutline& b) { return a.part < b.part; });
    return chains;
  }

 private:
  /// Returns the first free edge of a part that begins at a vertex, or the number of edges.
  size_t from(int part, int vertex) const {
    auto e = std::lower_bound(edges_.begin(), edges_.end(), std::pair(part, vertex),
                              [](const HalfEdge& edge, const std::pair<int, int>& k) {
                                return std::pair(edge.part, edge.a) < k;
                              });
    while (e != edges_.end() && e->part == part && e->a == vertex) {
      if (!taken_[e - edges_.begin()]) return e - edges_.begin();
      ++e;
    }
    return edges_.size();
  }

  OpenOutline follow(size_t e) {
    OpenOutline chain;
    chain.part = edges_[e].part;
    chain.vertices.push_back(edges_[e].a);
    while (e < edges_.size()) {
      taken_[e] = true;
      chain.vertices.push_back(edges_[e].b);
      e = from(chain.part, edges_[e].b);
    }
    if (chain.vertices.front() == chain.vertices.back()) {
      chain.closed = true;
      chain.vertices.pop_back();
    }
    return chain;
  }

  std::vector<HalfEdge> edges_;
  std::vector<bool> taken_;
  std::vector<bool> entered_;
};

Point2 to_the_right(const Model& model, int a, int b) {
  const Point3 edge = model.positions[b] - model.positions[a];
  const Point2 right{edge.y, -edge.x};
  const double length = norm(right);
  return length > 0 ? (1 / length) * right : Point2{};
}

void point_outwards(const Model& model, OpenOutline& chain) {
  const size_t n = chain.vertices.size();
  for (size_t i = 0; i < n; ++i) {
    Point2 sum;
    if (i > 0 || chain.closed)
      sum = sum + to_the_right(model, chain.vertices[(i + n - 1) % n], chain.vertices[i]);
    if (i + 1 < n || chain.closed)
      sum = sum + to_the_right(model, chain.vertices[i], chain.vertices[(i + 1) % n]);
    const double length = norm(sum);
    chain.out.push_back(length > 0 ? (1 / length) * sum : Point2{});
  }
}

}  // namespace

std::vector<OpenOutline> open_outlines(const Model& model) {
  std::vector<OpenOutline> chains = ChainWalk(open_edges(model)).walk();
  for (OpenOutline& chain : chains) point_outwards(model, chain);
  return chains;
}

}  // namespace relievo::relief
