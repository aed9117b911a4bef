#include "solid/check_print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <utility>

#include "kernel/geometry/box3.h"
#include "kernel/geometry/clipper_paths.h"
#include "relievo/solid.h"
#include "solid/level_cuts.h"

namespace relievo {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

constexpr int most_cuts = 16;
/// Sizes that are tried for parts that are too thin, in sizes of the model.
constexpr std::array tried_times = {1.1, 1.25, 1.5, 2.0, 3.0, 5.0, 8.0};
// Lengths in nozzles below which findings do not count.
constexpr double least_wall = 5;   ///< length of thin walls
constexpr double least_limb = 8;   ///< length of slender limbs
constexpr double least_side = 10;  ///< side of a square as large as a piece beyond a neck, or an
                                   ///< overhang
constexpr double opening_slack = 0.1;  ///< share of an opening's radius within which corners remain

/// A measure of each part, mm or mm^2, by the part's index.
using ByPart = std::map<int, double>;

Paths grown(const Paths& paths, double mm) {
  return grow_paths(paths, mm * cut_steps, 0.01 * cut_steps);
}

/// Returns the area of a piece without its holes, mm^2.
double area_of(const Paths& piece) {
  double area = 0;
  for (const Path& ring : piece) area += ClipperLib::Area(ring);
  return area / (cut_steps * cut_steps);
}

/// Returns the width of a strip, mm: its area over half the length of its outline.
double width_of(const Paths& piece) {
  double length = 0;
  for (const Path& ring : piece)
    for (size_t i = 0; i < ring.size(); ++i) {
      const IntPoint a = ring[i];
      const IntPoint b = ring[(i + 1) % ring.size()];
      length += std::hypot(static_cast<double>(b.X - a.X), static_cast<double>(b.Y - a.Y));
    }
  return 2 * area_of(piece) * cut_steps / length;
}

bool touch(const Paths& piece, const std::vector<Paths>& others) {
  return std::any_of(others.begin(), others.end(), [&piece](const Paths& other) {
    return !pieces_of(ClipperLib::ctIntersection, piece, other).empty();
  });
}

/// Returns the pieces of a region that no disc of the given width reaches and that are at least
/// about `length` long; mm.
std::vector<Paths> slender(const Paths& region, double width, double length) {
  const Paths opened = grown(grown(region, -0.5 * width), 0.5 * (1 + opening_slack) * width);
  std::vector<Paths> strips;
  for (Paths& piece : pieces_of(ClipperLib::ctDifference, region, opened))
    if (area_of(piece) > 0.5 * width * length) strips.push_back(std::move(piece));
  return strips;
}

class PrintChecker {
 public:
  PrintChecker(const Model& model, double nozzle) : model_(model), nozzle_(nozzle), cutter_(model) {
    for (const std::array<int, 3>& t : model.triangles)
      for (const int v : t) depth_ = std::max(depth_, model.positions[v].z);
    const int count = std::clamp(static_cast<int>(depth_ / (2 * nozzle)), 2, most_cuts);
    for (int k = 0; k < count; ++k) {
      cuts_.push_back(cutter_.cut((k + 0.5) * depth_ / count));
      ClipperLib::CleanPolygons(cuts_.back().rings, 0.02 * nozzle * cut_steps);
    }
  }

  ByPart thin_walls() const {
    std::vector<std::vector<Paths>> strips;
    for (const LevelCut& cut : cuts_)
      strips.push_back(slender(cut.rings, nozzle_, least_wall * nozzle_));
    ByPart found;
    for (size_t k = 0; k < strips.size(); ++k)
      for (const Paths& strip : strips[k])
        if ((k > 0 && touch(strip, strips[k - 1])) ||
            (k + 1 < strips.size() && touch(strip, strips[k + 1])))
          note(corner_part(strip, cuts_[k]), width_of(strip), found);
    return found;
  }

