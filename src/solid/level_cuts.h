#pragma once

#include <polyclipping/clipper.hpp>
#include <vector>

#include "relievo/model.h"

namespace relievo {

/// Steps per mm of the plane in which cuts are told.
constexpr double cut_steps = 65536;

/// Where a corner of a cut comes from.
struct CutCorner {
  ClipperLib::IntPoint place;
  int part = 0;
};

/// What a level plane cuts out of a solid: rings, and by place the part of every corner.
struct LevelCut {
  ClipperLib::Paths rings;
  std::vector<CutCorner> corners;
};

/// Cuts closed models at any height; vertices at one place are one.
class LevelCutter {
 public:
  /// Keeps a reference. O(n) expected for n triangles.
  explicit LevelCutter(const Model& model);

  /// O(n).
  LevelCut cut(double height) const;

 private:
  const Model& model_;
  std::vector<int> place_;          ///< #V, the first vertex at the same place
  std::vector<int> triangle_part_;  ///< #F
};

}  // namespace relievo
