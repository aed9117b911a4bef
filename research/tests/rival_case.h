#pragma once

#include <gtest/gtest.h>

#include "research/rivals/rival.h"

namespace relievo::research {

inline relief::LayeredMesh layered(const Scene& scene, int vertices = 6000) {
  relief::LayerOptions layers;
  layers.vertex_budget = vertices;
  auto mesh = layer_for_rivals(scene, layers);
  EXPECT_TRUE(mesh) << to_string(mesh.error());
  return mesh ? *mesh : relief::LayeredMesh{};
}

/// The model of a scene by the method of that name; a failure fails the test.
inline Model reconstructed(const Scene& scene, const char* method, const RivalOptions& options = {},
                           int vertices = 6000) {
  const relief::LayeredMesh joined = layered(scene, vertices);
  auto model = find_rival(method)->reconstruct({scene, joined, options}, {});
  EXPECT_TRUE(model) << to_string(model.error());
  return model ? *model : Model{};
}

}  // namespace relievo::research
