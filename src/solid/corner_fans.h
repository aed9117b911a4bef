#pragma once

#include <vector>

#include "solid/height_field.h"

namespace relievo {

/// The corners around points, as 3 * triangle + k, counter-clockwise. A point at which the field
/// touches itself has several fans.
struct CornerFans {
  std::vector<int> begin;    ///< #fans + 1
  std::vector<int> corners;  ///< those of fan i are [begin[i], begin[i + 1])
  std::vector<char> closed;  ///< #fans; others begin and end at the field's rim

  size_t size() const { return closed.size(); }
};

/// Collects the fans of all points: open ones, then closed ones, both by their first corner.
/// Linear.
CornerFans collect_fans(const HeightField& field, const FieldEdges& edges);

}  // namespace relievo
