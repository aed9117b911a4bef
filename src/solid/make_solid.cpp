#include "solid/make_solid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "kernel/base/disjoint_sets.h"
#include "relief/finish/ink_rims.h"
#include "solid/back_paint.h"
#include "solid/compress_heights.h"
#include "solid/field_rim.h"
#include "solid/lay_floor.h"
#include "solid/mirror_limbs.h"
#include "solid/plate_outline.h"
#include "solid/raise_walls.h"
#include "solid/repair_plane.h"
#include "solid/settle_heights.h"
#include "solid/snap_sheet.h"
#include "solid/stand.h"

namespace relievo {
namespace {

/// Where sides touch in a point, they are moved so many mm apart.
constexpr double least_gap = 0.05;
/// A figure is at least so many mm deep; its back gives way.
constexpr double least_depth = 0.4;
/// Steps on its back are ramps so wide, of its size.
constexpr double soft_share = 0.015;
/// mm, of what cuts dough.
constexpr double cutter_wall = 0.8;

constexpr double unbounded = std::numeric_limits<double>::infinity();

struct Extent {
  Point3 low{unbounded, unbounded, unbounded};
  Point3 high{-unbounded, -unbounded, -unbounded};
};

/// Of a sheet, and of its back and of limbs on the far side where that is wanted.
Extent extent_of(const relief::VisibleSheet& sheet, const std::vector<relief::LimbSheet>& limbs,
                 bool backed) {
  const Model& model = sheet.model;
  Extent extent;
  if (backed)
    for (const relief::BackPoint& back : sheet.back) extent.low.z = std::min(extent.low.z, back.z);
  for (const relief::LimbSheet& limb : limbs)
    for (const std::array<int, 3>& triangle : limb.sheet.model.triangles)
      for (const int v : triangle)
        extent.low.z = std::min(extent.low.z, 2 * limb.middle - limb.sheet.model.positions[v].z);
  for (const std::array<int, 3>& triangle : model.triangles)
    for (const int v : triangle) {
      const Point3 p = model.positions[v];
      extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y),
                    std::min(extent.low.z, p.z)};
      extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y),
                     std::max(extent.high.z, p.z)};
    }
  return extent;
}

/// Half the diameter of the disc around the middle of the extent that holds the model, px.
double radius_of(const Model& model, const Extent& extent) {
  const Point3 middle = 0.5 * (extent.low + extent.high);
  double radius = 0;
  for (const std::array<int, 3>& triangle : model.triangles)
    for (const int v : triangle) {
      const Point3 p = model.positions[v] - middle;
      radius = std::max(radius, std::hypot(p.x, p.y));
    }
  return radius;
}

/// The scale with which the whole gets its size.
Result<GridPlacement> place_on_grid(const relief::VisibleSheet& sheet,
                                    const std::vector<relief::LimbSheet>& limbs,
                                    const SolidOptions& options) {
  const bool backed = options.back != BackSide::flat;
  const Extent extent = extent_of(sheet, limbs, backed);
  const double below = backed ? 0 : options.thickness;
  const Point3 sides = extent.high - extent.low;
  const double wall = options.cutter > 0 ? cutter_wall : 0;
  const double around = options.base == BaseShape::none ? 0 : 2 * (options.margin + wall);
  const bool disc = options.base == BaseShape::round && !backed;
  const double wide = disc ? 2 * radius_of(sheet.model, extent) : std::max(sides.x, sides.y);
  const double deep = backed ? around : below;
  double scale = (options.size - around) / wide;
  // Where the height is limited, depth has no part in the size.
  if (sides.z > 0 && options.height == 0) scale = std::min(scale, (options.size - deep) / sides.z);
  if (!(scale > 0))
    return Error{ErrorCode::usage, "leaves no room beside the base's margin and thickness",
                 "--size"};
  const double reach = options.size + 2 * options.ring + 16;
  const double unit = std::ldexp(1.0, static_cast<int>(std::ceil(std::log2(reach))) - 24);
  double height_scale = scale;
  if (options.height > 0 && sides.z > 0)
    height_scale = std::min(scale, (options.height - below) / sides.z);
  if (!(height_scale > 0))
    return Error{ErrorCode::usage, "leaves no room above the base's thickness", "--height"};
  const double lift = below / height_scale;
  return GridPlacement{
      scale, height_scale, {extent.low.x, extent.low.y, extent.low.z - lift}, unit, backed};
}

