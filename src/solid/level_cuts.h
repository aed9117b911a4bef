#pragma once

#include <polyclipping/clipper.hpp>
#include <vector>

#include "relievo/model.h"

namespace relievo {

/// Steps per mm of the plane of cuts.
constexpr double cut_steps = 65536;

/// The section of a solid with a level plane.
struct LevelCut {
  ClipperLib::Paths rings;
  ClipperLib::Path corners;       ///< of all rings
  std::vector<int> corner_parts;  ///< the part of each corner
};

/// Cuts closed models at any height. Vertices at one position count as one.
class LevelCutter {
 public:
  /// Keeps a reference. O(n log n) for n triangles.
  explicit LevelCutter(const Model& model);

  /// Returns the section at a height. O(n).
  LevelCut cut(double height) const;

 private:
  const Model& model_;
  std::vector<int> place_;          ///< #V, the first vertex at the same position
  std::vector<int> triangle_part_;  ///< #F
};

}  // namespace relievo
