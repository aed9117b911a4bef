#include "relief/finish/draw_in.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/geometry/polygon.h"

namespace relievo::relief {
namespace {

constexpr double widths_of_reach = 4;  ///< of ink over which surfaces move

/// Returns a smooth weight, 1 at the outline and 0 at the end of the reach.
double share_at(double distance, double reach) {
  const double t = std::min(1.0, distance / reach);
  return (1 - t * t) * (1 - t * t);
}

}  // namespace

DrawIn::DrawIn(const ContourInk& ink) {
  double usual = 0;
  for (const InkLine& line : ink.lines)
    for (const OutlinePoint& p : line.points) {
      if (p.inside <= 0) continue;
      const double reach = std::min(widths_of_reach * p.inside, std::max(p.room, 2 * p.inside));
      sources_.push_back({p.place, -p.inside * p.out, reach});
      reach_ = std::max(reach_, reach);
      usual = std::max(usual, reach);
    }
  if (sources_.empty()) return;
  for (const OutlinePoint& p : ink.plain) sources_.push_back({p.place, {}, usual});
  grid_.emplace(sources_.size(),
                [this](size_t i) { return std::pair(sources_[i].place, sources_[i].place); });
}

Point2 DrawIn::moved(Point2 place) const {
  if (!grid_) return place;
  const auto for_each_within = [&](double radius, auto visit) {
    grid_->for_each_near(place, place, radius, [&](int i) {
      const double d = distance(sources_[i].place, place);
      if (d < radius) visit(sources_[i], d);
    });
  };
  double nearest = reach_;
  for (double radius = reach_ / 16; radius <= reach_ && nearest == reach_; radius *= 2)
    for_each_within(radius, [&](const Source&, double d) { nearest = std::min(nearest, d); });
  if (nearest >= reach_) return place;
  const double radius = 1.5 * nearest + 1;
  double sum = 0;
  Point2 move;
  double reach = 0;
  for_each_within(radius, [&](const Source& source, double d) {
    const double inside = 1 - d / radius;
    const double weight = inside * inside / ((d * d + 0.01) * (d * d + 0.01));
    sum += weight;
    move = move + weight * source.move;
    reach += weight * source.reach;
  });
  if (reach <= 0) return place;
  return place + (share_at(nearest, reach / sum) / sum) * move;
}

void draw_in(const DrawIn& map, Model& model) {
  if (map.empty()) return;
  for (size_t v = 0; v < model.positions.size(); ++v) {
    Point3& p = model.positions[v];
    const Point2 to = map.moved({p.x, p.y});
    model.uvs[v] = model.uvs[v] + Point2{(to.x - p.x) / model.width, (p.y - to.y) / model.height};
    p = {to.x, to.y, p.z};
  }
}

}  // namespace relievo::relief
