#pragma once

#include <string>
#include <string_view>

namespace relievo {

/// What CGAL says of a binary STL file, its corners at one place being one vertex.
struct SolidCensus {
  int triangles = 0;
  int uneven = 0;  ///< edges that are not run through exactly once each way
  bool manifold = false;
  int self_intersections = 0;  ///< pairs of triangles
  int pieces = 0;              ///< connected surfaces
  int holes = 0;               ///< handles: (2 pieces - Euler number) / 2
  double volume = 0;           ///< mm^3
};

SolidCensus census_of_stl(std::string_view stl);

/// The same of what lies in both of two solids, as it is before anything is rounded.
SolidCensus shared_by_stl(std::string_view one, std::string_view other);

/// The first property that a printable solid lacks, or "".
std::string what_is_wrong(const SolidCensus& census);

/// What admesh says of an STL file; empty where it finds nothing to repair.
std::string admesh_complaints(const std::string& path);

}  // namespace relievo
