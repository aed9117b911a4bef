#include "kernel/operators/dissection.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <numeric>

namespace relievo {
namespace {

/// Groups of no more vertices are not parted.
constexpr int smallest_group = 8;
/// In smaller groups diagonal cuts and narrow bins gain little.
constexpr int large_group = 512;
/// Cuts are tried between bins of equal width in each direction: at most so many.
constexpr int most_bins = 128;
constexpr int most_directions = 4;
/// A cut that leaves more than this share on one side is taken where there is no other.
constexpr double worst_balance = 0.8;
/// Cost of a separator: its weight times 1 + premium (larger share - 1/2)^2.
constexpr double premium = 8;

using Coordinates = std::array<double, most_directions>;
using Bins = std::array<uint8_t, most_directions>;

Coordinates coordinates(Point2 p) { return {p.x, p.y, p.x + p.y, p.x - p.y}; }

/// Neighbours of each vertex, each once.
struct VertexGraph {
  std::vector<int> begin = {0};
  std::vector<int> neighbour;
};

VertexGraph vertex_graph(const FlatMesh& mesh) {
  const NodeCorners corners = corners_at_nodes(mesh.triangles, mesh.positions.size());
  VertexGraph graph;
  graph.begin.reserve(mesh.positions.size() + 1);
  graph.neighbour.reserve(4 * mesh.triangles.size());
  for (int v = 0; v < static_cast<int>(mesh.positions.size()); ++v) {
    const auto first = static_cast<std::ptrdiff_t>(graph.neighbour.size());
    for (const Corner corner : corners.at(v)) {
      const Triangle& triangle = mesh.triangles[triangle_of(corner)];
      graph.neighbour.push_back(triangle[next_place(place_of(corner))]);
      graph.neighbour.push_back(triangle[last_place(place_of(corner))]);
    }
    const auto begin = graph.neighbour.begin() + first;
    std::sort(begin, graph.neighbour.end());
    graph.neighbour.erase(std::unique(begin, graph.neighbour.end()), graph.neighbour.end());
    graph.begin.push_back(static_cast<int>(graph.neighbour.size()));
  }
  return graph;
}

/// `direction` < 0 where nothing can be parted.
struct Cut {
  int direction = -1;
  int bin = 0;  ///< the last one before the cut
};

/// The cuts that are tried on a group.
struct Trials {
  int bins;
  int directions;
};

Trials trials_of(int vertices) {
  return vertices < large_group ? Trials{24, 2} : Trials{most_bins, most_directions};
}

/// Weights by bin: of the vertices there, and the change of the separator of a cut behind it.
struct BinWeights {
  std::array<int, most_bins> here;
  std::array<int, most_bins> separator;
};

class Dissection {
 public:
  Dissection(const FlatMesh& mesh, std::span<const int> weights, const RunContext& context)
      : positions_(mesh.positions),
        weights_(weights),
        context_(context),
        graph_(vertex_graph(mesh)) {
    vertices_.resize(positions_.size());
    std::iota(vertices_.begin(), vertices_.end(), 0);
    group_.resize(vertices_.size(), 0);
    bin_.resize(vertices_.size());
  }

  std::vector<int> run() {
    part(0, static_cast<int>(vertices_.size()));
    return std::move(vertices_);
  }

 private:
  /// Puts the vertices [first, last) in order.
  void part(int first, int last) {
    if (last - first <= smallest_group || context_.cancelled()) return;
    const int group = ++groups_;
    for (int i = first; i < last; ++i) group_[vertices_[i]] = group;
    const Trials trials = trials_of(last - first);
    fill_bins(first, last, trials);
    const Cut cut = best_cut(first, last, group, trials);
    if (cut.direction < 0) return;
    const auto [middle, separator] = split(first, last, group, cut);
    part(first, middle);
    part(middle, separator);
  }

