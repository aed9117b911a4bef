#include "understanding/labels/choose_labels.h"

#include "kernel/graph/graph_cuts.h"
#include "understanding/areas/join_regions.h"

namespace relievo::understanding {
namespace {

/// Number of pixels of a soft stroke that weigh as much as a pixel of white border (LazyBrush).
constexpr int64_t soft_pixels_per_white = 20;

/// LazyBrush's energy over the basins in regions with strokes,
///   E(l) = sum over borders w_ab [l_a != l_b] + sum over basins D_a(l_a),
/// where D_a counts the soft votes for other labels, costs the pixels at the picture's edge,
/// outside which lies background, and is infinite against hard votes.
class LabelProblem {
 public:
  LabelProblem(const Basins& basins, const BasinVotes& votes, int part_count)
      : basins_(basins), votes_(votes), part_count_(part_count), allowed_(votes.labels_in_region) {
    if (!allowed_[0].empty()) allowed_[0].insert(0);
    problem_.label_count = part_count + 1;
    node_.assign(basins.basins.size(), -1);
    for (size_t b = 0; b < basins.basins.size(); ++b)
      if (!allowed_[basins.region[b]].empty()) add_node(static_cast<int>(b));
    for (const BasinVotes::HardPixel& pixel : votes.hard) bar_all_but(pixel.basin, pixel.label);
    for (const BasinBorder& border : basins.borders) add_border(border);
  }

  std::vector<int> solve() const {
    const std::vector<int> chosen =
        problem_.costs.empty() ? std::vector<int>() : minimize_potts(problem_);
    std::vector<int> labels(basins_.basins.size());
    for (size_t b = 0; b < labels.size(); ++b)
      labels[b] = node_[b] >= 0 ? chosen[node_[b]] : proposed_label(static_cast<int>(b));
    return labels;
  }

 private:
  int proposed_label(int basin) const {
    const int region = basins_.region[basin];
    return region == 0 ? 0 : part_count_ + region;
  }

  int64_t& cost(int basin, int label) {
    return problem_.costs[static_cast<size_t>(node_[basin]) * problem_.label_count + label];
  }

  void add_node(int basin) {
    node_[basin] = problem_.label_count > 0 ? problem_.node_count() : 0;
    const std::set<int>& allowed = allowed_[basins_.region[basin]];
    const int64_t vote =
        white_cost(basins_.index.width, basins_.index.height) / soft_pixels_per_white;
    for (int label = 0; label < problem_.label_count; ++label) {
      int64_t value = allowed.count(label) > 0 ? 0 : CutGraph::forbidden;
      for (const auto& [other, pixels] : votes_.soft[basin])
        if (other != label) value += vote * pixels;
      if (label != 0) value += cost_at_edge(basins_.basins[basin]);
      problem_.costs.push_back(value);
    }
  }

  int64_t cost_at_edge(const Basin& basin) const {
    int64_t pixels = 0;
    for (const int64_t count : basin.at_edge) pixels += count;
    return pixels * white_cost(basins_.index.width, basins_.index.height);
  }

  /// Forbids all other labels.
  void bar_all_but(int basin, int label) {
    for (int other = 0; other < problem_.label_count; ++other)
      if (other != label) cost(basin, other) = CutGraph::forbidden;
  }

  void add_border(const BasinBorder& border) {
    if (node_[border.a] >= 0 && node_[border.b] >= 0) {
      problem_.edges.push_back({node_[border.a], node_[border.b], border.weight});
      return;
    }
    // A basin beside background that is not free pays for this border unless it is background.
    const int free = node_[border.a] >= 0 ? border.a : border.b;
    const int fixed = free == border.a ? border.b : border.a;
    if (node_[free] < 0 || proposed_label(fixed) != 0) return;
    for (int label = 1; label < problem_.label_count; ++label) cost(free, label) += border.weight;
  }

  const Basins& basins_;
  const BasinVotes& votes_;
  int part_count_;
  std::vector<std::set<int>> allowed_;  ///< [#R + 1] empty where the region stays as proposed
  std::vector<int> node_;               ///< [#B] index in the problem, or -1
  PottsProblem problem_;
};

}  // namespace

std::vector<int> choose_labels(const Basins& basins, const BasinVotes& votes,
                               const Scribbles& scribbles) {
  const auto part_count = static_cast<int>(scribbles.parts.size());
  std::vector<int> labels = LabelProblem(basins, votes, part_count).solve();
  if (scribbles.complete) join_regions(basins, part_count, labels);
  return labels;
}

}  // namespace relievo::understanding
