#include "kernel/meshing/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace relievo {

int orientation(Point2 a, Point2 b, Point2 c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using P = Kernel::Point_2;
  return static_cast<int>(CGAL::orientation(P(a.x, a.y), P(b.x, b.y), P(c.x, c.y)));
}

}  // namespace relievo
