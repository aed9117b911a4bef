#include "understanding/marks/propose_parts.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/region.h"

namespace relievo::understanding {
namespace {

constexpr double touching = 1;  ///< px
constexpr int ink_rounds = 4;   ///< of sharing out ink

double gap(const Box2& p, const Box2& q) {
  const double dx = std::max({0.0, p.min.x - q.max.x, q.min.x - p.max.x});
  const double dy = std::max({0.0, p.min.y - q.max.y, q.min.y - p.max.y});
  return std::hypot(dx, dy);
}

/// Returns the part with the largest common area with the piece's surroundings, or -1.
int touched_part(const std::vector<Part>& parts, const Region& surroundings) {
  int best = -1;
  double most = 0;
  for (size_t k = 0; k < parts.size(); ++k) {
    if (gap(bounding_box(parts[k].outline), bounding_box(surroundings)) > 0) continue;
    const double common = area(intersect(parts[k].outline, surroundings));
    if (common == 0 || common < most) continue;
    most = common;
    best = static_cast<int>(k);
  }
  return best;
}

int nearest_part(const std::vector<Part>& parts, const Region& piece) {
  const Box2 box = bounding_box(piece);
  int best = -1;
  for (size_t k = 0; k < parts.size(); ++k) {
    const double distance = gap(bounding_box(parts[k].outline), box);
    if (best < 0 || distance <= gap(bounding_box(parts[best].outline), box)) {
      best = static_cast<int>(k);
    }
  }
  return best;
}

/// Shares out the ink that no part covers and that is within `reach` of a part: each point goes to
/// the nearest part, the frontmost of equals.
void cover_ink(std::vector<Part>& parts, const Region& ink, double reach) {
  std::vector<Region> outlines;
  for (const Part& part : parts) outlines.push_back(part.outline);
  Region left = subtract(ink, unite(outlines));
  for (int round = 0; round < ink_rounds && !left.empty(); ++round)
    for (size_t k = parts.size(); k-- > 0 && !left.empty();) {
      Outline& outline = parts[k].outline;
      if (gap(bounding_box(outline), bounding_box(left)) > reach) continue;
      const Region won = intersect(grow(outline, reach / ink_rounds), left);
      if (won.empty()) continue;
      outline = unite(outline, won);
      left = subtract(left, won);
    }
}

/// Extends the parts so that together they cover `covered`. A remaining piece goes to the part that
/// it touches most, the frontmost of equals. A piece that touches no part becomes a part of its own
/// if it is larger than 1/500 of the whole, else another ring of the nearest part.
void cover_rest(std::vector<Part>& parts, const Region& covered) {
  std::vector<Region> outlines;
  for (const Part& part : parts) outlines.push_back(part.outline);
  const double total = area(covered);
  for (const Region& piece : pieces(subtract(covered, unite(outlines)))) {
    const Region near = intersect(grow(piece, touching), covered);
    if (near.empty()) continue;
    int host = touched_part(parts, near);
    if (host < 0 && (parts.empty() || area(piece) > 0.002 * total)) {
      parts.push_back({"", piece});
      continue;
    }
    if (host < 0) host = nearest_part(parts, piece);
    parts[host].outline = unite(parts[host].outline, near);
  }
}

/// Fractions of the area of the whole drawing.
constexpr double least_visible = 0.001;  ///< of a part beside others
constexpr double least_crossing = 0.004;
constexpr double least_contained = 0.008;
constexpr double least_ball = 0.02;
constexpr double speck_area = 1e-4;  ///< of the smallest ring or hole
/// Largest distance of ink from the part that it goes with / diagonal of the drawing.
constexpr double pen_reach = 0.045;

/// Fractions of the area of the silhouette itself.
constexpr double most_hidden = 0.9;
constexpr double least_protrusion = 0.02;
constexpr double mostly_inside = 0.75;

/// A frame has at least so many holes; its area / that of its silhouette; the silhouette / the area
/// of each silhouette in its holes; the filled share of the holes.
constexpr size_t least_holes = 2;
constexpr double least_frame = 0.25;
constexpr double least_framed = 0.5;
constexpr double mostly_filled = 0.9;

/// Evidence for or against a silhouette as a part of its own. Fractions are of its area unless
/// stated otherwise.
struct Evidence {
  double size = 0;          ///< area / area of the drawing
  double visible = 0;       ///< area not covered by later silhouettes / area of the drawing
  double hidden = 0;        ///< fraction covered by later silhouettes
  double inside = 0;        ///< fraction over earlier parts
  double protrusion = 0;    ///< fraction beside earlier parts, slivers left out
  bool crossing = false;    ///< lies over two parts, or over the edge of a patch
  bool compact = false;     ///< blob rather than stripe or crescent
  bool at_edge = false;     ///< its outline follows that of the part below
  bool pale_patch = false;  ///< large, lighter than the part below, and nothing on it
  bool ball = false;        ///< stands out by its colour and is small against the part below
};

double fraction_of(const Region& region, const Region& other) {
  return area(intersect(region, other)) / area(region);
}

size_t hole_count(const Region& region) {
  return static_cast<size_t>(std::count_if(region.begin(), region.end(),
                                           [](const Ring& ring) { return signed_area(ring) < 0; }));
}

/// Returns whether the silhouette is a frame: silhouettes behind fill its holes, like the plates
/// between the ribs of a shell, or the panes of a window.
bool is_frame(const std::vector<Silhouette>& silhouettes, size_t i) {
  const Region& region = silhouettes[i].region;
  if (hole_count(region) < least_holes) return false;
  const Region whole = without_holes(region);
  if (area(region) < least_frame * area(whole)) return false;
  std::vector<Region> behind;
  for (size_t k = 0; k < i; ++k)
    if (area(silhouettes[k].region) * least_framed < area(whole))
      behind.push_back(silhouettes[k].region);
  return fraction_of(subtract(whole, region), unite(behind)) > mostly_filled;
}

/// Fills the holes of frames: the silhouettes that show through them are paint on the frame's
/// surface.
std::vector<Silhouette> without_frames(std::vector<Silhouette> silhouettes) {
  for (size_t i = 0; i < silhouettes.size(); ++i)
    if (is_frame(silhouettes, i)) silhouettes[i].region = without_holes(silhouettes[i].region);
  return silhouettes;
}

/// Decides silhouette by silhouette, back to front, whether it is a part.
class Proposer {
 public:
  explicit Proposer(const SilhouetteList& list) : list_(list), total_(area(list.covered)) {
    for (const Silhouette& silhouette : list.silhouettes)
      boxes_.push_back(bounding_box(silhouette.region));
  }

