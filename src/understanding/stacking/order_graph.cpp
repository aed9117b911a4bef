#include "understanding/stacking/order_graph.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace relievo::understanding {
namespace {

using Adjacency = std::vector<std::vector<int>>;

constexpr double least_gain = 1e-9;  ///< in log-odds, so that rounding moves nothing

Adjacency upward(int parts, const std::vector<OrderArrow>& arrows) {
  Adjacency above(parts);
  for (const OrderArrow& arrow : arrows)
    if (arrow.kept) above[arrow.lower].push_back(arrow.upper);
  return above;
}

/// The strongly connected component of every part (Tarjan's algorithm without recursion).
class Components {
 public:
  explicit Components(const Adjacency& next)
      : component(next.size(), -1), next_(next), index_(next.size(), -1), low_(next.size(), 0) {
    for (size_t part = 0; part < next.size(); ++part)
      if (index_[part] < 0) visit(static_cast<int>(part));
  }

  std::vector<int> component;

 private:
  struct Frame {
    int part;
    size_t child;
  };

  void open(int part) {
    index_[part] = low_[part] = counter_++;
    stack_.push_back(part);
    path_.push_back({part, 0});
  }

  void close(int part) {
    path_.pop_back();
    if (!path_.empty()) low_[path_.back().part] = std::min(low_[path_.back().part], low_[part]);
    if (low_[part] != index_[part]) return;
    int member = -1;
    do {
      member = stack_.back();
      stack_.pop_back();
      component[member] = part;
    } while (member != part);
  }

  void visit(int root) {
    open(root);
    while (!path_.empty()) {
      const int part = path_.back().part;
      if (path_.back().child == next_[part].size()) {
        close(part);
        continue;
      }
      const int child = next_[part][path_.back().child++];
      if (index_[child] < 0)
        open(child);
      else if (component[child] < 0)
        low_[part] = std::min(low_[part], index_[child]);
    }
  }

  const Adjacency& next_;
  std::vector<int> index_;
  std::vector<int> low_;
  std::vector<int> stack_;
  std::vector<Frame> path_;
  int counter_ = 0;
};

/// The place to which the part at `from` goes for the largest gain, and that gain.
std::pair<int, double> best_place(const std::vector<int>& order, int from,
                                  const std::vector<std::vector<double>>& log_odds) {
  const std::vector<double>& odds = log_odds[order[from]];
  std::pair<int, double> best{from, least_gain};
  const auto walk = [&](int step) {
    double gain = 0;
    for (int k = from + step; k >= 0 && k < static_cast<int>(order.size()); k += step) {
      gain += step * odds[order[k]];
      if (gain > best.second) best = {k, gain};
    }
  };
  walk(1);
  walk(-1);
  return best;
}

}  // namespace

Status break_cycles(int parts, std::vector<OrderArrow>& arrows) {
  for (;;) {
    const Components components(upward(parts, arrows));
    OrderArrow* weakest = nullptr;
    const OrderArrow* in_cycle = nullptr;
    for (OrderArrow& arrow : arrows) {
      const bool cyclic =
          arrow.kept && components.component[arrow.upper] == components.component[arrow.lower];
      if (!cyclic) continue;
      in_cycle = &arrow;
      if (arrow.source == OrderSource::user) continue;
      if (weakest == nullptr || arrow.confidence < weakest->confidence) weakest = &arrow;
    }
    if (weakest != nullptr)
      weakest->kept = false;
    else if (in_cycle != nullptr)
      return Error{ErrorCode::contradiction,
                   "the arrows of order form a circle; remove one of them",
                   std::to_string(in_cycle->upper) + " over " + std::to_string(in_cycle->lower)};
    else
      return Done{};
  }
}

std::vector<int> sort_back_to_front(const std::vector<double>& area,
                                    const std::vector<OrderArrow>& arrows) {
  const int parts = static_cast<int>(area.size());
  const Adjacency above = upward(parts, arrows);
  std::vector<int> waiting(parts, 0);
  for (const auto& list : above)
    for (const int upper : list) ++waiting[upper];
  std::vector<int> order;
  std::vector<uint8_t> done(parts, 0);
  for (int k = 0; k < parts; ++k) {
    int best = -1;
    for (int part = 0; part < parts; ++part)
      if (done[part] == 0 && waiting[part] == 0 && (best < 0 || area[part] > area[best]))
        best = part;
    done[best] = 1;
    order.push_back(best);
    for (const int upper : above[best]) --waiting[upper];
  }
  return order;
}

std::vector<int> likelier_order(std::vector<int> back_to_front,
                                const std::vector<std::vector<double>>& log_odds) {
  const std::vector<int> parts = back_to_front;
  for (bool moved = true; moved;) {
    moved = false;
    for (const int part : parts) {
      const auto at = std::find(back_to_front.begin(), back_to_front.end(), part);
      const auto from = static_cast<int>(at - back_to_front.begin());
      const int to = best_place(back_to_front, from, log_odds).first;
      if (to == from) continue;
      back_to_front.erase(at);
      back_to_front.insert(back_to_front.begin() + to, part);
      moved = true;
    }
  }
  return back_to_front;
}

}  // namespace relievo::understanding
