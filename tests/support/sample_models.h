#pragma once

#include <string>

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo {

struct Ellipsoid {
  std::string id;
  Point2 centre;    ///< canvas px, y down
  double base = 0;  ///< z of its rim, px
  Point3 radii;     ///< px; a negative z makes a pit that is seen from above
  int rings = 24;   ///< from the pole to the rim
};

/// A model without faces on a canvas of the given size.
Model empty_model(double width, double height);

/// Adds half an ellipsoid as a part, with exact normals.
void add_ellipsoid(Model& model, const Ellipsoid& ellipsoid);

/// A flat rectangle over the whole canvas as a part.
void add_plane(Model& model, const std::string& id, double z);

/// A rectangle of ink at a height, which faces the viewer or away from them. Its colour is that of
/// the top left corner of a picture.
InkMesh ink_rectangle(Point2 low, Point2 high, double z, bool facing);

/// A hemisphere of the given radius at the middle of a canvas 2.5 radii wide.
Model hemisphere(double radius, int rings = 24);

/// A hemisphere whose left and right halves are two parts that share the vertices between them.
Model split_hemisphere(double radius);

/// 8 x 8 pixels, opaque: white but for a red top-left, green top-right and blue bottom-left
/// quarter.
Drawing quarters();

}  // namespace relievo
