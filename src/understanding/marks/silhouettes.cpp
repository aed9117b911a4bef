#include "understanding/marks/silhouettes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo::understanding {
namespace {

/// The use of a mark in a drawing.
enum class MarkRole {
  shape,       ///< a part, or paint on one
  ink,         ///< lines: an outline plate below or above the colours, strokes, hatching
  shade,       ///< a shade or highlight on what lies below it
  shadow,      ///< cast on the floor
  motion,      ///< lines that stand apart from everything
  background,  ///< behind all
  paint,       ///< changes the colours of what lies below, and is nothing by itself
};

/// Lengths are fractions of the diagonal of the drawing, shares fractions of the mark's area.
constexpr double rim_thickness = 0.012;  ///< of lines, and between twins
/// A stroke without a fill that is wider than this is a body of its own unless it is ink.
constexpr double wide_stroke = 0.02;
constexpr double pen_thickness = 0.045;  ///< of dark outlines
constexpr double pen_along = 0.6;        ///< share of dark ink that runs along or inside fills
constexpr double apart = 0.03;           ///< lines farther from fills than this are motion lines
constexpr double dark = 0.2;             ///< luminance
constexpr double dull = 0.4;             ///< the lightest of red, green and blue
constexpr double translucent = 0.95;     ///< alpha
constexpr double over_others = 0.8;      ///< share of a shade over earlier marks
constexpr double within_others = 0.95;   ///< likewise of an opaque shade
constexpr double same_hue = 0.985;       ///< cosine between colours, or between their complements

/// A tile: the least share of its convex hull and of its box, and the longest box / the narrowest.
constexpr double tile_convexity = 0.98;
constexpr double tile_share = 0.75;
constexpr double tile_stretch = 1.3;
/// The figure before a tile: its least share of the tile and of all that lies before it, and the
/// largest share of its own convex hull. A face before a round head is smaller or rounder.
constexpr double figure_share = 0.3;
constexpr double one_figure = 0.9;
constexpr double figure_convexity = 0.9;

constexpr double flat_shadow = 2.5;    ///< width over height of a cast shadow
constexpr double shadow_width = 0.35;  ///< of its width in that of the drawing, where it is opaque
constexpr double floor_height = 0.12;  ///< of the drawing, where shadows lie
constexpr double ellipse_share = 0.785;

bool is_dark(const Color& c) { return luminance(c) < dark && std::max({c.r, c.g, c.b}) < dull; }

double cosine(const Color& p, const Color& q) {
  const double norms =
      std::sqrt((p.r * p.r + p.g * p.g + p.b * p.b) * (q.r * q.r + q.g * q.g + q.b * q.b));
  return norms > 0 ? (p.r * q.r + p.g * q.g + p.b * q.b) / norms : 0;
}

/// Returns whether one colour is the other made darker or lighter.
bool is_tint(const Color& p, const Color& q) {
  const auto rest = [](const Color& c) { return Color{1 - c.r, 1 - c.g, 1 - c.b, 1}; };
  return cosine(p, q) > same_hue || cosine(rest(p), rest(q)) > same_hue;
}

bool thinner(const Region& region, double thickness) {
  return area(grow(region, -thickness / 2)) < 0.05 * area(region);
}

double height(const Box2& box) { return box.max.y - box.min.y; }
double width(const Box2& box) { return box.max.x - box.min.x; }

/// Returns the share of a region's convex hull that it fills.
double convexity(const Region& region) {
  std::vector<Point2> points;
  for (const Ring& ring : region) points.insert(points.end(), ring.begin(), ring.end());
  const double hull = signed_area(convex_hull(std::move(points)));
  return hull > 0 ? area(region) / hull : 0;
}

double common_area(const Box2& p, const Box2& q) {
  const double width = std::min(p.max.x, q.max.x) - std::max(p.min.x, q.min.x);
  const double height = std::min(p.max.y, q.max.y) - std::max(p.min.y, q.min.y);
  return std::max(0.0, width) * std::max(0.0, height);
}

/// Returns whether the two regions differ by no more than a thin rim, in a drawing of this
/// diagonal.
bool same_silhouette(const Region& p, const Region& q, double diagonal) {
  const double larger = std::max(area(p), area(q));
  if (common_area(bounding_box(p), bounding_box(q)) < 0.5 * larger) return false;
  if (std::min(area(p), area(q)) < 0.5 * larger) return false;
  if (area(intersect(p, q)) < 0.5 * larger) return false;
  const double rim = std::min(rim_thickness * diagonal, 0.18 * std::sqrt(larger));
  const double rest = area(grow(subtract(p, q), -rim / 2)) + area(grow(subtract(q, p), -rim / 2));
  return rest < 0.02 * larger;
}

/// Largest strand / area of the drawing. Neighbouring silhouettes of one group and colour that are
/// smaller, like strands of hair, become one.
constexpr double strand_area = 0.02;

/// Adds the mark to the topmost silhouette that it shares; returns false where there is none.
bool join_silhouette(std::vector<Silhouette>& silhouettes, const Mark& mark, bool line,
                     double diagonal) {
  const Region filled = line ? without_holes(mark.region) : mark.region;
  if (line && area(filled) < 1.5 * area(mark.region)) return false;
  for (size_t i = silhouettes.size(); i-- > 0;) {
    Silhouette& silhouette = silhouettes[i];
    if (!same_silhouette(filled, silhouette.region, diagonal)) continue;
    silhouette.outlined |=
        mark.outlined || color_distance(mark.color, silhouette.color) > color_contrast;
    silhouette.region = unite(silhouette.region, filled);
    if (!line) silhouette.color = mark.color;
    return true;
  }
  return false;
}

/// Returns whether both are strands of one tuft.
bool are_strands(const Silhouette& p, const Silhouette& q, double total) {
  return p.group == q.group && !p.outlined && !q.outlined &&
         color_distance(p.color, q.color) < color_contrast &&
         area(q.region) < strand_area * total && !intersect(p.region, q.region).empty();
}

void merge_strands(SilhouetteList& list) {
  const double total = area(list.covered);
  std::vector<Silhouette> merged;
  for (Silhouette& silhouette : list.silhouettes) {
    const auto siblings =
        std::count_if(list.silhouettes.begin(), list.silhouettes.end(),
                      [&](const Silhouette& other) { return other.group == silhouette.group; });
    const bool tuft = 2 * siblings < std::ssize(list.silhouettes) && silhouette.group >= 0;
    if (tuft && !merged.empty() && are_strands(merged.back(), silhouette, total)) {
      merged.back().region = unite(merged.back().region, silhouette.region);
    } else {
      merged.push_back(silhouette);
    }
  }
  list.silhouettes = std::move(merged);
}

bool is_left_out(MarkRole role) {
  return role == MarkRole::shadow || role == MarkRole::motion || role == MarkRole::background ||
         role == MarkRole::paint;
}

std::string note_on(const Mark& mark, MarkRole role) {
  const std::string taken_for = role == MarkRole::shadow       ? "a cast shadow"
                                : role == MarkRole::background ? "a background"
                                                               : "a motion line";
  return (mark.name.empty() ? "a shape" : mark.name) + " is taken for " + taken_for +
         " and left out of the model";
}

/// Finds the roles of marks in paint order, one after the other, each among marks that have none
/// yet. Only shapes can become parts. The other roles are:
///  - background: a rectangle, the first mark or on other backgrounds, that reaches at least three
///    sides of the canvas, or all four where nothing else is drawn; likewise a disc, square or
///    rounded tile, with one figure before it that stays inside;
///  - shadow: flat, at the lower end, on background alone, and translucent, blurred or a dark
///    ellipse;
///  - ink: a stroke or fill as thin as a line; or dark, visible no wider than a thick pen, along or
///    inside fills, and not the twin of a fill;
///  - shade: translucent and mostly over earlier marks; or a crescent or stripe of the same hue
///    within them;
///  - motion: ink that is nowhere near a fill;
///  - paint: what blends with what lies below it, but for ink.
class RoleFinder {
 public:
  RoleFinder(const std::vector<Mark>& marks, const Box2& canvas) : marks_(marks), canvas_(canvas) {
    for (const Mark& mark : marks) boxes_.push_back(bounding_box(mark.region));
    roles_.assign(marks.size(), MarkRole::shape);
  }

