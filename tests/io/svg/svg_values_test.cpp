#include "io/svg/svg_values.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo {
namespace {

TEST(SvgLength, EveryUnit) {
  const LengthContext context{20, 200, 100};
  const auto width = [&](const char* text) {
    return parse_length(text, LengthAxis::horizontal, context).value();
  };
  EXPECT_DOUBLE_EQ(width("7"), 7);
  EXPECT_DOUBLE_EQ(width(" 7px "), 7);
  EXPECT_DOUBLE_EQ(width("72pt"), 96);
  EXPECT_DOUBLE_EQ(width("6pc"), 96);
  EXPECT_DOUBLE_EQ(width("25.4mm"), 96);
  EXPECT_DOUBLE_EQ(width("2.54cm"), 96);
  EXPECT_DOUBLE_EQ(width("1in"), 96);
  EXPECT_DOUBLE_EQ(width("2em"), 40);
  EXPECT_DOUBLE_EQ(width("2ex"), 20);
  EXPECT_DOUBLE_EQ(width("50%"), 100);
  EXPECT_DOUBLE_EQ(parse_length("50%", LengthAxis::vertical, context).value(), 50);
  EXPECT_DOUBLE_EQ(parse_length("100%", LengthAxis::diagonal, context).value(),
                   std::sqrt((200.0 * 200 + 100 * 100) / 2));
  for (const char* text : {"", "px", "3furlong", "1 2"}) {
    EXPECT_FALSE(parse_length(text, LengthAxis::horizontal, context).has_value()) << text;
  }
}

TEST(SvgScanner, NumbersAreExactWhereDoublesAre) {
  EXPECT_EQ(SvgScanner("0.1").number().value(), 0.1);
  EXPECT_EQ(SvgScanner("123456.789e-2").number().value(), 1234.56789);
  EXPECT_EQ(SvgScanner("00000000000000000000000001").number().value(), 1);
  EXPECT_EQ(SvgScanner("1.0000000000000000000000000").number().value(), 1);
  EXPECT_TRUE(std::isinf(SvgScanner("1e9999").number().value()));
  EXPECT_EQ(SvgScanner("1e-9999").number().value(), 0);
  EXPECT_FALSE(SvgScanner(".").number().has_value());
  EXPECT_FALSE(SvgScanner("-").number().has_value());
}

void expect_color(const char* text, double r, double g, double b, double a = 255) {
  const auto color = parse_color(text);
  ASSERT_TRUE(color.has_value()) << text;
  EXPECT_NEAR(color->r * 255, r, 0.6) << text;
  EXPECT_NEAR(color->g * 255, g, 0.6) << text;
  EXPECT_NEAR(color->b * 255, b, 0.6) << text;
  EXPECT_NEAR(color->a * 255, a, 0.6) << text;
}

TEST(Color, EveryNotation) {
  expect_color("#f80", 255, 136, 0);
  expect_color("#FF8800", 255, 136, 0);
  expect_color("#ff880080", 255, 136, 0, 128);
  expect_color("rgb(255, 136, 0)", 255, 136, 0);
  expect_color("rgb(100% 50% 0%)", 255, 127.5, 0);
  expect_color("rgba(300,-5,0,.5)", 255, 0, 0, 127.5);
  expect_color("rgb(1 2 3 / 50%)", 1, 2, 3, 127.5);
  expect_color("hsl(120, 100%, 25%)", 0, 127.5, 0);
  expect_color("RebeccaPurple", 0x66, 0x33, 0x99);
  expect_color("aliceblue", 0xf0, 0xf8, 0xff);
  expect_color("yellowgreen", 0x9a, 0xcd, 0x32);
  expect_color("transparent", 0, 0, 0, 0);
  for (const char* text : {"", "#12", "#ggg", "rgb(1,2)", "nocolour", "url(#a)"}) {
    EXPECT_FALSE(parse_color(text).has_value()) << text;
  }
}

TEST(SvgViewBox, FitsAsPreserveAspectRatioSays) {
  const ViewBox box{10, 20, 100, 50};
  const auto maps = [&](const char* ratio, Point2 from, Point2 to) {
    const Point2 image = fit_view_box(box, 200, 200, ratio)(from);
    EXPECT_NEAR(image.x, to.x, 1e-12) << ratio;
    EXPECT_NEAR(image.y, to.y, 1e-12) << ratio;
  };
  maps("", {10, 20}, {0, 50});
  maps("xMidYMin", {10, 20}, {0, 0});
  maps("xMidYMax meet", {10, 20}, {0, 100});
  maps("none", {110, 70}, {200, 200});
  maps("xMinYMid slice", {10, 20}, {0, 0});
  maps("xMaxYMid slice", {110, 70}, {200, 200});
  maps("xMidYMid slice", {60, 45}, {100, 100});
  for (const char* text : {"", "0 0 10", "0 0 0 5", "0 0 -1 5", "0 0 1e999 1", "a b c d"}) {
    EXPECT_FALSE(parse_view_box(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace relievo