  /// Returns parts beyond a neck, and slender parts.
  ByPart necks() const {
    Paths all;
    for (const LevelCut& cut : cuts_) all.insert(all.end(), cut.rings.begin(), cut.rings.end());
    ByPart found;
    for (const Paths& whole : pieces_of(ClipperLib::ctUnion, all, {})) {
      // If the widest neck does not separate any part, narrower ones do not either.
      for (const double width : {3 * nozzle_, 2 * nozzle_, nozzle_}) {
        const std::vector<int> apart = parted_by(whole, width);
        for (const int part : apart) found[part] = width;
        if (apart.empty()) break;
      }
      for (const Paths& limb : slender(whole, 3 * nozzle_, least_limb * nozzle_))
        note(covering_part(limb), width_of(limb), found);
    }
    return found;
  }

  ByPart overhangs() const {
    ByPart found;
    for (size_t p = 0; p < model_.parts.size(); ++p) {
      double area = 0;
      for (int i = 0; i < model_.parts[p].triangle_count; ++i)
        area += hanging_area(model_.triangles[model_.parts[p].first_triangle + i]);
      if (area > least_side * nozzle_ * least_side * nozzle_) found[static_cast<int>(p)] = area;
    }
    return found;
  }

 private:
  /// Returns the parts of all pieces but the largest into which a piece falls without its rim.
  std::vector<int> parted_by(const Paths& whole, double width) const {
    std::vector<Paths> apart = pieces_of(ClipperLib::ctUnion, grown(whole, -0.5 * width), {});
    std::sort(apart.begin(), apart.end(),
              [](const Paths& a, const Paths& b) { return area_of(a) > area_of(b); });
    std::vector<int> parts;
    for (size_t i = 1; i < apart.size(); ++i)
      if (area_of(apart[i]) > least_side * nozzle_ * least_side * nozzle_)
        parts.push_back(covering_part(apart[i]));
    return parts;
  }

  /// Notes a measure of a part; of several, the smallest is kept.
  static void note(int part, double mm, ByPart& found) {
    const auto [at, fresh] = found.try_emplace(part, mm);
    if (!fresh) at->second = std::min(at->second, mm);
  }

