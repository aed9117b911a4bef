#include <gtest/gtest.h>

#include <cmath>

#include "relief/session/build_relief.h"
#include "relief/surface/assemble_model.h"
#include "relievo/model.h"
#include "support/probe.h"
#include "support/random_scene.h"

namespace relievo::relief {
namespace {

using namespace testing;

Relief field_of(Method method, Field field) {
  ReliefOptions options;
  options.method = method;
  options.layers.vertex_budget = 1500;
  Relief relief = relief_of(random_scene(8), options);
  keep_field(relief, field);
  return relief;
}

TEST(KeepField, InflationAndShiftAddUpToTheRelief) {
  for (const Method method : {Method::approximate, Method::nonlinear}) {
    const Relief relief = field_of(method, Field::relief);
    const Relief inflation = field_of(method, Field::inflation);
    const Relief shift = field_of(method, Field::shift);
    double shifted = 0;
    for (size_t n = 0; n < relief.ordering.h.size(); ++n) {
      const double u = relief.inflation.u[n];
      const double f = std::copysign(std::sqrt(std::abs(u)), u);
      EXPECT_NEAR(inflation.ordering.h[n], f, 1e-9);
      EXPECT_NEAR(inflation.ordering.h[n] + shift.ordering.h[n] - 1, relief.ordering.h[n], 1e-9);
      EXPECT_EQ(inflation.ordering.g[n], 0);
      EXPECT_EQ(shift.inflation.grad_u[n], (Point2{0, 0}));
      shifted = std::max(shifted, std::abs(relief.ordering.g[n]));
    }
    EXPECT_GT(shifted, 1);
  }
}

TEST(KeepField, EveryFieldIsASurfaceWithNormals) {
  for (const Field field : {Field::relief, Field::inflation, Field::shift}) {
    const Relief relief = field_of(Method::approximate, field);
    const auto model = assemble_model(
        {relief.layers, relief.inflation, relief.ordering, random_scene(8)}, ModelOptions());
    ASSERT_TRUE(model.ok());
    for (const Point3 n : model->normals) EXPECT_NEAR(norm(n), 1, 1e-6);
  }
}

}  // namespace
}  // namespace relievo::relief
