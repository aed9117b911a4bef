#include "kernel/geometry/clipper_paths.h"

#include <cmath>
#include <utility>

namespace relievo {

ClipperLib::Path to_path(const Ring& ring) {
  ClipperLib::Path path;
  path.reserve(ring.size());
  for (const Point2 p : ring) {
    path.emplace_back(std::llround(p.x * clipper_units_per_px),
                      std::llround(p.y * clipper_units_per_px));
  }
  return path;
}

ClipperLib::Paths to_paths(const Region& region) {
  ClipperLib::Paths paths;
  paths.reserve(region.size());
  for (const Ring& ring : region) paths.push_back(to_path(ring));
  return paths;
}

Region to_region(const ClipperLib::Paths& paths) {
  Region region;
  for (const ClipperLib::Path& path : paths) {
    if (path.size() < 3) continue;
    Ring ring;
    ring.reserve(path.size());
    for (const ClipperLib::IntPoint& p : path) {
      ring.push_back({static_cast<double>(p.X) / clipper_units_per_px,
                      static_cast<double>(p.Y) / clipper_units_per_px});
    }
    region.push_back(std::move(ring));
  }
  return region;
}

ClipperLib::Paths combine(ClipperLib::ClipType operation, const ClipperLib::Paths& subject,
                          const ClipperLib::Paths& clip, ClipperLib::PolyFillType rule,
                          bool simple) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(simple);
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  clipper.Execute(operation, result, rule, ClipperLib::pftNonZero);
  return result;
}

std::vector<ClipperLib::Paths> pieces_of(ClipperLib::ClipType operation,
                                         const ClipperLib::Paths& subject,
                                         const ClipperLib::Paths& clip) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(operation, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  std::vector<ClipperLib::Paths> pieces;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext()) {
    if (node->IsHole()) continue;
    ClipperLib::Paths& piece = pieces.emplace_back(1, node->Contour);
    for (const ClipperLib::PolyNode* hole : node->Childs) piece.push_back(hole->Contour);
  }
  return pieces;
}

ClipperLib::Paths grow_paths(const ClipperLib::Paths& paths, double distance, double tolerance) {
  ClipperLib::ClipperOffset offset(2, tolerance);
  offset.AddPaths(paths, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  ClipperLib::Paths grown;
  offset.Execute(grown, distance);
  return grown;
}

}  // namespace relievo
