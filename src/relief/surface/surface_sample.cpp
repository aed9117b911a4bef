#include "relief/surface/surface_sample.h"

#include <algorithm>

namespace relievo::relief {
namespace {

bool finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

bool one_value_per_node(const SolvedSurface& surface) {
  const auto& [mesh, inflation, ordering, scene] = surface;
  const size_t nodes = mesh.node_vertex.size();
  return inflation.u.size() == nodes && inflation.grad_u.size() == nodes &&
         ordering.h.size() == nodes && ordering.g.size() == nodes &&
         ordering.grad_g.size() == nodes;
}

}  // namespace

SurfaceSample corner_sample(const SolvedSurface& surface, int face, int corner) {
  SurfaceSample sample = node_sample(surface, surface.mesh.faces[face][corner]);
  const auto& [corners, gradients] = surface.ordering.creases;
  const auto at = std::lower_bound(corners.begin(), corners.end(), corner_of(face, corner));
  if (at != corners.end() && *at == corner_of(face, corner))
    sample.grad_g = gradients[at - corners.begin()];
  return sample;
}

Status check_surface(const SolvedSurface& surface) {
  const auto& [mesh, inflation, ordering, scene] = surface;
  if (!(scene.width > 0 && scene.height > 0 && std::isfinite(scene.width * scene.height)))
    return Error{ErrorCode::bad_input, "the canvas must have a positive, finite size", "canvas"};
  if (!one_value_per_node(surface))
    return Error{ErrorCode::internal, "the heights and the mesh have different numbers of nodes",
                 ""};
  for (const int part : mesh.face_part)
    if (part < 0 || part >= static_cast<int>(scene.parts.size()))
      return Error{ErrorCode::internal, "a face belongs to no part of the scene", ""};
  for (const Point2 p : mesh.vertices)
    if (!finite(p)) return Error{ErrorCode::internal, "a vertex is not finite", ""};
  for (size_t n = 0; n < mesh.node_vertex.size(); ++n) {
    const SurfaceSample s = node_sample(surface, static_cast<int>(n));
    if (std::isfinite(s.u) && std::isfinite(s.g) && std::isfinite(ordering.h[n]) &&
        finite(s.grad_u) && finite(s.grad_g))
      continue;
    const int part = mesh.node_part[n];
    return Error{ErrorCode::internal,
                 "a height is not finite",
                 scene.parts[part].id,
                 {CulpritList::parts, static_cast<size_t>(part)}};
  }
  for (const Point2 slope : ordering.creases.gradient)
    if (!finite(slope)) return Error{ErrorCode::internal, "a slope is not finite", ""};
  return Done{};
}

}  // namespace relievo::relief