  std::vector<Part> run(std::vector<Palette>& colors) {
    for (size_t i = 0; i < list_.silhouettes.size(); ++i) {
      const Silhouette& silhouette = list_.silhouettes[i];
      const bool speck = area(silhouette.region) < least_visible * total_;
      if (!speck && is_part(silhouette, weigh(i))) {
        parts_.push_back({silhouette.name, silhouette.region});
        colors_.push_back(silhouette.color);
      } else {
        patches_.push_back(silhouette.region);
      }
    }
    if (parts_.empty() && !list_.covered.empty()) {
      parts_.push_back({"", list_.covered});
      colors_.push_back(list_.silhouettes.empty() ? Color() : list_.silhouettes.front().color);
    }
    for (const Color& c : colors_) colors.push_back({{c.r, c.g, c.b}});
    return std::move(parts_);
  }

 private:
  /// A silhouette that is hardly visible is no part. One that protrudes beyond the parts below is a
  /// part, unless it is a patch without an outline that mostly follows them. One inside them is a
  /// part if it crosses something, has an outline of its own, or is a ball of another colour.
  static bool is_part(const Silhouette& silhouette, const Evidence& e) {
    if (e.hidden > most_hidden || e.visible < least_visible) return false;
    const bool contained = e.protrusion < least_protrusion;
    if (!contained) return silhouette.outlined || e.inside < mostly_inside || e.compact;
    if (e.crossing && e.visible >= least_crossing) return true;
    if (silhouette.outlined) return e.visible >= least_contained && !e.pale_patch;
    return e.ball && e.compact && !e.at_edge;
  }

  Evidence weigh(size_t i) const {
    const Silhouette& silhouette = list_.silhouettes[i];
    const double own = area(silhouette.region);
    Evidence e;
    e.size = own / total_;
    e.hidden = fraction_of(silhouette.region, above(i));
    e.visible = (1 - e.hidden) * e.size;
    const Region beside = subtract(silhouette.region, below(boxes_[i]));
    e.inside = 1 - area(beside) / own;
    e.protrusion = area(grow(beside, -0.0015 * list_.diagonal)) / own;
    e.compact = area(grow(silhouette.region, -0.25 * std::sqrt(own))) > 0;
    weigh_against_host(silhouette, i, e);
    return e;
  }

