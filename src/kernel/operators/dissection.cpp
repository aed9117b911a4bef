#include "kernel/operators/dissection.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <numeric>

namespace relievo {
namespace {

/// Groups of at most so many vertices are not divided.
constexpr int smallest_group = 8;
/// In smaller groups diagonal cuts and narrow bins gain little.
constexpr int large_group = 512;
/// Cuts are tried between bins of equal width in each direction: this many in large groups.
constexpr int most_bins = 128;
constexpr int few_bins = 24;
constexpr int most_directions = 4;
constexpr int few_directions = 2;
/// A cut that leaves more than this share on one side is taken only where there is no other.
constexpr double worst_balance = 0.8;
/// The cost of a separator is its weight times 1 + imbalance_penalty (larger share - 1/2)^2.
constexpr double imbalance_penalty = 8;

using Coordinates = std::array<double, most_directions>;
using Bins = std::array<uint8_t, most_directions>;

/// An integer for each bin of a direction.
using BinSums = std::array<int, most_bins>;

Coordinates coordinates(Point2 p) { return {p.x, p.y, p.x + p.y, p.x - p.y}; }

/// A cut of a group behind a bin; `direction` < 0 where the group cannot be divided.
struct Cut {
  int direction = -1;
  int bin = 0;  ///< the last bin before the cut
};

/// Orders the vertices of a mesh by recursive division into groups.
class Dissection {
 public:
  Dissection(const FlatMesh& mesh, std::span<const int> weights, const RunContext& context)
      : positions_(mesh.positions), weights_(weights), context_(context) {
    find_neighbours(mesh);
    vertices_.resize(positions_.size());
    std::iota(vertices_.begin(), vertices_.end(), 0);
    group_.resize(vertices_.size(), 0);
    bin_.resize(vertices_.size());
  }

  std::vector<int> run() {
    divide(0, static_cast<int>(vertices_.size()));
    return std::move(vertices_);
  }

 private:
  /// Lists the neighbours of each vertex, each once.
  void find_neighbours(const FlatMesh& mesh) {
    const NodeCorners corners = corners_at_nodes(mesh.triangles, positions_.size());
    begin_.reserve(positions_.size() + 1);
    neighbour_.reserve(4 * mesh.triangles.size());
    begin_.push_back(0);
    for (int v = 0; v < static_cast<int>(positions_.size()); ++v) {
      for (const Corner corner : corners.at(v)) {
        const Triangle& triangle = mesh.triangles[triangle_of(corner)];
        neighbour_.push_back(triangle[next_place(place_of(corner))]);
        neighbour_.push_back(triangle[last_place(place_of(corner))]);
      }
      const auto first = neighbour_.begin() + begin_.back();
      std::sort(first, neighbour_.end());
      neighbour_.erase(std::unique(first, neighbour_.end()), neighbour_.end());
      begin_.push_back(static_cast<int>(neighbour_.size()));
    }
  }

  /// Orders the vertices [first, last).
  void divide(int first, int last) {
    if (last - first <= smallest_group || context_.cancelled()) return;
    const int group = ++groups_;
    for (int i = first; i < last; ++i) group_[vertices_[i]] = group;
    const bool large = last - first >= large_group;
    bins_ = large ? most_bins : few_bins;
    directions_ = large ? most_directions : few_directions;
    fill_bins(first, last);
    const Cut cut = best_cut(first, last, group);
    if (cut.direction < 0) return;
    const auto [middle, separator] = split(first, last, group, cut);
    divide(first, middle);
    divide(middle, separator);
  }

  void fill_bins(int first, int last) {
    Coordinates low = coordinates(positions_[vertices_[first]]);
    Coordinates high = low;
    for (int i = first; i < last; ++i) {
      const Coordinates here = coordinates(positions_[vertices_[i]]);
      for (int d = 0; d < directions_; ++d) {
        low[d] = std::min(low[d], here[d]);
        high[d] = std::max(high[d], here[d]);
      }
    }
    Coordinates scale{};
    for (int d = 0; d < directions_; ++d)
      if (high[d] > low[d]) scale[d] = bins_ / (high[d] - low[d]);
    for (int i = first; i < last; ++i) {
      const Coordinates here = coordinates(positions_[vertices_[i]]);
      for (int d = 0; d < directions_; ++d)
        bin_[vertices_[i]][d] =
            static_cast<uint8_t>(std::min(bins_ - 1.0, (here[d] - low[d]) * scale[d]));
    }
  }