  static int most_frequent(const std::map<int, double>& votes) {
    if (votes.empty()) return 0;
    return std::max_element(votes.begin(), votes.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  /// Returns the part of most of the cut's corners that lie on the outline of a piece.
  static int corner_part(const Paths& piece, const LevelCut& cut) {
    std::map<int, double> votes;
    for (size_t i = 0; i < cut.corners.size(); ++i)
      for (const Path& ring : piece)
        if (ClipperLib::PointInPolygon(cut.corners[i], ring) == -1) ++votes[cut.corner_parts[i]];
    return most_frequent(votes);
  }

  /// Returns the part that covers most of a piece of the plane in the front view.
  int covering_part(const Paths& piece) const {
    std::map<int, double> votes;
    const ClipperLib::IntRect box = bounds(piece.front());
    for (size_t p = 0; p < model_.parts.size(); ++p)
      for (int i = 0; i < model_.parts[p].triangle_count; ++i) {
        const auto& [a, b, c] = model_.triangles[model_.parts[p].first_triangle + i];
        const Point3 at = model_.positions[a];
        const Point3 up = cross(model_.positions[b] - at, model_.positions[c] - at);
        if (!(up.z > 0)) continue;
        const Point3 middle = (1.0 / 3) * (at + model_.positions[b] + model_.positions[c]);
        const IntPoint place(std::llround(cut_steps * middle.x),
                             std::llround(cut_steps * middle.y));
        if (place.X < box.left || place.X > box.right || place.Y < box.top || place.Y > box.bottom)
          continue;
        if (ClipperLib::PointInPolygon(place, piece.front()) != 0)
          votes[static_cast<int>(p)] += up.z;
      }
    return most_frequent(votes);
  }

  static ClipperLib::IntRect bounds(const Path& ring) {
    ClipperLib::IntRect box{ring[0].X, ring[0].Y, ring[0].X, ring[0].Y};
    for (const IntPoint p : ring) {
      box.left = std::min(box.left, p.X);
      box.right = std::max(box.right, p.X);
      box.top = std::min(box.top, p.Y);
      box.bottom = std::max(box.bottom, p.Y);
    }
    return box;
  }

  double hanging_area(const std::array<int, 3>& triangle) const {
    const Point3 a = model_.positions[triangle[0]];
    const Point3 b = model_.positions[triangle[1]];
    const Point3 c = model_.positions[triangle[2]];
    const Point3 twice = cross(b - a, c - a);
    const bool level = twice.z < -norm(twice) / std::numbers::sqrt2;
    return level && std::max({a.z, b.z, c.z}) > nozzle_ ? 0.5 * norm(twice) : 0;
  }

  const Model& model_;
  double nozzle_;
  LevelCutter cutter_;
  double depth_ = 0;
  std::vector<LevelCut> cuts_;
};

std::string rounded(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// The parts that are too thin somewhere, with the width there, mm.
struct SlenderParts {
  ByPart thin;
  ByPart necks;  ///< of other parts
};

SlenderParts slender_parts(const PrintChecker& checker) {
  SlenderParts found{checker.thin_walls(), checker.necks()};
  for (const auto& [part, width] : found.thin) found.necks.erase(part);
  return found;
}

/// Finds the longest side, mm, with which each of the slender parts is none; parts that are slender
/// at all sizes that are tried are missing. A part tapers, so its width does not tell.
std::map<int, double> enough_sizes(const Model& model, const SlenderParts& slender, double nozzle) {
  std::map<int, double> enough;
  std::vector<int> open;
  for (const ByPart* parts : {&slender.thin, &slender.necks})
    for (const auto& [part, width] : *parts) open.push_back(part);
  Box3 box;
  for (const Point3 p : model.positions) box.add(p);
  const Point3 sides = box.sides();
  for (const double times : tried_times) {
    if (open.empty()) break;
    // A model that grows is one whose nozzle shrinks.
    const SlenderParts left = slender_parts(PrintChecker(model, nozzle / times));
    std::erase_if(open, [&](int part) {
      if (left.thin.count(part) + left.necks.count(part) > 0) return false;
      enough[part] = std::ceil(times * std::max({sides.x, sides.y, sides.z}));
      return true;
    });
  }
  return enough;
}

Model upright(Model model) {
  for (Point3& p : model.positions) p = stood_up(p);
  return model;
}

}  // namespace

std::vector<PrintFinding> check_print(const Model& model, const std::vector<std::string>& loose,
                                      double nozzle, bool standing) {
  if (standing) return check_print(upright(model), loose, nozzle);
  std::vector<PrintFinding> findings;
  for (const std::string& part : loose) findings.push_back({PrintTrouble::loose, part});
  const PrintChecker checker(model, nozzle);
  const SlenderParts slender = slender_parts(checker);
  std::map<int, double> enough = enough_sizes(model, slender, nozzle);
  const auto add = [&](PrintTrouble trouble, const ByPart& parts) {
    for (const auto& [part, measure] : parts)
      findings.push_back({trouble, model.parts[part].id, measure,
                          trouble == PrintTrouble::overhang ? 0 : enough[part]});
  };
  add(PrintTrouble::thin, slender.thin);
  add(PrintTrouble::neck, slender.necks);
  add(PrintTrouble::overhang, checker.overhangs());
  return findings;
}

const char* name(PrintTrouble trouble) {
  constexpr std::array<const char*, 4> names = {"loose", "thin", "neck", "overhang"};
  return names[static_cast<size_t>(trouble)];
}

std::string describe(const PrintFinding& finding) {
  const std::string larger = finding.enough > 0 ? "--size " + rounded(finding.enough, "%.0f")
                                                : "no size helps: draw it thicker";
  switch (finding.trouble) {
    case PrintTrouble::loose:
      return finding.part + " is loose; --profile solid with --base plate or round connects it";
    case PrintTrouble::thin:
      return finding.part + " is " + rounded(finding.measure, "%.2f") +
             " mm thin, less than the nozzle; " + larger + ", or use a finer --nozzle";
    case PrintTrouble::neck:
      return finding.part + " hangs by " + rounded(finding.measure, "%.2g") +
             " mm and may break off; " + larger + ", or --profile solid with a --base";
    case PrintTrouble::overhang:
      break;
  }
  return rounded(finding.measure, "%.0f") + " mm^2 of " + finding.part +
         " hang over; print with supports, or --profile solid";
}

}  // namespace relievo
