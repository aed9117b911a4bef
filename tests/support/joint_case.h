#pragma once

#include <gtest/gtest.h>

#include "relief/pipeline/build_relief.h"
#include "support/joint_program.h"

namespace relievo::testing {

/// A scene on its mesh with the approximate solution.
struct JointCase {
  Scene scene;
  ReliefOptions options;
  Relief approximate;
};

inline ReliefOptions joint_options(int vertices, double lambda_bnd) {
  ReliefOptions options;
  options.layers.vertex_budget = vertices;
  options.hidden = false;
  options.joint.lambda_bnd = lambda_bnd;
  options.ordering.straight_limbs = false;  // as in the paper
  return options;
}

inline JointCase joint_case(const Scene& scene, int vertices, double lambda_bnd, bool glue = true) {
  JointCase result{scene, joint_options(vertices, lambda_bnd), {}};
  result.options.layers.glue = glue;
  Result<Relief> relief = build_relief(scene, result.options);
  EXPECT_TRUE(relief.ok()) << (relief.ok() ? "" : to_string(relief.error()));
  if (relief.ok()) result.approximate = *relief;
  return result;
}

inline JointSolution solve(const JointCase& test) {
  const Relief& start = test.approximate;
  Result<JointSolution> solution =
      solve_jointly(start.layers, test.scene, start.inflation, test.options.joint);
  EXPECT_TRUE(solution.ok()) << (solution.ok() ? "" : to_string(solution.error()));
  return solution.ok() ? *solution : JointSolution();
}

}  // namespace relievo::testing