  std::vector<MarkRole> run() {
    find_background();
    for (size_t i = 0; i < marks_.size(); ++i)
      if (is_shape(i) && !marks_[i].blends) whole_.add(boxes_[i]);
    for (size_t i = 0; i < marks_.size(); ++i)
      if (is_shape(i) && is_shadow(i)) roles_[i] = MarkRole::shadow;
    find_ink();
    for (size_t i = 0; i < marks_.size(); ++i)
      if (is_shape(i) && marks_[i].blends) roles_[i] = MarkRole::paint;
    for (size_t i = 0; i < marks_.size(); ++i)
      if (is_shape(i) && is_shade(i)) roles_[i] = MarkRole::shade;
    find_motion();
    return std::move(roles_);
  }

 private:
  bool is_shape(size_t i) const { return roles_[i] == MarkRole::shape; }

  void find_background() {
    const double near_x = 0.01 * width(canvas_);
    const double near_y = 0.01 * height(canvas_);
    for (size_t i = 0; i < marks_.size(); ++i) {
      const Box2& box = boxes_[i];
      const int sides = (box.min.x < canvas_.min.x + near_x ? 1 : 0) +
                        (box.max.x > canvas_.max.x - near_x ? 1 : 0) +
                        (box.min.y < canvas_.min.y + near_y ? 1 : 0) +
                        (box.max.y > canvas_.max.y - near_y ? 1 : 0);
      const bool rectangle = area(marks_[i].region) > 0.9 * width(box) * height(box);
      const int least = i + 1 < marks_.size() ? 3 : 4;
      if (!marks_[i].filled || marks_[i].blends) return;
      if ((sides < least || !rectangle) && !is_tile(i)) return;
      roles_[i] = MarkRole::background;
    }
  }