/// The connected pieces of a field, and what is not of the largest.
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

/// The scene's parts and, last, the base, whose name none of them has.
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

/// Puts a plate around the field, of a height in mm.
Status add_around(const SolidOptions& options, double top, int part, Point2 uv,
                  HeightField& field) {
  const FieldEdges edges = connect_field(field);
  Outline silhouette;
  for (const std::vector<int>& points : rim_rings(field, edges)) {
    Ring& ring = silhouette.emplace_back();
    for (const int p : points)
      ring.push_back(
          {static_cast<double>(field.points[p].x), static_cast<double>(field.points[p].y)});
  }
  auto outline = plate_outline(silhouette, options, 1 / field.unit);
  if (!outline) return outline.error();
  const int64_t height = std::llround(top / field.unit);
  return surround({std::move(*outline), height, part, uv}, edges, field);
}

/// Puts the plate around the field, and the cutter's wall around that.
Status add_plate(const SolidOptions& options, int part, Point2 uv, HeightField& field) {
  if (options.base == BaseShape::none) return Done{};
  const Status plate = add_around(options, options.thickness, part, uv, field);
  if (!plate || options.cutter == 0) return plate;
  SolidOptions wall = options;
  wall.margin = cutter_wall;
  return add_around(wall, options.thickness + options.cutter, part, uv, field);
}

/// Keeps ink narrow along the rims of a figure, in front as behind.
void narrow_rims(const Drawing& drawing, relief::VisibleSheet& sheet) {
  Model& model = sheet.model;
  std::vector<double> rise;
  for (const Point3& p : model.positions) rise.push_back(-p.z);
  relief::narrow_inked_rims(model, drawing);
  for (size_t v = 0; v < rise.size(); ++v) sheet.back[v].z -= rise[v] + model.positions[v].z;
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
    return Error{ErrorCode::usage, "a hole or a ring to hang it by needs a base", "--base"};
  if (options.cutter > 0 && (options.base != BaseShape::outline || options.hole + options.ring > 0))
    return Error{ErrorCode::usage, "a cutter needs --base outline, without a hole or a ring",
                 "--cutter"};
  const bool figure = options.back != BackSide::flat;
  if (figure && (options.base == BaseShape::outline || options.hole + options.ring > 0))
    return Error{ErrorCode::usage,
                 "a figure stands on --base plate or round, without a hole or a ring", "--base"};
  if (!options.mirror.empty() && (!figure || options.detail))
    return Error{ErrorCode::usage, "is of figures, without --height-mode detail", "--mirror"};
  return Done{};
}

/// What fields have in common.
struct FieldMaker {
  const SolidOptions& options;
  const GridPlacement& placement;
  const PaintedDrawing& painted;

  int64_t steps(double mm) const { return std::llround(mm / placement.unit); }
  /// How far the feet are sunk into a plate.
  int64_t sunk() const { return steps(0.5 * options.thickness); }

  HeightField field_of(const relief::VisibleSheet& sheet) const {
    HeightField field = snap_sheet(sheet, placement);
    for (Point2& uv : field.uvs) uv.y *= painted.shrink;
    return field;
  }

  Status repair(HeightField& field) const {
    return repair_plane(least_gap / placement.unit, field);
  }

  Status add_back(const FieldEdges& edges, HeightField& field) const {
    return lay_floor({steps(least_depth), steps(soft_share * options.size)}, edges, field);
  }

  Status stand(int part, std::vector<GridPoint> others, HeightField& field) const {
    return add_stand({options.base == BaseShape::round, 2 * sunk(), steps(options.margin),
                      steps(options.size), part, painted.paint.plate, std::move(others)},
                     field);
  }
};

GridPoint low_corner(const HeightField& field) {
  GridPoint low{std::numeric_limits<int64_t>::max(), std::numeric_limits<int64_t>::max()};
  for (const GridPoint p : field.points) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  return low;
}

/// The solids of limbs, in the places that they have in the figure but for their corners.
struct LimbFields {
  std::vector<SolidLimb> solids;
  std::vector<GridPoint> low;  ///< of each
  std::vector<GridPoint> far;  ///< x, and z when it is mirrored, of what is below a level
};

