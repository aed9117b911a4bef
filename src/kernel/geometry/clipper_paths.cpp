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

}  // namespace relievo
