#pragma once

#include "relievo/point.h"

namespace relievo {

/// Sign of the signed area of the triangle abc, exact: 1, 0 or -1.
int orientation(Point2 a, Point2 b, Point2 c);

}  // namespace relievo
