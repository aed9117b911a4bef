#include "io/parts/figures.h"

#include <algorithm>
#include <utility>

#include "io/parts/mark_roles.h"

namespace relievo {
namespace {

/// Alike figures of one group that are smaller than this fraction of the drawing belong together,
/// as strands of hair do.
constexpr double strand_area = 0.02;

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

bool is_left_out(MarkRole role) {
  return role == MarkRole::shadow || role == MarkRole::motion || role == MarkRole::background;
}

std::string note_on(const Mark& mark, MarkRole role) {
  const std::string what = role == MarkRole::shadow       ? "a cast shadow"
                           : role == MarkRole::background ? "a background"
                                                          : "a motion line";
  return (mark.name.empty() ? "a shape" : mark.name) + " is taken for " + what +
         " and left out of the model";
}

}  // namespace

FigureList group_figures(std::vector<Mark> marks, const Box2& canvas) {
  const std::vector<MarkRole> roles = find_roles(marks, canvas);
  FigureList list;
  std::vector<Region> all;
  std::vector<Region> ink;
  for (size_t i = 0; i < marks.size(); ++i) {
    if (is_left_out(roles[i])) {
      list.notes.push_back(note_on(marks[i], roles[i]));
      continue;
    }
    all.push_back(marks[i].region);
    if (roles[i] != MarkRole::shape) ink.push_back(marks[i].region);
  }
  list.covered = unite(all);
  list.ink = unite(ink);
  list.diagonal = bounding_box(list.covered).diagonal();
  for (size_t i = 0; i < marks.size(); ++i) {
    Mark& mark = marks[i];
    const bool line = roles[i] != MarkRole::shape;
    if (is_left_out(roles[i]) || join_figure(list.figures, mark, line, list.diagonal) || line)
      continue;
    list.figures.push_back(
        {std::move(mark.name), mark.group, mark.color, std::move(mark.region), mark.outlined});
  }
  merge_strands(list);
  return list;
}

}  // namespace relievo
