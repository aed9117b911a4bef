#pragma once

#include <functional>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"
#include "support/structured_meshes.h"

namespace relievo::testing {

/// Whether a part covers a base triangle, given the triangle's index and centroid.
using Cover = std::function<bool(int triangle, Point2 centroid)>;

/// Puts parts, back to front, on one base triangulation, each on nodes of its own: those on the
/// boundary of what the part covers are outline, the others interior. No constraints.
relief::LayeredMesh stack_parts(const PlanarMesh& base, const std::vector<Cover>& parts);

/// Adds the pairs that overlapping outlines get without a join: the outline of the upper part lies
/// above the interior of the lower one, the interior of the upper one above the lower outline.
void add_outline_pairs(relief::LayeredMesh& mesh);

/// Cuts the lower part open along base vertices where `on_join` holds and reconnects the side that
/// the upper part does not cover to the upper part's nodes (which become seam); the nodes left to
/// the covered lip become flap. Call before add_outline_pairs.
void join_parts(relief::LayeredMesh& mesh, int upper, int lower,
                const std::function<bool(Point2)>& on_join);

/// Node of the part at the base vertex, or -1.
int node_at(const relief::LayeredMesh& mesh, int part, int vertex);

/// The centroid of a face, px.
Point2 middle_of_face(const relief::LayeredMesh& mesh, int face);

/// A scene with as many parts as the mesh, named "part0", "part1", ..., all with c and d.
Scene scene_of(const relief::LayeredMesh& mesh, double c = 4, double d = 1);

/// Cover by a disc.
Cover in_disc(Point2 centre, double radius);

/// Cover by an axis-aligned box.
Cover in_box(Point2 min, Point2 max);

/// A canvas of 1000 px with a large disc behind and `count` small ones of varied size on it, some
/// across its rim, on a grid of the given cell size; with outline pairs.
relief::LayeredMesh scattered_discs(int count, double cell);

}  // namespace relievo::testing
