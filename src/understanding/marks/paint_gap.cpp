#include "understanding/marks/paint_gap.h"

#include <algorithm>
#include <cstdint>

#include "kernel/geometry/polyline.h"

namespace relievo::understanding {
namespace {

/// Least area / area of the canvas of a mark that has to show paint.
constexpr double least_mark = 0.001;
/// Largest share of a mark where nothing is painted. Drawings that are read well stay below a
/// tenth.
constexpr double most_bare = 0.03;
/// Opacities up to this one of 255 are no paint, and those from the second one on are opaque.
constexpr uint8_t unpainted = 8;
constexpr uint8_t opaque = 128;

/// A painting with the pixels that are in some mark.
struct Comparison {
  const Image8& painting;
  CellGrid grid;
  Image8 covered;
};

/// Marks the pixels of a region as covered. Returns the share of them that is not painted, 0 where
/// the region has less than `least_pixels`.
double cover(const Region& region, double least_pixels, Comparison& comparison) {
  int64_t all = 0;
  int64_t bare = 0;
  for (const CellRun& run : cells_inside(region, comparison.grid)) {
    for (int x = run.begin; x < run.end; ++x) {
      comparison.covered.at(x, run.row) = 1;
      bare += comparison.painting.at(x, run.row, 3) <= unpainted ? 1 : 0;
    }
    all += run.end - run.begin;
  }
  const double count = static_cast<double>(all);
  return count > 0 && count >= least_pixels ? static_cast<double>(bare) / count : 0;
}

/// Returns whether some pixel at most one away is covered: outlines may fall between pixels.
bool is_near_covered(const Image8& covered, int x, int y) {
  for (int v = std::max(0, y - 1); v <= std::min(covered.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(covered.width - 1, x + 1); ++u)
      if (covered.at(u, v) != 0) return true;
  return false;
}

double loose_share(const Comparison& comparison) {
  int64_t all = 0;
  int64_t loose = 0;
  for (int y = 0; y < comparison.painting.height; ++y) {
    for (int x = 0; x < comparison.painting.width; ++x) {
      const bool painted = comparison.painting.at(x, y, 3) >= opaque;
      all += painted || comparison.covered.at(x, y) != 0 ? 1 : 0;
      if (painted) loose += is_near_covered(comparison.covered, x, y) ? 0 : 1;
    }
  }
  return all > 0 ? static_cast<double>(loose) / static_cast<double>(all) : 0;
}

}  // namespace

PaintGap find_paint_gap(const LayeredDrawing& drawing, const Image8& painting) {
  const double cell = drawing.scene.width / painting.width;
  Comparison comparison{painting,
                        {{0, 0}, cell, painting.width, painting.height},
                        Image8(painting.width, painting.height, 1)};
  const double least = least_mark * painting.width * painting.height;
  PaintGap gap;
  for (const Mark& mark : drawing.marks) {
    const double bare = cover(mark.region, least, comparison);
    if (!mark.blends && !mark.blurred) gap.bare = std::max(gap.bare, bare);
  }
  for (const Part& part : drawing.scene.parts)
    gap.bare = std::max(gap.bare, cover(part.outline, least, comparison));
  cover(drawing.left_out, least, comparison);
  gap.loose = loose_share(comparison);
  return gap;
}

bool departs_from_paint(const LayeredDrawing& drawing, const Image8& painting) {
  const PaintGap gap = find_paint_gap(drawing, painting);
  return gap.bare > most_bare || gap.loose > most_loose;
}

}  // namespace relievo::understanding
