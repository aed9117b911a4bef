#include "solid/place_on_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/geometry/box3.h"

namespace relievo {
namespace {

/// Share of the cutter's height that the stamp has at most.
constexpr double stamp_share = 0.5;

/// Returns the box of a sheet and, if `backed`, of its back and its mirrored limbs, px.
Box3 box_of(const relief::VisibleSheet& sheet, const std::vector<relief::LimbSheet>& limbs,
            bool backed) {
  Box3 box;
  if (backed)
    for (const relief::BackPoint& back : sheet.back) box.min.z = std::min(box.min.z, back.z);
  for (const relief::LimbSheet& limb : limbs)
    for (const std::array<int, 3>& triangle : limb.sheet.model.triangles)
      for (const int v : triangle)
        box.min.z = std::min(box.min.z, 2 * limb.middle - limb.sheet.model.positions[v].z);
  for (const std::array<int, 3>& triangle : sheet.model.triangles)
    for (const int v : triangle) box.add(sheet.model.positions[v]);
  return box;
}

/// Returns the radius of the disc around the middle of a box that covers the model, px.
double radius_of(const Model& model, const Box3& box) {
  const Point3 middle = 0.5 * (box.min + box.max);
  double radius = 0;
  for (const std::array<int, 3>& triangle : model.triangles)
    for (const int v : triangle) {
      const Point3 p = model.positions[v] - middle;
      radius = std::max(radius, std::hypot(p.x, p.y));
    }
  return radius;
}

/// Returns the largest scale with which sides of the sheet, px, and what is added to them, mm, are
/// no longer than the size.
double fitted_scale(const SolidOptions& options, Point3 sides, Point3 added) {
  double scale = std::numeric_limits<double>::max();
  for (double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z})
    if (sides.*axis > 0) scale = std::min(scale, (options.size - added.*axis) / (sides.*axis));
  return scale;
}

/// Returns the limit for the height of the whole, mm.
double highest(const SolidOptions& options) {
  const double any = std::numeric_limits<double>::infinity();
  const double asked = options.height > 0 ? options.height : any;
  const double stamp = options.cutter > 0 ? options.thickness + stamp_share * options.cutter : any;
  return std::min(asked, stamp);
}

}  // namespace

Result<GridPlacement> place_on_grid(const relief::VisibleSheet& sheet,
                                    const std::vector<relief::LimbSheet>& limbs,
                                    const SolidOptions& options) {
  const bool backed = options.back != BackSide::flat;
  const Box3 box = box_of(sheet, limbs, backed);
  const double below = backed ? 0 : options.thickness;
  Point3 sides = box.sides();
  Point3 added{0, 0, below};
  if (stands(options)) {
    added.y = options.thickness - sunk_depth(options);
  } else if (options.base != BaseShape::none) {
    const double wall = options.cutter > 0 ? cutter_wall : 0;
    added.x = added.y = 2 * (options.margin + wall);
    if (options.base == BaseShape::round) sides.x = sides.y = 2 * radius_of(sheet.model, box);
  }
  const double limit = highest(options);
  const double depth = sides.z;
  // If the height is limited, depth does not count for the size.
  if (std::isfinite(limit)) sides.z = 0;
  const double scale = fitted_scale(options, sides, added);
  if (!(scale > 0))
    return Error{ErrorCode::usage, "leaves no room beside the base's margin and thickness",
                 "--size"};
  const double height_scale = depth > 0 ? std::min(scale, (limit - below) / depth) : scale;
  if (!(height_scale > 0))
    return Error{ErrorCode::usage, "leaves no room above the base's thickness", "--height"};
  const double reach = options.size + 2 * options.ring + 16;
  const double unit = std::ldexp(1.0, static_cast<int>(std::ceil(std::log2(reach))) - 24);
  const double lift = below / height_scale;
  return GridPlacement{scale, height_scale, box.min - Point3{0, 0, lift}, unit, backed};
}

void grow(double factor, GridPlacement& placement) {
  placement.scale *= factor;
  placement.height_scale *= factor;
}

}  // namespace relievo
