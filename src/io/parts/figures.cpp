#include "io/parts/figures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {
namespace {

/// What is thinner than this times the diagonal of the drawing is a line.
constexpr double line_thickness = 0.012;
/// A stroke without a fill that is wider than this times the diagonal is a body of its own.
constexpr double wide_stroke = 0.02;
/// Alike figures of one group that are smaller than this fraction of the drawing belong together,
/// as strands of hair do.
constexpr double strand_area = 0.02;

bool is_line(const Mark& mark, double diagonal) {
  if (!mark.filled) return mark.pen_width < wide_stroke * diagonal;
  const Region core = grow(mark.region, -line_thickness * diagonal / 2);
  return area(core) < 0.05 * area(mark.region);
}

double common_area(const Box2& p, const Box2& q) {
  const double width = std::min(p.max.x, q.max.x) - std::max(p.min.x, q.min.x);
  const double height = std::min(p.max.y, q.max.y) - std::max(p.min.y, q.min.y);
  return std::max(0.0, width) * std::max(0.0, height);
}

/// Whether the two differ by no more than a rim that is thin against both.
bool same_silhouette(const Region& p, const Region& q, double diagonal) {
  const double larger = std::max(area(p), area(q));
  if (common_area(bounding_box(p), bounding_box(q)) < 0.5 * larger) return false;
  if (std::min(area(p), area(q)) < 0.5 * larger) return false;
  if (area(intersect(p, q)) < 0.5 * larger) return false;
  const double rim = std::min(line_thickness * diagonal, 0.18 * std::sqrt(larger));
  const double rest = area(grow(subtract(p, q), -rim / 2)) + area(grow(subtract(q, p), -rim / 2));
  return rest < 0.02 * larger;
}

/// Adds the mark to the topmost figure of the same silhouette; false where there is none.
bool join_figure(std::vector<Figure>& figures, const Mark& mark, bool line, double diagonal) {
  const Region silhouette = line ? without_holes(mark.region) : mark.region;
  if (line && area(silhouette) < 1.5 * area(mark.region)) return false;
  for (size_t i = figures.size(); i-- > 0;) {
    Figure& figure = figures[i];
    if (!same_silhouette(silhouette, figure.region, diagonal)) continue;
    figure.outlined |= mark.outlined || color_distance(mark.color, figure.color) > color_contrast;
    figure.region = unite(figure.region, silhouette);
    if (!line) figure.color = mark.color;
    return true;
  }
  return false;
}

/// Whether both are strands of one tuft.
bool are_strands(const Figure& p, const Figure& q, double total) {
  return p.group == q.group && !p.outlined && !q.outlined &&
         color_distance(p.color, q.color) < color_contrast &&
         area(q.region) < strand_area * total && !intersect(p.region, q.region).empty();
}

void merge_strands(FigureList& list) {
  const double total = area(list.covered);
  std::vector<Figure> merged;
  for (Figure& figure : list.figures) {
    const auto siblings =
        std::count_if(list.figures.begin(), list.figures.end(),
                      [&](const Figure& other) { return other.group == figure.group; });
    const bool tuft = 2 * siblings < std::ssize(list.figures) && figure.group >= 0;
    if (tuft && !merged.empty() && are_strands(merged.back(), figure, total)) {
      merged.back().region = unite(merged.back().region, figure.region);
    } else {
      merged.push_back(figure);
    }
  }
  list.figures = std::move(merged);
}

}  // namespace

FigureList group_figures(std::vector<Mark> marks) {
  FigureList list;
  std::vector<Region> all;
  for (const Mark& mark : marks) all.push_back(mark.region);
  list.covered = unite(all);
  list.diagonal = bounding_box(list.covered).diagonal();
  for (Mark& mark : marks) {
    const bool line = is_line(mark, list.diagonal);
    if (join_figure(list.figures, mark, line, list.diagonal) || line) continue;
    list.figures.push_back(
        {std::move(mark.name), mark.group, mark.color, std::move(mark.region), mark.outlined});
  }
  merge_strands(list);
  return list;
}

}  // namespace relievo
