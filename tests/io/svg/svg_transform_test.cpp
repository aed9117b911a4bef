#include "io/svg/svg_transform.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

void expect_maps(const char* transform, Point2 from, Point2 to) {
  const auto affine = parse_transform(transform);
  ASSERT_TRUE(affine.has_value()) << transform;
  EXPECT_NEAR((*affine)(from).x, to.x, 1e-12) << transform;
  EXPECT_NEAR((*affine)(from).y, to.y, 1e-12) << transform;
}

TEST(SvgTransform, EveryPrimitive) {
  expect_maps("matrix(1 2 3 4 5 6)", {1, 1}, {9, 12});
  expect_maps("translate(3)", {1, 1}, {4, 1});
  expect_maps("translate(3,-4)", {1, 1}, {4, -3});
  expect_maps("scale(2)", {1, 3}, {2, 6});
  expect_maps("scale(2 -1)", {1, 3}, {2, -3});
  expect_maps("rotate(90)", {1, 0}, {0, 1});
  expect_maps("rotate(90 10 10)", {11, 10}, {10, 11});
  expect_maps("skewX(45)", {0, 1}, {1, 1});
  expect_maps("skewY(45)", {1, 0}, {1, 1});
}

TEST(SvgTransform, ListsApplyFromRightToLeft) {
  expect_maps("translate(10 0) scale(2)", {1, 1}, {12, 2});
  expect_maps("scale(2),translate(10 0)", {1, 1}, {22, 2});
  expect_maps(" translate ( 1e1 , 0 ) ", {0, 0}, {10, 0});
}

TEST(SvgTransform, MalformedIsNothing) {
  for (const char* text : {"rotate(1 2)", "scale()", "turn(3)", "translate(1", "matrix(1 2 3)"}) {
    EXPECT_FALSE(parse_transform(text).has_value()) << text;
  }
}

TEST(SvgTransform, UnitsOfCss) {
  const TransformBox box{{}, {20, 200, 100}};
  const auto at = [&](const char* text) { return parse_transform(text, box).value()({0, 0}); };
  EXPECT_EQ(at("translate(20px, 5%)"), (Point2{20, 5}));
  EXPECT_EQ(at("translateX(50%) translateY(1em)"), (Point2{100, 20}));
  EXPECT_EQ(at("translate3d(1in,2px,9px)"), (Point2{96, 2}));
  for (const char* quarter : {"rotate(90deg)", "rotate(.25turn)", "rotate(100grad)",
                              "rotateZ(1.5707963267948966rad)", "rotate(90)"})
    expect_maps(quarter, {1, 0}, {0, 1});
  expect_maps("scaleX(2) scaleY(300%)", {1, 1}, {2, 3});
  expect_maps("skew(45deg, 0)", {0, 1}, {1, 1});
  expect_maps("none", {3, 4}, {3, 4});
  expect_maps("matrix(1-2-3 4 5-6)", {1, 1}, {3, -4});
  for (const char* text : {"translate(1deg)", "rotate(1px)", "scale(2px)", "translate(1q)"})
    EXPECT_FALSE(parse_transform(text, box).has_value()) << text;
}

TEST(SvgTransform, PlainOnesNeedNoResolving) {
  for (const char* text : {"", "translate(1,2) rotate(3 4 5)", "matrix(1e-3 0 0 1 2 3)"})
    EXPECT_TRUE(is_plain_transform(text)) << text;
  for (const char* text : {"none", "rotate(3deg)", "translate(5%)", "translateX(3)", "rotate(1 2)"})
    EXPECT_FALSE(is_plain_transform(text)) << text;
}

TEST(SvgTransform, Origins) {
  const TransformBox box{{10, 20}, {16, 200, 100}};
  const auto origin = [&](const char* text) { return parse_transform_origin(text, box).value(); };
  EXPECT_EQ(origin("left top"), (Point2{10, 20}));
  EXPECT_EQ(origin("bottom left"), (Point2{10, 120}));
  EXPECT_EQ(origin("center"), (Point2{110, 70}));
  EXPECT_EQ(origin("25%"), (Point2{60, 70}));
  EXPECT_EQ(origin("5px 7px 9px"), (Point2{15, 27}));
  EXPECT_FALSE(parse_transform_origin("somewhere", box).has_value());
}

TEST(SvgTransform, TheTextOfAMapIsExact) {
  const Affine2 map = parse_transform("rotate(33) translate(1.1 -7)").value();
  const Affine2 again = parse_transform(transform_text(map)).value();
  EXPECT_EQ(again({3, 7}), map({3, 7}));
}

}  // namespace
}  // namespace relievo