  Cut best_cut(int first, int last, int group) {
    for (int d = 0; d < directions_; ++d) {
      std::fill_n(weight_in_bin_[d].begin(), bins_, 0);
      std::fill_n(separator_change_[d].begin(), bins_, 0);
    }
    int total = 0;
    for (int i = first; i < last; ++i) {
      const int v = vertices_[i];
      total += weights_[v];
      const Bins reach = farthest_bins(v, group);
      for (int d = 0; d < directions_; ++d) {
        weight_in_bin_[d][bin_[v][d]] += weights_[v];
        separator_change_[d][bin_[v][d]] += weights_[v];
        separator_change_[d][reach[d]] -= weights_[v];
      }
    }
    Cut best;
    double least = std::numeric_limits<double>::infinity();
    for (int d = 0; d < directions_; ++d) try_direction(d, total, least, best);
    return best;
  }

  /// Returns the highest bins of the vertex and its neighbours in the group, by direction.
  Bins farthest_bins(int v, int group) const {
    Bins reach = bin_[v];
    for (int e = begin_[v]; e < begin_[v + 1]; ++e) {
      const int other = neighbour_[e];
      if (group_[other] != group) continue;
      for (int d = 0; d < most_directions; ++d) reach[d] = std::max(reach[d], bin_[other][d]);
    }
    return reach;
  }

  /// Replaces `best` and its cost `least` by a cheaper cut of this direction. `total`: weight of
  /// the group.
  void try_direction(int direction, int total, double& least, Cut& best) const {
    int before = 0;
    int separator = 0;
    for (int b = 0; b + 1 < bins_; ++b) {
      before += weight_in_bin_[direction][b];
      separator += separator_change_[direction][b];
      const int left = before - separator;
      const int right = total - before;
      if (left <= 0 || right <= 0 || separator >= least) continue;
      const double share = static_cast<double>(std::max(left, right)) / total;
      const double excess = std::max(0.0, share - 0.5);
      double cost = separator * (1 + imbalance_penalty * excess * excess);
      if (share > worst_balance) cost += total;
      if (cost >= least) continue;
      least = cost;
      best = {direction, b};
    }
  }

  /// Moves the separator to the end and the other vertices to their sides. Returns the beginnings
  /// of the second side and of the separator.
  std::array<int, 2> split(int first, int last, int group, const Cut& cut) {
    const auto behind = [&](int v) { return bin_[v][cut.direction] > cut.bin; };
    const auto touches = [&](int v) {
      for (int e = begin_[v]; e < begin_[v + 1]; ++e)
        if (group_[neighbour_[e]] == group && behind(neighbour_[e])) return true;
      return false;
    };
    int end = first;
    behind_.clear();
    separator_.clear();
    for (int i = first; i < last; ++i) {
      const int v = vertices_[i];
      if (behind(v))
        behind_.push_back(v);
      else if (touches(v))
        separator_.push_back(v);
      else
        vertices_[end++] = v;
    }
    const int middle = end;
    for (const int v : behind_) vertices_[end++] = v;
    const int separator = end;
    for (const int v : separator_) vertices_[end++] = v;
    return {middle, separator};
  }

  std::span<const Point2> positions_;
  std::span<const int> weights_;
  const RunContext& context_;
  std::vector<int> begin_;      ///< #V + 1, into neighbour_
  std::vector<int> neighbour_;  ///< of each vertex
  std::vector<int> vertices_;   ///< in the order so far
  std::vector<int> behind_;
  std::vector<int> separator_;
  std::vector<int> group_;  ///< #V
  int groups_ = 0;
  std::vector<Bins> bin_;  ///< #V, in the group
  int bins_ = 0;
  int directions_ = 0;
  std::array<BinSums, most_directions> weight_in_bin_{};
  /// Weight by which the separator behind a bin exceeds the one before it.
  std::array<BinSums, most_directions> separator_change_{};
};

}  // namespace

std::vector<int> dissection_order(const FlatMesh& mesh, std::span<const int> weights,
                                  const RunContext& context) {
  assert(weights.size() == mesh.positions.size());
  return Dissection(mesh, weights, context).run();
}

}  // namespace relievo