Status add_limb(const FieldMaker& maker, const Drawing& drawing, const relief::LimbSheet& limb,
                const std::vector<ModelPart>& parts, int64_t level, LimbFields& fields) {
  relief::VisibleSheet sheet = limb.sheet;
  narrow_rims(drawing, sheet);
  HeightField field = maker.field_of(sheet);
  if (Status status = maker.repair(field); !status) return status;
  const FieldEdges edges = connect_field(field);
  if (Status status = maker.add_back(edges, field); !status) return status;
  settle_heights(edges, field);
  auto model = raise_walls(field, edges, parts, maker.painted.paint);
  if (!model) return model.error();
  const GridPlacement& placement = maker.placement;
  const int64_t twice =
      maker.steps(2 * placement.height_scale * (limb.middle - placement.origin.z));
  for (const std::array<int, 3>& t : field.triangles)
    for (const int v : t)
      if (const GridPoint p = field.place(v); p.y <= level) {
        const int64_t inner = twice - field.floor_height(field.vertex_point[v]);
        fields.far.push_back({p.x, inner});
        fields.far.push_back({p.x, inner - field.vertex_height[v]});
      }
  fields.low.push_back(low_corner(field));
  fields.solids.push_back(
      {limb.id, placement.unit * static_cast<double>(twice), std::move(*model)});
  return Done{};
}

/// Moves limbs to the corner that a figure's model is counted from.
void align(GridPoint low, double unit, LimbFields& fields) {
  for (size_t i = 0; i < fields.solids.size(); ++i)
    for (Point3& p : fields.solids[i].model.positions)
      p = p + Point3{unit * static_cast<double>(fields.low[i].x - low.x),
                     unit * static_cast<double>(fields.low[i].y - low.y), 0};
}

}  // namespace

Result<Solid> make_solid(const relief::VisibleSheet& given,
                         const std::vector<relief::LimbSheet>& limbs, const Drawing& drawing,
                         const SolidOptions& options) {
  if (Status status = check_options(options); !status) return status.error();
  const bool figure = options.back != BackSide::flat;
  relief::VisibleSheet sheet = given;
  if (figure) narrow_rims(drawing, sheet);
  auto placement = place_on_grid(sheet, limbs, options);
  if (!placement) return placement.error();
  if (options.detail && placement->height_scale < placement->scale) {
    if (Status status = compress_heights(placement->height_scale / placement->scale, sheet);
        !status)
      return status.error();
    placement = place_on_grid(sheet, limbs, options);
    if (!placement) return placement.error();
  }
  const bool stands = figure && options.base != BaseShape::none;
  const std::vector<ModelPart> parts =
      figure && !stands ? sheet.model.parts : parts_with_base(sheet.model);
  PaintedDrawing painted = paint_back(drawing, sheet.model, options.back);
  const FieldMaker maker{options, *placement, painted};
  HeightField field = maker.field_of(sheet);
  const int base = static_cast<int>(parts.size()) - 1;
  if (stands)
    if (Status status = cut_feet(maker.sunk(), field); !status) return status.error();
  if (Status status = maker.repair(field); !status) return status.error();
  if (!figure)
    if (Status status = add_plate(options, base, painted.paint.plate, field); !status)
      return status.error();
  FieldEdges edges = connect_field(field);
  if (figure)
    if (Status status = maker.add_back(edges, field); !status) return status.error();
  LimbFields mirrored;
  for (const relief::LimbSheet& limb : limbs)
    if (Status status = add_limb(maker, drawing, limb, parts, lowest(field), mirrored); !status)
      return status.error();
  if (stands) {
    if (Status status = maker.stand(base, std::move(mirrored.far), field); !status)
      return status.error();
    edges = connect_field(field);
  }
  settle_heights(edges, field);
  auto model = raise_walls(field, edges, parts, painted.paint);
  if (!model) return model.error();
  Solid solid{std::move(*model), std::move(painted.drawing), find_pieces(field, parts)};
  align(low_corner(field), field.unit, mirrored);
  if (Status status = unite_with_limbs(mirrored.solids, field.unit, painted.paint.parts, solid);
      !status)
    return status.error();
  solid.facts.volume = volume_of(solid.model);
  return solid;
}

}  // namespace relievo