  /// Returns the area of the parts so far that are near.
  Region below(const Box2& box) const {
    std::vector<Region> near;
    for (const Part& part : parts_) {
      if (boxes_meet(box, bounding_box(part.outline))) near.push_back(part.outline);
    }
    return unite(near);
  }

  /// Returns the area of the silhouettes in front of silhouette i that are near.
  Region above(size_t i) const {
    std::vector<Region> near;
    for (size_t j = i + 1; j < boxes_.size(); ++j) {
      if (boxes_meet(boxes_[i], boxes_[j])) near.push_back(list_.silhouettes[j].region);
    }
    return unite(near);
  }

  void weigh_against_host(const Silhouette& silhouette, size_t i, Evidence& e) const {
    int seen = 0;
    int host = -1;
    double most = 0;
    Region front;
    for (size_t k = parts_.size(); k-- > 0;) {
      if (!boxes_meet(bounding_box(silhouette.region), bounding_box(parts_[k].outline))) continue;
      const double over = fraction_of(silhouette.region, subtract(parts_[k].outline, front));
      front = unite(front, parts_[k].outline);
      if (over > 0.15) ++seen;
      if (over <= most) continue;
      most = over;
      host = static_cast<int>(k);
    }
    if (host < 0) return;
    const double own = area(silhouette.region);
    const double host_area = area(parts_[host].outline);
    const Color& host_color = colors_[host];
    e.crossing = seen > 1 || crosses_patch(silhouette);
    const Region core = grow(parts_[host].outline, -0.006 * list_.diagonal);
    e.at_edge = fraction_of(silhouette.region, core) < 0.98;
    e.ball = e.size >= least_ball && own < 0.15 * host_area &&
             color_distance(silhouette.color, host_color) > 0.3;
    e.pale_patch = own > 0.1 * host_area &&
                   luminance(silhouette.color) > luminance(host_color) + 0.2 &&
                   !carries_something(i);
  }

  /// Returns whether the silhouette, in one piece, lies over the edge of a patch at least as large.
  bool crosses_patch(const Silhouette& silhouette) const {
    const double own = area(silhouette.region);
    const Box2 box = bounding_box(silhouette.region);
    const bool over_edge = std::any_of(patches_.begin(), patches_.end(), [&](const Region& patch) {
      if (area(patch) < own || !boxes_meet(box, bounding_box(patch))) return false;
      const double over = fraction_of(silhouette.region, patch);
      return over > 0.1 && over < 0.9;
    });
    return over_edge && pieces(silhouette.region).size() == 1;
  }

  /// Returns whether a later silhouette lies inside silhouette i.
  bool carries_something(size_t i) const {
    for (size_t j = i + 1; j < list_.silhouettes.size(); ++j) {
      const Region& other = list_.silhouettes[j].region;
      if (!boxes_meet(boxes_[i], boxes_[j])) continue;
      if (area(other) < 0.5 * area(list_.silhouettes[i].region) &&
          fraction_of(other, list_.silhouettes[i].region) > 0.9) {
        return true;
      }
    }
    return false;
  }

  const SilhouetteList& list_;
  double total_ = 0;
  std::vector<Box2> boxes_;  ///< of the silhouettes
  std::vector<Part> parts_;
  std::vector<Color> colors_;    ///< colour of each part
  std::vector<Region> patches_;  ///< silhouettes that are no parts
};

}  // namespace

std::vector<Part> propose_parts(const SilhouetteList& drawn, std::vector<Palette>& colors) {
  SilhouetteList list = drawn;
  list.silhouettes = without_frames(std::move(list.silhouettes));
  std::vector<Palette> found;
  std::vector<Part> parts = Proposer(list).run(found);
  cover_ink(parts, list.ink, pen_reach * list.diagonal);
  cover_rest(parts, list.covered);
  found.resize(parts.size());
  const double speck = std::max(4.0, speck_area * area(list.covered));
  std::vector<Part> proposed;
  colors.clear();
  for (size_t k = 0; k < parts.size(); ++k) {
    parts[k].outline = tidied(parts[k].outline, 0.1, speck);
    if (parts[k].outline.empty()) continue;
    proposed.push_back(std::move(parts[k]));
    colors.push_back(std::move(found[k]));
  }
  return proposed;
}

}  // namespace relievo::understanding
