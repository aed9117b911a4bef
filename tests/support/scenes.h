#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"

namespace relievo::testing {

inline Ring circle(Point2 centre, double radius, int n = 200) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    ring.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
  }
  return ring;
}

inline Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline Part part(std::string id, Ring ring, double c = 4, double d = 1) {
  return Part{std::move(id), {std::move(ring)}, c, d};
}

/// An empty scene on a 400 x 400 canvas.
inline Scene canvas() {
  Scene scene;
  scene.width = 400;
  scene.height = 400;
  return scene;
}

/// A body and a leg whose root lies inside it and is joined: the test scene of the method.
inline Scene body_and_leg() {
  Scene scene = canvas();
  scene.parts = {part("body", rectangle(100, 100, 300, 220)),
                 part("leg", rectangle(180, 160, 220, 320))};
  scene.joins = {{1, 0, {{180, 160}, {220, 160}}}};
  return scene;
}

}  // namespace relievo::testing
