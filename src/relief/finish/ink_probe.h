#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// The ink found on a line across an outline, px of the drawing.
struct Crossing {
  double inside = 0;   ///< distance from the outline to the inner edge
  double outside = 0;  ///< distance to the outer edge; 0 on paper, where the outline is the edge
  std::array<uint8_t, 3> rgb{};
};

/// Looks for ink in a drawing with a model on it. Points are px of the drawing, y down.
class InkProbe {
 public:
  InkProbe(const Model& model, const Image8& rgba);

  /// Returns the pixels of the drawing per pixel of the canvas.
  double scale() const { return scale_; }

  /// Returns whether a part is seen on the inner side of a point of its outline and no part in
  /// front of it on the outer side. `out`: unit, out of the part.
  bool ends_at(Point2 at, Point2 out, int part) const;

  /// Returns half the breadth of a part inwards from its outline, px, as far as it matters.
  double room(Point2 at, Point2 out, int part) const;

  /// Measures the ink on the line across an outline. Returns nothing unless there is a dark run
  /// with paint inside it. O(width of the widest ink).
  std::optional<Crossing> cross(Point2 at, Point2 out) const;

 private:
  int part_at(Point2 p) const;
  std::array<uint8_t, 3> colour(Point2 p) const;
  /// Returns whether all that lies outside a point of an outline is paper of about this colour.
  bool is_on_paper_of(std::array<uint8_t, 3> rgb, Point2 at, Point2 out) const;
  double brightness(Point2 p) const;
  std::vector<double> brightness_from(Point2 at, Point2 direction, double length) const;

  const Image8& rgba_;
  double scale_;
  double widest_;  ///< px
  Image16 front_;  ///< the part seen at every pixel, counted from 1
  Image8 grey_;
};

}  // namespace relievo::relief
