#include "solid/make_solid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "kernel/base/disjoint_sets.h"
#include "kernel/geometry/box3.h"
#include "relief/finish/finish_sheet.h"
#include "relief/finish/ink_mesh.h"
#include "solid/back_paint.h"
#include "solid/compress_heights.h"
#include "solid/field_rim.h"
#include "solid/lay_floor.h"
#include "solid/mirror_limbs.h"
#include "solid/place_on_grid.h"
#include "solid/plate_outline.h"
#include "solid/raise_walls.h"
#include "solid/repair_plane.h"
#include "solid/settle_heights.h"
#include "solid/snap_sheet.h"
#include "solid/stand.h"

namespace relievo {
namespace {

constexpr double least_gap = 0.05;    ///< mm between sides that would touch in a point
constexpr double least_depth = 0.4;   ///< mm of a figure; its back is lowered for that
constexpr double soft_share = 0.015;  ///< width of ramps on a figure's back, of its size
constexpr double size_slack = 0.001;  ///< by which a figure on a base may miss its size
constexpr int most_fits = 4;          ///< times that a figure is made to get its size

/// Counts the connected pieces of a field and lists the parts of all but the largest.
SolidFacts find_pieces(const HeightField& field, const std::vector<ModelPart>& parts) {
  DisjointSets sets(static_cast<int>(field.points.size()));
  for (const std::array<int, 3>& t : field.triangles)
    for (const int k : {1, 2}) sets.unite(field.vertex_point[t[0]], field.vertex_point[t[k]]);
  std::map<int, int64_t> areas;
  std::map<int, std::set<int>> owners;
  for (size_t t = 0; t < field.triangles.size(); ++t) {
    const auto& [a, b, c] = field.triangles[t];
    const int piece = sets.find(field.vertex_point[a]);
    areas[piece] += turn(field.place(a), field.place(b), field.place(c));
    owners[piece].insert(field.triangle_part[t]);
  }
  SolidFacts facts;
  facts.pieces = static_cast<int>(areas.size());
  const auto largest = std::max_element(
      areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  for (const auto& [piece, of_piece] : owners)
    for (const int part : of_piece)
      if (piece != largest->first) facts.loose.push_back(parts[part].id);
  return facts;
}

double volume_of(const Model& model) {
  double six = 0;
  for (const std::array<int, 3>& t : model.triangles)
    six += dot(model.positions[t[0]], cross(model.positions[t[1]], model.positions[t[2]]));
  return six / 6;
}

/// Returns the model's parts and, last, the base, under a name that no part has.
std::vector<ModelPart> parts_with_base(const Model& model) {
  std::vector<ModelPart> parts = model.parts;
  std::string id = "base";
  const auto taken = [&id](const ModelPart& part) { return part.id == id; };
  while (std::any_of(parts.begin(), parts.end(), taken)) id += "-";
  ModelPart base;
  base.id = id;
  parts.push_back(base);
  return parts;
}

/// Puts a plate `top` mm high around the field.
Status add_around(const SolidOptions& options, double top, int part, Point2 uv,
                  HeightField& field) {
  const FieldEdges edges = connect_field(field);
  Outline silhouette;
  for (const std::vector<int>& points : rim_rings(field, edges)) {
    Ring& ring = silhouette.emplace_back();
    for (const int p : points) ring.push_back(as_point(field.points[p]));
  }
  auto outline = plate_outline(silhouette, options, 1 / field.unit);
  if (!outline) return outline.error();
  const int64_t height = std::llround(top / field.unit);
  return surround(*outline, height, part, uv, edges, field);
}

/// Puts the plate around the field, and the cutter's wall around the plate.
Status add_plate(const SolidOptions& options, int part, Point2 uv, HeightField& field) {
  if (options.base == BaseShape::none) return Done{};
  const Status plate = add_around(options, options.thickness, part, uv, field);
  if (!plate || options.cutter == 0) return plate;
  SolidOptions wall = options;
  wall.margin = cutter_wall;
  return add_around(wall, options.thickness + options.cutter, part, uv, field);
}

Status check_lengths(const SolidOptions& options) {
  for (const auto& [name, length, least, most, text] : solid_lengths) {
    const double value = options.*length;
    const bool none = SolidOptions().*length == 0;
    if ((none && value == 0) || (value >= least && value <= most)) continue;
    char range[64];
    std::snprintf(range, sizeof range, "must be from %g to %g mm%s", least, most,
                  none ? ", or 0 for none" : "");
    return Error{ErrorCode::usage, range, name};
  }
  return Done{};
}

Status check_options(const SolidOptions& options) {
  if (Status status = check_lengths(options); !status) return status;
  if (options.base == BaseShape::none && options.hole + options.ring > 0)
    return Error{ErrorCode::usage, "a hole or a ring needs a base", "--base"};
  if (options.cutter > 0 && (options.base != BaseShape::outline || options.hole + options.ring > 0))
    return Error{ErrorCode::usage, "a cutter needs --base outline, without a hole or a ring",
                 "--cutter"};
  const bool figure = options.back != BackSide::flat;
  if (figure && (options.base == BaseShape::outline || options.hole + options.ring > 0))
    return Error{ErrorCode::usage,
                 "a figure stands on --base plate or round, without a hole or a ring", "--base"};
  if (!options.mirror.empty() && (!figure || options.detail))
    return Error{ErrorCode::usage, "needs a figure without --height-mode detail", "--mirror"};
  return Done{};
}

/// Makes the fields of the solid and of its limbs alike.
struct FieldMaker {
  const SolidOptions& options;
  const GridPlacement& placement;
  const BackPaint& paint;

  int64_t steps(double mm) const { return std::llround(mm / placement.unit); }
  /// Returns the grid steps by which feet are sunk into a plate.
  int64_t sunk() const { return steps(sunk_depth(options)); }

  HeightField field_of(const relief::VisibleSheet& sheet) const {
    HeightField field = snap_sheet(sheet, placement);
    for (Point2& uv : field.uvs) uv.y *= paint.shrink;
    return field;
  }

  Status repair(HeightField& field) const {
    return repair_plane(least_gap / placement.unit, field);
  }

  Status add_back(const FieldEdges& edges, HeightField& field) const {
    return lay_floor(steps(least_depth), steps(soft_share * options.size), edges, field);
  }

  Status stand(int part, std::vector<GridPoint> others, HeightField& field) const {
    return add_stand({options.base == BaseShape::round, 2 * sunk(), steps(options.margin),
                      steps(options.size), part, paint.plate, std::move(others)},
                     field);
  }
};

GridPoint low_corner(const HeightField& field) {
  GridPoint low{std::numeric_limits<int64_t>::max(), std::numeric_limits<int64_t>::max()};
  for (const GridPoint p : field.points) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  return low;
}

/// Makes the solid of a limb, on the grid's origin. Appends x and the mirrored z of its
/// points up to a level to `feet`.
Result<SolidLimb> make_limb(const FieldMaker& maker, const relief::LimbSheet& limb,
                            const std::vector<ModelPart>& parts, int64_t level,
                            std::vector<GridPoint>& feet) {
  HeightField field = maker.field_of(limb.sheet);
  if (Status status = maker.repair(field); !status) return status.error();
  const FieldEdges edges = connect_field(field);
  if (Status status = maker.add_back(edges, field); !status) return status.error();
  settle_heights(edges, field);
  // Both sides of a mirrored limb show the limb's own paint.
  const BackPaint paint{{}, maker.paint.shrink, 0, 1, maker.paint.plate, maker.paint.parts};
  auto model = raise_walls(field, edges, parts, paint);
  if (!model) return model.error();
  const GridPlacement& placement = maker.placement;
  const int64_t twice =
      maker.steps(2 * placement.height_scale * (limb.middle - placement.origin.z));
  for (const std::array<int, 3>& t : field.triangles)
    for (const int v : t)
      if (const GridPoint p = field.place(v); p.y <= level) {
        const int64_t inner = twice - field.floor_height(field.vertex_point[v]);
        feet.push_back({p.x, inner});
        feet.push_back({p.x, inner - field.vertex_height[v]});
      }
  return SolidLimb{limb.id, low_corner(field), placement.unit * static_cast<double>(twice),
                   std::move(*model)};
}

/// Moves limbs from their own low corners to the corner at the figure's origin.
void move_limbs(GridPoint low, double unit, std::vector<SolidLimb>& limbs) {
  for (SolidLimb& limb : limbs)
    for (Point3& p : limb.model.positions)
      p = p + Point3{unit * static_cast<double>(limb.low.x - low.x),
                     unit * static_cast<double>(limb.low.y - low.y), 0};
}

/// A solid without its drawing, and the corner of its box on the grid, which is the solid's origin.
struct PlacedSolid {
  Solid solid;
  GridPoint low;
};

/// Makes the solid of a sheet whose place is known.
Result<PlacedSolid> make_placed(const relief::VisibleSheet& sheet,
                                const std::vector<relief::LimbSheet>& limbs, const BackPaint& paint,
                                const SolidOptions& options, const GridPlacement& placement) {
  const bool figure = options.back != BackSide::flat;
  const bool standing = stands(options);
  const std::vector<ModelPart> parts =
      figure && !standing ? sheet.model.parts : parts_with_base(sheet.model);
  const FieldMaker maker{options, placement, paint};
  HeightField field = maker.field_of(sheet);
  const int base = static_cast<int>(parts.size()) - 1;
  if (standing)
    if (Status status = cut_feet(maker.sunk(), field); !status) return status.error();
  if (Status status = maker.repair(field); !status) return status.error();
  if (!figure)
    if (Status status = add_plate(options, base, paint.plate, field); !status)
      return status.error();
  FieldEdges edges = connect_field(field);
  if (figure)
    if (Status status = maker.add_back(edges, field); !status) return status.error();
  std::vector<SolidLimb> mirrored;
  std::vector<GridPoint> feet;
  for (const relief::LimbSheet& limb : limbs) {
    auto made = make_limb(maker, limb, parts, lowest(field), feet);
    if (!made) return made.error();
    mirrored.push_back(std::move(*made));
  }
  if (standing) {
    if (Status status = maker.stand(base, std::move(feet), field); !status) return status.error();
    edges = connect_field(field);
  }
  settle_heights(edges, field);
  auto model = raise_walls(field, edges, parts, paint);
  if (!model) return model.error();
  PlacedSolid made{{std::move(*model), {}, find_pieces(field, parts)}, low_corner(field)};
  Solid& solid = made.solid;
  move_limbs(made.low, field.unit, mirrored);
  if (Status status = unite_with_limbs(mirrored, field.unit, paint.parts, solid); !status)
    return status.error();
  solid.facts.volume = volume_of(solid.model);
  return made;
}

/// Adds the contours of the drawing to a solid.
void add_contours(const relief::TakenInk& ink, const Model& surface, const SolidOptions& options,
                  const GridPlacement& placement, double pictured, PlacedSolid& made) {
  if (ink.contours.lines.empty()) return;
  const Point3 scale{placement.scale, placement.scale, placement.height_scale};
  const Point3 o = placement.origin;
  const double unit = placement.unit;
  const relief::SolidPlace place{
      scale,
      {-scale.x * o.x - unit * static_cast<double>(made.low.x),
       -scale.y * o.y - unit * static_cast<double>(made.low.y), -scale.z * o.z},
      pictured,
      options.back != BackSide::flat};
  relief::add_ink(ink.contours, ink.inked, options.ink_width, surface, place, made.solid.model,
                  made.solid.drawing.rgba);
}

/// Returns the factor by which the scale of a figure on a base must grow for the whole to have its
/// size. Its longest side has some mm that do not grow: the plate's part below the feet, or a
/// margin at each end that the plate reaches.
double missing_growth(const Solid& solid, const SolidOptions& options) {
  const Model& model = solid.model;
  Box3 whole;
  for (const Point3 p : model.positions) whole.add(p);
  Box3 plate;
  const ModelPart& base = model.parts.back();
  for (int t = base.first_triangle; t < base.first_triangle + base.triangle_count; ++t)
    for (const int v : model.triangles[t]) plate.add(model.positions[v]);
  const auto fixed = [&](double Point3::*axis) {
    return options.margin * ((plate.min.*axis <= whole.min.*axis ? 1 : 0) +
                             (plate.max.*axis >= whole.max.*axis ? 1 : 0));
  };
  const Point3 sides = whole.sides();
  const std::pair<double, double> longest =
      std::max({std::pair{sides.x, fixed(&Point3::x)}, std::pair{sides.z, fixed(&Point3::z)},
                std::pair{sides.y, options.thickness - sunk_depth(options)}});
  return (options.size - longest.second) / (longest.first - longest.second);
}

}  // namespace

Result<Solid> make_solid(relief::VisibleSheet sheet, const std::vector<relief::LimbSheet>& limbs,
                         Drawing drawing, const SolidOptions& options) {
  if (Status status = check_options(options); !status) return status.error();
  const relief::TakenInk ink = relief::finish_sheet(options.ink, sheet.model, drawing);
  auto placement = place_on_grid(sheet, limbs, options);
  if (!placement) return placement.error();
  if (options.detail && placement->height_scale < placement->scale) {
    if (Status status = compress_heights(placement->height_scale / placement->scale, sheet);
        !status)
      return status.error();
    placement = place_on_grid(sheet, limbs, options);
    if (!placement) return placement.error();
  }
  BackPaint paint = paint_back(drawing, sheet, options.back);
  auto made = make_placed(sheet, limbs, paint, options, *placement);
  for (int fits = 1; made && stands(options) && fits < most_fits; ++fits) {
    const double growth = missing_growth(made->solid, options);
    if (std::abs(growth - 1) <= size_slack) break;
    grow(growth, *placement);
    made = make_placed(sheet, limbs, paint, options, *placement);
  }
  if (!made) return made.error();
  made->solid.drawing = std::move(paint.drawing);
  add_contours(ink, sheet.model, options, *placement, paint.pictured, *made);
  return std::move(made->solid);
}

}  // namespace relievo