  /// Returns whether mark i is a tile behind one figure that all later marks make.
  bool is_tile(size_t i) const {
    const Region& tile = marks_[i].region;
    const double short_side = std::min(width(boxes_[i]), height(boxes_[i]));
    const double long_side = std::max(width(boxes_[i]), height(boxes_[i]));
    if (long_side > tile_stretch * short_side) return false;
    if (area(tile) < tile_share * short_side * long_side) return false;
    if (convexity(tile) < tile_convexity) return false;
    std::vector<Region> later;
    for (size_t j = i + 1; j < marks_.size(); ++j) later.push_back(marks_[j].region);
    const Region before = unite(later);
    if (before.empty()) return false;
    const Region figure = pieces(before).front();
    if (area(figure) < std::max(figure_share * area(tile), one_figure * area(before))) return false;
    return convexity(without_holes(figure)) < figure_convexity &&
           subtract(figure, grow(tile, -rim_thickness * boxes_[i].diagonal())).empty();
  }

  /// Returns the area of all shapes of a range that are near.
  Region shapes(size_t from, size_t to, const Box2& near, size_t without) const {
    std::vector<Region> regions;
    for (size_t j = from; j < to; ++j)
      if (j != without && is_shape(j) && !marks_[j].blends && boxes_meet(boxes_[j], near))
        regions.push_back(marks_[j].region);
    return unite(regions);
  }

  bool is_shadow(size_t i) const {
    const Mark& mark = marks_[i];
    const Box2& box = boxes_[i];
    if (!mark.filled || mark.blends || width(box) < flat_shadow * height(box)) return false;
    Box2 others;
    for (size_t j = 0; j < marks_.size(); ++j)
      if (j != i && is_shape(j) && !marks_[j].blends) others.add(boxes_[j]);
    if (others.empty() || !boxes_meet(box, others)) return false;
    const double middle = (box.min.y + box.max.y) / 2;
    if (middle < others.max.y - floor_height * height(others)) return false;
    const double own = area(mark.region);
    const bool ellipse = std::abs(own / (width(box) * height(box)) - ellipse_share) < 0.04;
    const bool opaque_shadow = ellipse && is_dark(mark.color) &&
                               width(box) > shadow_width * width(others) && !mark.outlined;
    if (mark.color.a > translucent && !mark.blurred && !opaque_shadow) return false;
    return area(intersect(mark.region, shapes(0, i, box, i))) < 0.05 * own;
  }

  bool is_dark_pen(size_t i) const {
    return is_dark(marks_[i].color) && marks_[i].color.a >= 0.5 && !marks_[i].outlined;
  }

  /// Finds thin lines, then dark marks along or inside the remaining fills.
  void find_ink() {
    const double diagonal = whole_.diagonal();
    for (size_t i = 0; i < marks_.size(); ++i) {
      if (!is_shape(i)) continue;
      const Mark& mark = marks_[i];
      const bool line = mark.filled ? thinner(mark.region, rim_thickness * diagonal)
                                    : mark.pen_width < wide_stroke * diagonal;
      if (line) roles_[i] = MarkRole::ink;
    }
    std::vector<size_t> pens;
    for (size_t i = 0; i < marks_.size(); ++i)
      if (is_shape(i) && is_dark_pen(i) && is_narrow(i)) pens.push_back(i);
    std::vector<Region> fills;
    for (size_t i = 0; i < marks_.size(); ++i)
      if (is_shape(i) && marks_[i].filled && !marks_[i].blends &&
          std::find(pens.begin(), pens.end(), i) == pens.end())
        fills.push_back(marks_[i].region);
    if (pens.empty() || fills.empty()) return;
    const Region along = grow(unite(fills), pen_thickness * diagonal);
    for (const size_t i : pens) {
      const Region seen = seen_of(i);
      if (area(intersect(seen, along)) > pen_along * area(seen) && !has_twin(i))
        roles_[i] = MarkRole::ink;
    }
  }

