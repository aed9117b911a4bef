#include "solid/settle_heights.h"

#include <algorithm>

namespace relievo {
namespace {

class Settler {
 public:
  Settler(const FieldEdges& edges, HeightField& field)
      : edges_(edges), field_(field), fans_(collect_fans(field, edges)) {
    vertices_.resize(field.points.size());
    for (const std::array<int, 3>& triangle : field.triangles)
      for (const int v : triangle) {
        std::vector<int>& here = vertices_[field.vertex_point[v]];
        if (std::find(here.begin(), here.end(), v) == here.end()) here.push_back(v);
      }
  }

  /// Heights only rise, and only to others at the same point, so this ends.
  void settle() {
    while (uncross() || fill()) {
    }
  }

 private:
  /// Returns the vertices of t, then those of the triangle across edge k of t, over its two ends.
  std::array<std::array<int, 2>, 2> sides(int t, int k) const {
    const std::array<int, 3>& own = field_.triangles[t];
    const int o = edges_.across[t][k];
    const std::array<int, 3>& other = field_.triangles[o];
    int m = 0;
    while (edges_.across[o][m] != t ||
           field_.vertex_point[other[m]] != field_.vertex_point[own[(k + 1) % 3]])
      ++m;
    return {{{own[k], own[(k + 1) % 3]}, {other[(m + 1) % 3], other[m]}}};
  }

  int64_t height(int vertex) const { return field_.vertex_height[vertex]; }

  /// Joins the two sides of edges at which they change order, at the end where they differ less.
  bool uncross() {
    bool changed = false;
    for (int t = 0; t < static_cast<int>(field_.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k) {
        if (edges_.across[t][k] <= t) continue;
        const auto [own, other] = sides(t, k);
        const int64_t a = height(own[0]) - height(other[0]);
        const int64_t b = height(own[1]) - height(other[1]);
        if ((a < 0) == (b < 0) || a == 0 || b == 0) continue;
        const int end = std::abs(a) <= std::abs(b) ? 0 : 1;
        lift(own[end], other[end]);
        changed = true;
      }
    return changed;
  }

  /// Raises all vertices at one point between the heights of two of them to the higher one.
  void lift(int a, int b) {
    const auto [low, high] = std::minmax({height(a), height(b)});
    for (const int v : vertices_[field_.vertex_point[a]])
      if (height(v) >= low && height(v) < high) field_.vertex_height[v] = high;
  }

  bool fill() {
    bool changed = false;
    for (size_t f = 0; f < fans_.size(); ++f) changed = fill_fan(f) || changed;
    return changed;
  }

  /// Raises heights so that from the lowest side to the highest none falls, either way around.
  bool fill_fan(size_t f) {
    ring_.clear();
    for (int i = fans_.begin[f]; i < fans_.begin[f + 1]; ++i)
      ring_.push_back(field_.corner_vertex(fans_.corners[i]));
    const auto lower = [this](int a, int b) { return height(a) < height(b); };
    if (fans_.closed[f] != 0)
      std::rotate(ring_.begin(), std::min_element(ring_.begin(), ring_.end(), lower), ring_.end());
    const auto top = std::max_element(ring_.begin(), ring_.end(), lower);
    bool changed = climb(ring_.begin(), top);
    changed = climb(ring_.rbegin(), std::make_reverse_iterator(top + 1)) || changed;
    return changed;
  }

  template <class Iterator>
  bool climb(Iterator from, Iterator top) {
    bool changed = false;
    int64_t level = 0;
    for (; from != top; ++from) {
      if (height(*from) < level) {
        field_.vertex_height[*from] = level;
        changed = true;
      }
      level = std::max(level, height(*from));
    }
    return changed;
  }

  const FieldEdges& edges_;
  HeightField& field_;
  CornerFans fans_;
  std::vector<std::vector<int>> vertices_;  ///< by point
  std::vector<int> ring_;
};

}  // namespace

void settle_heights(const FieldEdges& edges, HeightField& field) { Settler(edges, field).settle(); }

}  // namespace relievo
