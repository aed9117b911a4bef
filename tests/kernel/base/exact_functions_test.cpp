#include "kernel/base/exact_functions.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace relievo {
namespace {

constexpr double digits = 1e-15;

double from_minus_one_to_one() { return *rc::gen::inRange(-1'000'000'000, 1'000'000'000) / 1e9; }

RC_GTEST_PROP(ExactFunctions, TurnByAnAngle, ()) {
  const double angle = 50 * from_minus_one_to_one();
  const Point2 direction = exact::direction_of(angle);
  RC_ASSERT(std::abs(direction.x - std::cos(angle)) < digits);
  RC_ASSERT(std::abs(direction.y - std::sin(angle)) < digits);
}

RC_GTEST_PROP(ExactFunctions, TellTheAngle, ()) {
  const double x = from_minus_one_to_one();
  const double y = from_minus_one_to_one();
  RC_ASSERT(std::abs(exact::angle_of(y, x) - std::atan2(y, x)) < digits);
}

RC_GTEST_PROP(ExactFunctions, RaiseAndTakeLogarithms, ()) {
  const double x = 600 * from_minus_one_to_one();
  RC_ASSERT(std::abs(exact::exp(x) / std::exp(x) - 1) < digits);
  const double power = std::exp(x);
  RC_ASSERT(std::abs(exact::log(power) - std::log(power)) <= digits * std::abs(std::log(power)));
}

TEST(ExactFunctions, AreRightWhereTheyMeet) {
  EXPECT_EQ(exact::angle_of(0, 0), 0);
  EXPECT_EQ(exact::angle_of(0, -1), std::numbers::pi);
  EXPECT_EQ(exact::angle_of(-1, 0), -std::numbers::pi / 2);
  EXPECT_EQ(exact::direction_of(0).x, 1);
  EXPECT_EQ(exact::exp(0), 1);
  EXPECT_EQ(exact::exp(-1e9), 0);
  EXPECT_EQ(exact::exp(1e9), exact::exp(700));
  EXPECT_EQ(exact::log(1), 0);
}

}  // namespace
}  // namespace relievo
