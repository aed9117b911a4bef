#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflate.h"
#include "relief/layers/layer_parts.h"
#include "relief/ordering/order_depth.h"
#include "support/solve_once.h"

namespace relievo::testing {

/// A scene as far as its shift.
struct ShiftedScene {
  relief::LayeredMesh mesh;
  relief::Discretisation discretisation;
  relief::Inflation inflation;
  relief::Ordering ordering;

  Point2 at(size_t n) const { return mesh.vertices[mesh.node_vertex[n]]; }
};

inline ShiftedScene shifted(const Scene& scene, const relief::OrderingOptions& ordering = {}) {
  relief::LayerOptions options;
  options.vertex_budget = 3000;
  Result<relief::LayeredMesh> mesh = relief::layer_parts(scene, options);
  EXPECT_TRUE(mesh) << to_string(mesh.error());
  Result<relief::Inflation> inflation = relief::inflate(*mesh, scene, {});
  EXPECT_TRUE(inflation) << to_string(inflation.error());
  Result<relief::Ordering> order = relief::order_depth(*mesh, *inflation, scene, ordering);
  EXPECT_TRUE(order) << to_string(order.error());
  relief::Discretisation discretisation = relief::discretise(*mesh);
  return {std::move(*mesh), std::move(discretisation), std::move(*inflation), std::move(*order)};
}

}  // namespace relievo::testing
