#pragma once

#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/model/visible_sheet.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/solid.h"
#include "solid/height_field.h"

namespace relievo {

/// Where a sheet lies on the grid: grid = scale * (position - origin) / unit, rounded.
struct GridPlacement {
  double scale = 1;         ///< mm per px along the plate
  double height_scale = 1;  ///< mm per px upwards
  Point3 origin;            ///< px; comes to (0, 0, 0)
  double unit = 1;          ///< mm per step of the grid
  bool backed = false;      ///< whether the floor is the sheet's back, else the plate
};

/// The sheet as a height field, all heights counted from the plate. Where it changes its depth both
/// sides get the same points, those where the two profiles cross among them. Triangles that vanish
/// on the grid are left out; others may turn over there. Near-linear.
HeightField snap_sheet(const VisibleSheet& sheet, const GridPlacement& placement);

/// Turns the triangles of a field counter-clockwise that rounding to the grid turned over or made
/// flat: drops them between their neighbours, or moves one of their points to the next. Where the
/// field touches itself in a point, moves the sides apart by up to `gap` grid steps. Fails with
/// internal where triangles remain that cannot be repaired. O(F) for every repair, of which there
/// are a few in 100,000 triangles.
Status repair_plane(double gap, HeightField& field);

/// Raises heights, where that is needed, so that the surface of the solid below the field is a
/// manifold: along no edge do the two sides change places, and around every point heights rise to
/// one highest side and fall again, so that two walls meet along every upright line. What lies
/// outside of the field counts as 0. Near-linear; a few points change in practice.
void settle_heights(const FieldEdges& edges, HeightField& field);

/// Brings the depth of a sheet down to `share` of what it is, less where it must be: small forms
/// keep their slopes, large ones and steps give way [after Weyrich et al. 2007]. What lies behind
/// comes nearer by the same share. Heights and normals change, the plane does not. Fails with
/// internal where the heights cannot be computed. A few factorisations of the sheet.
/// Precondition: 0 < share < 1.
Status compress_heights(double share, VisibleSheet& sheet);

/// The outline of the plate around a silhouette, in its units; `mm` is a millimetre in them.
/// Everything that the silhouette's rings surround lies inside by the margin, and the rings of
/// holes to hang it by lie outside of the silhouette. Fails with usage where a hole has no room.
/// Precondition: the base is not `none`.
Result<Outline> plate_outline(const Outline& silhouette, const SolidOptions& options, double mm);

/// The rim of a field as rings, counter-clockwise around what it covers. O(F).
std::vector<std::vector<int>> rim_rings(const HeightField& field, const FieldEdges& edges);

/// Triangles of points of the rim alone that cover what the field covers, counter-clockwise.
/// O(n log n) for n points of the rim.
Result<std::vector<std::array<int, 3>>> triangulate_inside(const HeightField& field,
                                                           const FieldEdges& edges);

/// A flat plate around a field.
struct Plate {
  Outline outline;     ///< grid steps; its rings stay clear of each other and of the field's rim
  int64_t height = 0;  ///< of its top, grid steps
  int part = 0;        ///< of its triangles
  Point2 uv;           ///< of its vertices
};

/// Adds triangles where the plate's outline covers the plane and the field does not.
Status surround(const Plate& plate, const FieldEdges& edges, HeightField& field);

/// The corners around points, as 3 * triangle + k, counter-clockwise. A point has several fans
/// where the field touches itself there.
struct CornerFans {
  std::vector<int> begin;    ///< #fans + 1
  std::vector<int> corners;  ///< those of fan i are [begin[i], begin[i + 1])
  std::vector<char> closed;  ///< #fans; others begin and end at the field's rim

  size_t size() const { return closed.size(); }
};

inline int corner_vertex(const HeightField& field, int corner) {
  return field.triangles[corner / 3][corner % 3];
}

/// Open fans first, then closed ones, both by their first corner. Linear.
CornerFans collect_fans(const HeightField& field, const FieldEdges& edges);

/// What a floor may be, in grid steps.
struct FloorLimits {
  int64_t least = 1;  ///< below the field
  int64_t soft = 0;   ///< width of steps in it, about
};

/// Counts the heights of a field from its floor. Steps in the floor become ramps, but at the rim,
/// and where the field comes too near it is lowered, and around there so that no spikes stand out.
/// Fails with internal where that cannot be computed. Near-linear.
Status lay_floor(const FloorLimits& limits, const FieldEdges& edges, HeightField& field);

/// Where backs lie on the drawing.
struct BackPaint {
  Point2 plate;  ///< a flat one
  std::vector<Point2>
      parts;  ///< a floor's, by part and of a base; empty: as what is in front of it
};

/// A drawing with plain colours below it.
struct PaintedDrawing {
  Drawing drawing;
  double shrink = 1;  ///< of v, so that a model's coordinates go on meaning what they did
  BackPaint paint;
};

/// Adds what a back needs to a drawing, which may be empty. `model` lies on it; the colour of a
/// part is the mean over its triangles. Linear.
PaintedDrawing paint_back(const Drawing& drawing, const Model& model, BackSide side);

/// The solid between a field and its floor: its triangles, upright walls where it has steps and
/// along its rim, and its back. In mm: X right, Y up, Z to the viewer, its box's corner in the
/// origin. `parts`: names and values for `triangle_part`; walls belong to the higher side's part,
/// a flat back to the last part. Precondition: the field's triangles face the viewer, heights above
/// a floor are positive, and settle_heights has run. Every edge of the result has exactly two
/// triangles after vertices at one place are merged. O(F log F).
Result<Model> raise_walls(const HeightField& field, const FieldEdges& edges,
                          const std::vector<ModelPart>& parts, const BackPaint& paint);

/// A plate that a figure stands on, all lengths in grid steps.
struct Stand {
  bool round = false;             ///< a disc, not a rectangle
  int64_t thickness = 1;          ///< of the plate, whose upper half the feet are sunk into
  int64_t margin = 1;             ///< from the feet to its edge
  int64_t widest = 1;             ///< its sides at most
  int part = 0;                   ///< of its triangles
  Point2 uv;                      ///< of its vertices
  std::vector<GridPoint> others;  ///< x and z of what else stands on it
};

/// Where the triangles of a field reach down to.
int64_t lowest(const HeightField& field);

/// Cuts the field off, level and about `sunk` grid steps above its lowest point. Fails with
/// internal where no clean cut is found. O(F log F).
Status cut_feet(int64_t sunk, HeightField& field);

/// Adds a level plate below the lowest points of a field with a floor, which cut_feet has made,
/// wide enough for all of them and for the centre of mass. Fails with internal where they do not
/// lie on one level. O(F).
Status add_stand(const Stand& stand, HeightField& field);

/// A limb as a solid where the figure has it, which has the same parts.
struct SolidLimb {
  std::string id;
  double twice_middle = 0;  ///< mm; mirrored, z becomes so much less z
  Model model;
};

/// Unites a figure with its limbs mirrored to the far side, on a grid of `unit` mm; not its volume.
/// `colours`: by part, in place of the limbs' own, or empty. A limb is moved by 0.01 to 0.04 mm, as
/// it has the figure's outline. Fails with usage, naming the limb, where they do not become one.
/// Near-linear for each limb.
Status unite_with_limbs(const std::vector<SolidLimb>& limbs, double unit,
                        const std::vector<Point2>& colours, Solid& solid);

}  // namespace relievo
