#pragma once

#include <utility>
#include <vector>

#include "relief/drawing/basins.h"
#include "relievo/image.h"

namespace relievo {

/// Fills region, region_count and unbounded_ink: unites basins that are open to each other, finds
/// the background at the edges of the image, and gives slivers and small enclosed details to what
/// lies around them. `rgb` is the drawing on white. O(pixels + borders log borders).
void propose_regions(const Image8& rgb, Basins& basins);

/// Changes the proposed regions until there are `count`, or as near to it as can be: those that are
/// likeliest one are united, or the least likely unions of basins undone. What was proposed as
/// background stays. Precondition: count > 0. O(borders log borders), and O(basins) for each
/// region that is divided.
void count_regions(int count, Basins& basins);

/// Gives proposed regions to the scribbled parts that they touch, the surest first: where the
/// border is long and open, and the colour alike. `labels` has those of basins: 1 ... `part_count`
/// are scribbled parts, more are proposed regions; what touches neither a scribbled part nor what
/// joined one stays. O(regions * borders between regions).
void join_regions(const Basins& basins, int part_count, std::vector<int>& labels);

/// Divides proposed regions at their necks, where head, limbs, tail and ears of a figure grow out
/// of it without a line. A neck is a chord inside a region, from a concave place of the region's
/// own contour to the nearest other one. What it parts off is longer than the neck, or rounder than
/// the neck is wide, and borders on the background for the most part; the rest is wider beside the
/// neck. Returns whether there are any; then the basins have to be measured again. O(pixels), and
/// the square of contours at a fixed size.
bool cut_necks(Basins& basins);

/// An area that two parts share, since the outline of either is drawn through the other.
struct Overlap {
  uint16_t shared = 0;  ///< labels
  uint16_t a = 0;
  uint16_t b = 0;
};

/// Areas between two others whose outlines cross there, twice: at both ends of what the area has in
/// common with either, their outlines go straight on through each other, as at an X. `labels` are
/// those of areas, 0 is background; they meet in the middle of lines `line_width` px wide.
/// O(pixels).
std::vector<Overlap> find_overlaps(const Image16& labels, double line_width);

/// Pairs of areas that are likelier pieces of one part than two parts, the likeliest first: where a
/// third one hides both, as junctions tell, and the contour of one goes on in that of the other
/// behind it, by how it bends, how far that is, their sizes and whether they stand side by side.
/// `labels` are those of areas, 0 is background. O(pixels + contour ends at an area, squared).
std::vector<std::pair<uint16_t, uint16_t>> find_pieces(const Image16& labels);

/// A contour of an area that goes on, beyond what parts them, in one of the background.
struct HoleCue {
  uint16_t area = 0;    ///< labels, not 0
  uint16_t before = 0;  ///< what has that contour, to one side of what parts them
  uint16_t after = 0;   ///< and to the other
};

/// What tells by contours alone that the background shows in an area, as between the legs of an
/// animal: it hardly touches the background and not the picture's edge, and a contour goes on
/// nearly straight from one into the other. `labels` are those of areas, 0 is background.
/// Precondition: none is 65535. O(pixels + contour ends at an area, squared).
std::vector<HoleCue> find_holes(const Image16& labels);

}  // namespace relievo