  void fill_bins(int first, int last, const Trials& trials) {
    Coordinates low = coordinates(positions_[vertices_[first]]);
    Coordinates high = low;
    for (int i = first; i < last; ++i) {
      const Coordinates here = coordinates(positions_[vertices_[i]]);
      for (int d = 0; d < trials.directions; ++d) {
        low[d] = std::min(low[d], here[d]);
        high[d] = std::max(high[d], here[d]);
      }
    }
    Coordinates scale{};
    for (int d = 0; d < trials.directions; ++d)
      if (high[d] > low[d]) scale[d] = trials.bins / (high[d] - low[d]);
    for (int i = first; i < last; ++i) {
      const Coordinates here = coordinates(positions_[vertices_[i]]);
      for (int d = 0; d < trials.directions; ++d)
        bin_[vertices_[i]][d] =
            static_cast<uint8_t>(std::min(trials.bins - 1.0, (here[d] - low[d]) * scale[d]));
    }
  }

  Cut best_cut(int first, int last, int group, const Trials& trials) {
    for (int d = 0; d < trials.directions; ++d) {
      std::fill_n(by_bin_[d].here.begin(), trials.bins, 0);
      std::fill_n(by_bin_[d].separator.begin(), trials.bins, 0);
    }
    int total = 0;
    for (int i = first; i < last; ++i) {
      const int v = vertices_[i];
      total += weights_[v];
      const Bins reach = farthest_bins(v, group);
      for (int d = 0; d < trials.directions; ++d) {
        by_bin_[d].here[bin_[v][d]] += weights_[v];
        by_bin_[d].separator[bin_[v][d]] += weights_[v];
        by_bin_[d].separator[reach[d]] -= weights_[v];
      }
    }
    Cut best;
    double least = std::numeric_limits<double>::infinity();
    for (int d = 0; d < trials.directions; ++d) try_direction(d, trials.bins, total, least, best);
    return best;
  }

  /// The highest bins of the vertex and its neighbours in the group.
  Bins farthest_bins(int v, int group) const {
    Bins reach = bin_[v];
    for (int e = graph_.begin[v]; e < graph_.begin[v + 1]; ++e) {
      const int other = graph_.neighbour[e];
      if (group_[other] != group) continue;
      for (int d = 0; d < most_directions; ++d) reach[d] = std::max(reach[d], bin_[other][d]);
    }
    return reach;
  }

  void try_direction(int direction, int bins, int total, double& least, Cut& best) const {
    const BinWeights& weights = by_bin_[direction];
    int before = 0;
    int separator = 0;
    for (int b = 0; b + 1 < bins; ++b) {
      before += weights.here[b];
      separator += weights.separator[b];
      const int left = before - separator;
      const int right = total - before;
      if (left <= 0 || right <= 0 || separator >= least) continue;
      const double share = static_cast<double>(std::max(left, right)) / total;
      const double excess = std::max(0.0, share - 0.5);
      double cost = separator * (1 + premium * excess * excess);
      if (share > worst_balance) cost += total;
      if (cost >= least) continue;
      least = cost;
      best = {direction, b};
    }
  }

  /// Moves the separator to the end and the others to their sides; where the second side and the
  /// separator begin.
  std::array<int, 2> split(int first, int last, int group, const Cut& cut) {
    const auto behind = [&](int v) { return bin_[v][cut.direction] > cut.bin; };
    const auto touches = [&](int v) {
      for (int e = graph_.begin[v]; e < graph_.begin[v + 1]; ++e)
        if (group_[graph_.neighbour[e]] == group && behind(graph_.neighbour[e])) return true;
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
  VertexGraph graph_;
  std::vector<int> vertices_;
  std::vector<int> behind_;
  std::vector<int> separator_;
  std::vector<int> group_;
  std::vector<Bins> bin_;
  std::array<BinWeights, most_directions> by_bin_{};
  int groups_ = 0;
};

}  // namespace

std::vector<int> dissection_order(const FlatMesh& mesh, std::span<const int> weights,
                                  const RunContext& context) {
  assert(weights.size() == mesh.positions.size());
  return Dissection(mesh, weights, context).run();
}

}  // namespace relievo
