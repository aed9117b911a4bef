#include "understanding/stacking/order_graph.h"

#include <algorithm>
#include <string>

namespace relievo::understanding {
namespace {

using Adjacency = std::vector<std::vector<int>>;

/// The least gain in log-odds for which a part moves, above rounding errors.
constexpr double least_gain = 1e-9;

int index_of(const std::vector<PartLabel>& parts, PartLabel label) {
  return static_cast<int>(std::lower_bound(parts.begin(), parts.end(), label) - parts.begin());
}

/// Per part, the parts in front of it along the kept arrows.
Adjacency parts_above(const std::vector<PartLabel>& parts, const std::vector<OrderArrow>& arrows) {
  Adjacency above(parts.size());
  for (const OrderArrow& arrow : arrows)
    if (arrow.kept) above[index_of(parts, arrow.lower)].push_back(index_of(parts, arrow.upper));
  return above;
}

/// The strongly connected component of every part (Tarjan's algorithm).
class Components {
 public:
  explicit Components(const Adjacency& next)
      : component(next.size(), -1), next_(next), low_(next.size(), -1) {
    for (size_t part = 0; part < next.size(); ++part)
      if (low_[part] < 0) visit(static_cast<int>(part));
  }

  std::vector<int> component;

 private:
  void visit(int part) {
    const int index = low_[part] = counter_++;
    stack_.push_back(part);
    for (const int next : next_[part]) {
      if (low_[next] < 0) visit(next);
      if (component[next] < 0) low_[part] = std::min(low_[part], low_[next]);
    }
    if (low_[part] != index) return;
    while (component[part] < 0) {
      component[stack_.back()] = part;
      stack_.pop_back();
    }
  }

  const Adjacency& next_;
  std::vector<int> low_;  ///< the least index, in the order of visits, that a part leads back to
  std::vector<int> stack_;
  int counter_ = 0;
};

/// The position in the order at which the part at `from` gains most.
int best_position(const std::vector<int>& order, int from,
                  const std::vector<std::vector<double>>& log_odds) {
  const std::vector<double>& odds = log_odds[order[from]];
  int best = from;
  double most = least_gain;
  const auto walk = [&](int step) {
    double gain = 0;
    for (int k = from + step; k >= 0 && k < static_cast<int>(order.size()); k += step) {
      gain += step * odds[order[k]];
      if (gain <= most) continue;
      most = gain;
      best = k;
    }
  };
  walk(1);
  walk(-1);
  return best;
}

}  // namespace

Status break_cycles(const std::vector<PartLabel>& parts, std::vector<OrderArrow>& arrows) {
  for (;;) {
    const Components components(parts_above(parts, arrows));
    const auto component = [&](PartLabel label) {
      return components.component[index_of(parts, label)];
    };
    OrderArrow* weakest = nullptr;
    const OrderArrow* in_cycle = nullptr;
    for (OrderArrow& arrow : arrows) {
      if (!arrow.kept || component(arrow.upper) != component(arrow.lower)) continue;
      in_cycle = &arrow;
      if (arrow.user) continue;
      if (weakest == nullptr || arrow.confidence < weakest->confidence) weakest = &arrow;
    }
    if (weakest != nullptr)
      weakest->kept = false;
    else if (in_cycle != nullptr)
      return Error{ErrorCode::contradiction,
                   "the arrows of order form a circle; remove one of them",
                   "label " + std::to_string(in_cycle->upper) + " over label " +
                       std::to_string(in_cycle->lower)};
    else
      return Done{};
  }
}

std::vector<int> sort_back_to_front(const std::vector<PartLabel>& labels,
                                    const std::vector<double>& area,
                                    const std::vector<OrderArrow>& arrows) {
  const int parts = static_cast<int>(area.size());
  const Adjacency above = parts_above(labels, arrows);
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
      const int to = best_position(back_to_front, from, log_odds);
      if (to == from) continue;
      back_to_front.erase(at);
      back_to_front.insert(back_to_front.begin() + to, part);
      moved = true;
    }
  }
  return back_to_front;
}

}  // namespace relievo::understanding
