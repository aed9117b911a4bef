#pragma once

#include <gtest/gtest.h>

#include "relief/session/build_relief.h"
#include "support/nonlinear_program.h"
#include "support/solve_once.h"

namespace relievo::testing {

/// A scene on its mesh with the approximate solution.
struct NonlinearCase {
  Scene scene;
  relief::ReliefOptions options;
  relief::Relief approximate;
};

inline relief::ReliefOptions nonlinear_options(int vertices, double lambda_bnd) {
  relief::ReliefOptions options;
  options.layers.vertex_budget = vertices;
  options.hidden = false;
  options.nonlinear.lambda_bnd = lambda_bnd;
  options.ordering.straight_limbs = options.ordering.close_caps = false;  // as in the paper
  return options;
}

inline NonlinearCase nonlinear_case(const Scene& scene, int vertices, double lambda_bnd,
                                    bool glue = true) {
  NonlinearCase result{scene, nonlinear_options(vertices, lambda_bnd), {}};
  result.options.layers.glue = glue;
  Result<relief::Relief> relief = relief::build_relief(scene, result.options);
  EXPECT_TRUE(relief.ok()) << (relief.ok() ? "" : to_string(relief.error()));
  if (relief.ok()) result.approximate = *relief;
  return result;
}

inline relief::NonlinearSolution solve(const NonlinearCase& test) {
  const relief::Relief& start = test.approximate;
  Result<relief::NonlinearSolution> solution =
      relief::solve_nonlinear(start.layers, test.scene, start.inflation, test.options.nonlinear);
  EXPECT_TRUE(solution.ok()) << (solution.ok() ? "" : to_string(solution.error()));
  return solution.ok() ? *solution : relief::NonlinearSolution();
}

}  // namespace relievo::testing