  /// Returns whether the mark is the dark rim of one fill, with which it is one silhouette.
  bool has_twin(size_t i) const {
    for (size_t j = 0; j < marks_.size(); ++j)
      if (j != i && is_shape(j) && marks_[j].filled && !marks_[j].blends &&
          same_silhouette(marks_[i].region, marks_[j].region, whole_.diagonal()))
        return true;
    return false;
  }

  Region seen_of(size_t i) const {
    return subtract(marks_[i].region, shapes(i + 1, marks_.size(), boxes_[i], i));
  }

  bool is_narrow(size_t i) const {
    const double pen = pen_thickness * whole_.diagonal();
    const Region seen = marks_[i].filled ? seen_of(i) : marks_[i].region;
    return !seen.empty() && (marks_[i].filled ? thinner(seen, pen) : marks_[i].pen_width < pen);
  }

  bool is_shade(size_t i) const {
    const Mark& mark = marks_[i];
    if (!mark.filled || mark.outlined) return false;
    const bool clear = mark.color.a < translucent || mark.blurred;
    const double own = area(mark.region);
    if (!clear && area(grow(mark.region, -0.25 * std::sqrt(own))) > 0) return false;
    const double over = area(intersect(mark.region, shapes(0, i, boxes_[i], i))) / own;
    if (clear) return over > over_others;
    return over > within_others && is_tint(mark.color, color_below(i));
  }

  /// Returns the colour of the topmost mark under most of mark i.
  Color color_below(size_t i) const {
    Region left = marks_[i].region;
    double most = 0;
    Color color = marks_[i].color;
    for (size_t j = i; j-- > 0 && !left.empty();) {
      if (!is_shape(j) || !boxes_meet(boxes_[j], boxes_[i])) continue;
      const double seen = area(intersect(left, marks_[j].region));
      left = subtract(left, marks_[j].region);
      if (seen <= most) continue;
      most = seen;
      color = marks_[j].color;
    }
    return color;
  }

  /// Finds ink that is nowhere near a fill; connected lines count as one.
  void find_motion() {
    std::vector<Region> ink;
    std::vector<Region> fills;
    for (size_t i = 0; i < marks_.size(); ++i) {
      if (roles_[i] == MarkRole::ink) ink.push_back(marks_[i].region);
      if (is_shape(i)) fills.push_back(marks_[i].region);
    }
    if (ink.empty() || fills.empty()) return;
    const Region near = grow(unite(fills), apart * whole_.diagonal());
    std::vector<Region> away = pieces(unite(ink));
    away.erase(std::remove_if(away.begin(), away.end(),
                              [&](const Region& piece) { return !intersect(piece, near).empty(); }),
               away.end());
    const Region lines = unite(away);
    for (size_t i = 0; i < marks_.size() && !lines.empty(); ++i)
      if (roles_[i] == MarkRole::ink && subtract(marks_[i].region, lines).empty())
        roles_[i] = MarkRole::motion;
  }

  const std::vector<Mark>& marks_;
  Box2 canvas_;
  std::vector<Box2> boxes_;
  std::vector<MarkRole> roles_;
  Box2 whole_;  ///< around everything but background
};

}  // namespace

SilhouetteList group_silhouettes(std::vector<Mark> marks, const Box2& canvas) {
  const std::vector<MarkRole> roles = RoleFinder(marks, canvas).run();
  SilhouetteList list;
  std::vector<Region> all;
  std::vector<Region> ink;
  std::vector<Region> left_out;
  for (size_t i = 0; i < marks.size(); ++i) {
    if (is_left_out(roles[i])) {
      if (roles[i] == MarkRole::paint) continue;
      list.notes.push_back(note_on(marks[i], roles[i]));
      left_out.push_back(marks[i].region);
      continue;
    }
    all.push_back(marks[i].region);
    if (roles[i] != MarkRole::shape) ink.push_back(marks[i].region);
  }
  list.covered = unite(all);
  list.ink = unite(ink);
  list.left_out = unite(left_out);
  list.diagonal = bounding_box(list.covered).diagonal();
  for (size_t i = 0; i < marks.size(); ++i) {
    Mark& mark = marks[i];
    const bool line = roles[i] != MarkRole::shape;
    if (is_left_out(roles[i]) || join_silhouette(list.silhouettes, mark, line, list.diagonal) ||
        line)
      continue;
    list.silhouettes.push_back(
        {std::move(mark.name), mark.group, mark.color, std::move(mark.region), mark.outlined});
  }
  merge_strands(list);
  return list;
}

}  // namespace relievo::understanding
