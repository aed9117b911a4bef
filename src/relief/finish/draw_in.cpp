#include "relief/finish/draw_in.h"

#include <algorithm>
#include <utility>

namespace relievo::relief {
namespace {

constexpr double widths_of_reach = 4;  ///< of ink over which surfaces move

}  // namespace

DrawIn::DrawIn(const ContourInk& ink) {
  std::vector<Point2> places;
  double longest = 0;
  for (const InkLine& line : ink.lines)
    for (const OutlinePoint& p : line.points) {
      if (p.inside <= 0) continue;
      const double reach = std::min(widths_of_reach * p.inside, std::max(p.room, 2 * p.inside));
      places.push_back(p.place);
      moves_.push_back({-p.inside * p.out, reach});
      longest = std::max(longest, reach);
    }
  if (places.empty()) return;
  for (const OutlinePoint& p : ink.plain) {
    places.push_back(p.place);
    moves_.push_back({{}, longest});
  }
  outlines_.emplace(std::move(places), longest);
}

Point2 DrawIn::moved(Point2 place) const {
  if (!outlines_) return place;
  const double nearest = outlines_->distance_to(place);
  if (nearest >= outlines_->reach()) return place;
  Move mean;
  outlines_->for_each(place, nearest, [&](size_t i, double weight) {
    mean.by = mean.by + weight * moves_[i].by;
    mean.reach += weight * moves_[i].reach;
  });
  return place + BesideRim::share_within(nearest, mean.reach) * mean.by;
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
