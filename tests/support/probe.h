#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "relief/session/build_relief.h"

namespace relievo::testing {

/// The relief of a scene; a failure of the test, and an empty relief, where there is none.
inline relief::Relief relief_of(const Scene& scene, const relief::ReliefOptions& options) {
  auto relief = relief::build_relief(scene, options);
  EXPECT_TRUE(relief.ok()) << (relief.ok() ? "" : to_string(relief.error()));
  return relief.ok() ? std::move(*relief) : relief::Relief();
}

/// Heights at one point of one face.
struct Probe {
  bool found = false;
  int part = -1;
  double f = 0;  ///< px
  double g = 0;  ///< px
  double h() const { return f + g; }
};

/// The frontmost face of a part up to `front` over the point; u and g linear, root afterwards.
inline Probe probe(const relief::Relief& relief, Point2 p,
                   int front = std::numeric_limits<int>::max()) {
  const relief::LayeredMesh& mesh = relief.layers;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Point2 a = mesh.vertices[mesh.triangles[t][0]];
    const Point2 b = mesh.vertices[mesh.triangles[t][1]];
    const Point2 c = mesh.vertices[mesh.triangles[t][2]];
    const double area = cross(b - a, c - a);
    const double w[3] = {cross(b - p, c - p) / area, cross(c - p, a - p) / area,
                         cross(a - p, b - p) / area};
    if (w[0] < -1e-9 || w[1] < -1e-9 || w[2] < -1e-9) continue;
    for (int f = mesh.stack_begin[t + 1] - 1; f >= mesh.stack_begin[t]; --f) {
      if (mesh.face_part[f] > front) continue;
      Probe result{true, mesh.face_part[f], 0, 0};
      double u = 0;
      for (int k = 0; k < 3; ++k) {
        u += w[k] * relief.inflation.u[mesh.faces[f][k]];
        result.g += w[k] * relief.ordering.g[mesh.faces[f][k]];
      }
      result.f = std::copysign(std::sqrt(std::abs(u)), u);
      return result;
    }
  }
  return {};
}

}  // namespace relievo::testing
