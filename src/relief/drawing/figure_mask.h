#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relief/drawing/basins.h"
#include "relief/drawing/line_map.h"
#include "relief/drawing/mark_pixels.h"
#include "relief/drawing/region_merging.h"
#include "relievo/image.h"

namespace relievo {

/// The figure of a picture on a transparent ground whose opaque areas are it (lines on a
/// transparent ground say nothing), or of paint on paper: what is coloured or dark, the narrow gaps
/// in it but for slits before small holes, and what it surrounds; of line art its dark shapes
/// alone. `rgba` is the drawing, `rgb` the same on white. O(pixels).
FigureMask find_figure(const Image8& rgba, const Image8& rgb, const LineMap& map,
                       bool on_pure_white);

/// Marks the rim of a sharp mask as an edge where no line or edge runs along it. O(pixels).
void mark_rim(const FigureMask& figure, LineMap& map);

/// Whether a drawing (4 channels) lies on nothing or on white as no scanner and no camera gives it:
/// then whatever is not white is paint, unless it fills a box, as a photograph in a white frame
/// does. O(pixels).
bool is_on_pure_white(const Image8& rgba);

/// What fills so much of its box is a picture in a frame.
constexpr double framed_share = 0.9;

/// The share of the box around the ones of a mask that they fill; 0 of none. O(pixels).
double share_of_box(const Image8& mask);

/// A mask without the pieces of less than 3 % of the largest. O(pixels).
Image8 without_small_pieces(const Image8& mask);

/// What a mask and the quadrilateral between its corners have in common, of both together: about 1
/// of a page, however it is turned and seen aslant; 0 of nothing. O(pixels).
double page_overlap(const Image8& mask);

/// 1 where a picture on pure white, or on nothing, is not white. O(pixels).
Image8 tinted_pixels(const Image8& image);

/// An opaque drawing (4 channels) on pure white without a grey shadow on the ground below the
/// figure: a soft one, or one of one grey below a figure whose outlines are inked while nothing
/// bounds it. Nothing where there is none. O(pixels).
Image8 without_cast_shadow(const Image8& rgba);

/// A mask with all that it surrounds. O(pixels).
Image8 without_holes(const Image8& mask);

/// Whether an area runs along the edges of a picture as a table around a page does: along two of
/// them, or as a strip along one. `at_edge` are its pixels at the left, right, top and bottom.
bool is_surroundings(const std::array<int64_t, 4>& at_edge, int64_t area, int width, int height);

/// Lets nothing of the figure be lost: pixels of it that have no label take the nearest one, or
/// where there is none a new one after `last_label`. Areas that strokes made background stay it.
/// `labels` has those of all pixels, `of_basin` those of basins. O(pixels).
void keep_figure(const Basins& basins, const std::vector<int>& of_basin, int last_label,
                 Image<int32_t>& labels);

/// Unites all regions that are background and returns that region, or -1 where there is none: what
/// has the paper's colour and reaches the edge of the image, what lies around the page, and what is
/// quite open to these. A large region that reaches one edge only is taken for a figure that the
/// edge cuts, and so is a small one that lines bound all around but there. Where areas of the
/// drawing are opaque, all transparent ones are background. What lies in the figure's mask never
/// is.
int unite_background(RegionMerging& regions, Basins& basins);

/// Whether a region is as white as paper is, once its colour is divided out.
bool is_paper(const Basin& region);

/// Share of the lines, by area, on all sides of which lies the background.
double unbounded_line_share(const Basins& basins);

/// The drawing laid on white: composited over it (over black and inverted where everything opaque
/// is light lines), the paper's colour and a slow change of light divided out. 8-bit RGB, 3
/// channels. `rgba` has 4. The light is a quadratic fitted to the bright part of each channel. A
/// pale figure `on_pure_white` can be that part: where paint would become white, nothing is divided
/// out. O(pixels).
Image8 remove_paper(const Image8& rgba, bool on_pure_white = false);

/// A drawing (4 channels) without the lines of ruled or squared paper, or nothing where there are
/// none: five or more thin ones at equal distances across most of the picture, level or upright to
/// a tenth, and what crosses them likewise, as a margin. They are followed through what hides them,
/// and may be bent. Their pixels take the colour of their darker side, unless they are so dark that
/// ink lies there. O(pixels).
Image8 without_rulings(const Image8& drawing);

/// A drawing (4 channels) without the ground of one colour around it.
struct WithoutGround {
  Image8 rgba;          ///< empty where there is no such ground, or it is white
  bool is_cut = false;  ///< a figure, transparent where the ground is; else a page on a table
};

/// Cuts a painted figure out of an opaque drawing, with the blend at its rim gone, or continues a
/// page over the table that it lies on, in its own light. The ground may have grain and lie in
/// slowly changing light where a good part of the figure is lighter than it in some channel; then
/// small pieces are left out. O(pixels).
WithoutGround without_ground(const Image8& rgba);

/// What strokes say of ink: pixels and the label that each stroke stands for.
struct InkVotes {
  std::vector<MarkedPixel> marks;
  std::vector<int> label_of_stroke;  ///< [strokes] 0 for the background
};

/// Gives the ink that lies on the background to the figure, so that nothing drawn is lost: the
/// outer half of outlines to the part that they bound, and strokes that bound nothing, as those of
/// a stick figure, a tail or a twig, to new parts, at least `thinnest_tube` wide, unless a stroke
/// says what they are. Specks, outlines of areas that strokes made background, and lines from edge
/// to edge of the picture, as of ruled paper, stay background. `labels` has the labels of all
/// pixels and is changed; new labels begin after `last_label`. O(pixels).
void take_ink(const Basins& basins, const InkVotes& votes, int last_label, Image<int32_t>& labels);

}  // namespace relievo
