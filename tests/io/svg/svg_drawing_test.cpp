#include "io/svg/svg_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/svg/svg_test_support.h"

namespace relievo {
namespace {

using std::numbers::pi;

double area_of(const std::string& content) { return area(fill_of_only_shape(content)); }

void expect_box(const Region& region, Point2 min, Point2 max) {
  const Box2 box = bounding_box(region);
  EXPECT_NEAR(box.min.x, min.x, 0.01);
  EXPECT_NEAR(box.min.y, min.y, 0.01);
  EXPECT_NEAR(box.max.x, max.x, 0.01);
  EXPECT_NEAR(box.max.y, max.y, 0.01);
}

size_t shapes_in(const std::string& content) { return drawing_of(svg_file(content)).shapes.size(); }

TEST(SvgDrawing, BasicShapesHaveTheirArea) {
  EXPECT_NEAR(area_of("<rect x='10' y='20' width='300' height='200'/>"), 60000, 1e-6);
  EXPECT_NEAR(area_of("<rect width='300' height='200' rx='40' ry='30'/>"),
              60000 - (4 - pi) * 40 * 30, 40);
  EXPECT_NEAR(area_of("<rect width='300' height='200' rx='999'/>"), pi * 150 * 100, 60);
  EXPECT_NEAR(area_of("<circle cx='500' cy='500' r='100'/>"), pi * 1e4, 60);
  EXPECT_NEAR(area_of("<ellipse cx='500' cy='500' rx='200' ry='100'/>"), pi * 2e4, 90);
  EXPECT_NEAR(area_of("<polygon points='0,0 100,0 100 100'/>"), 5000, 1e-6);
  EXPECT_NEAR(area_of("<polyline points='0,0 100,0 100 100 7'/>"), 5000, 1e-6);
  EXPECT_NEAR(area_of("<path d='M0 0H100V100Z'/>"), 5000, 1e-6);
}

TEST(SvgDrawing, DisabledShapesAreAbsent) {
  for (const char* shape : {"<rect width='0' height='9'/>", "<circle r='-1'/>", "<ellipse rx='0'/>",
                            "<polygon points='1'/>", "<path d=''/>", "<rect width='9'/>"}) {
    EXPECT_EQ(shapes_in(shape), 0u) << shape;
  }
}

TEST(SvgDrawing, TransformsNest) {
  const Region region = fill_of_only_shape(
      "<g transform='translate(100 0)'><g transform='scale(2)'>"
      "<rect x='10' y='10' width='20' height='30' transform='rotate(90 20 25)'/></g></g>");
  expect_box(region, {110, 30}, {170, 70});
}

TEST(SvgDrawing, RootViewBoxAndUnitsMapToTheCanvas) {
  const SvgDrawing drawing =
      drawing_of(svg_file("<rect x='-10' y='-10' width='50%' height='10'/>",
                          "width='10in' height='480' viewBox='-10 -10 100 100'"));
  EXPECT_DOUBLE_EQ(drawing.width, 960);
  EXPECT_DOUBLE_EQ(drawing.height, 480);
  expect_box(fill_of(drawing.shapes.at(0), drawing), {240, 0}, {480, 48});
}

TEST(SvgDrawing, SmallAndLargeCanvasesAreScaled) {
  const auto size = [](const std::string& attributes) {
    const SvgDrawing d = drawing_of(svg_file("<rect width='30' height='30'/>", attributes));
    return Point2{std::round(1e6 * d.width) / 1e6, std::round(1e6 * d.height) / 1e6};
  };
  EXPECT_EQ(size("viewBox='0 0 36 18'"), (Point2{1000, 500}));
  EXPECT_EQ(size("width='100%' height='100%' viewBox='0 0 36 18'"), (Point2{1000, 500}));
  EXPECT_EQ(size("width='50000' height='25000'"), (Point2{1000, 500}));
  EXPECT_EQ(size("width='800' height='600'"), (Point2{800, 600}));
  EXPECT_EQ(size("width='800' viewBox='0 0 4 2'"), (Point2{800, 400}));
  EXPECT_EQ(size("id='x'"), (Point2{1000, 1000}));
}

TEST(SvgDrawing, NestedViewportsFitAndClip) {
  const std::string content =
      "<svg x='100' y='200' width='200' height='100' viewBox='0 0 10 10'>"
      "<rect x='-5' y='5' width='100' height='100'/></svg>";
  expect_box(fill_of_only_shape(content), {100, 250}, {300, 300});
}

TEST(SvgDrawing, UseAndSymbolPlaceWhatTheyReferTo) {
  expect_box(fill_of_only_shape("<defs><rect id='r' width='10' height='20'/></defs>"
                                "<use xlink:href='#r' x='30' y='40' transform='scale(2)'/>"),
             {60, 80}, {80, 120});
  expect_box(fill_of_only_shape("<symbol id='s' viewBox='0 0 1 1'><rect width='1' height='1'/>"
                                "</symbol><use href='#s' x='5' y='6' width='100' height='100'/>"),
             {5, 6}, {105, 106});
}

TEST(SvgDrawing, NothingIsDrawnFromDefinitionsOrUnknownElements) {
  EXPECT_EQ(shapes_in("<defs><rect width='9' height='9'/></defs><clipPath id='c'><rect width='9' "
                      "height='9'/></clipPath><pattern><rect width='9' height='9'/></pattern>"
                      "<metadata><rect width='9' height='9'/></metadata>"),
            0u);
  EXPECT_EQ(shapes_in("<g display='none'><rect width='9' height='9'/></g>"), 0u);
  EXPECT_EQ(shapes_in("<g visibility='hidden'><rect width='9' height='9'/>"
                      "<rect width='9' height='9' style='visibility:visible'/></g>"),
            1u);
}

TEST(SvgDrawing, SwitchTakesTheFirstThatApplies) {
  const SvgDrawing drawing = drawing_of(
      svg_file("<switch><text>x</text><rect id='a' systemLanguage='xx' width='9' height='9'/>"
               "<rect id='b' width='9' height='9'/><rect id='c' width='9' height='9'/></switch>"));
  ASSERT_EQ(drawing.shapes.size(), 1u);
  EXPECT_EQ(drawing.shapes[0].name, "b");
}

TEST(SvgDrawing, OpacitiesMultiply) {
  const SvgDrawing drawing =
      drawing_of(svg_file("<g opacity='.5'><rect width='9' height='9' fill-opacity='50%' "
                          "stroke='#00000080' opacity='.5'/></g>"));
  EXPECT_NEAR(drawing.shapes.at(0).fill->a, 0.125, 1e-12);
  EXPECT_NEAR(drawing.shapes.at(0).stroke->a, 0.25 * 128 / 255, 1e-12);
}

TEST(SvgDrawing, ClipPathsCut) {
  const std::string clip =
      "<clipPath id='c' transform='translate(10 0)'><rect width='50' height='50'/>"
      "<circle cx='500' cy='500' r='1'/></clipPath>";
  expect_box(
      fill_of_only_shape(clip + "<g clip-path='url(#c)'><rect width='400' height='20'/></g>"),
      {10, 0}, {60, 20});
}

TEST(SvgDrawing, StrokeWidthScalesWithTheShape) {
  const SvgDrawing drawing = drawing_of(
      svg_file("<g transform='scale(2 8)'><path d='M0 0L9 9' stroke='red' stroke-width='3'/></g>"));
  EXPECT_NEAR(drawing.shapes.at(0).pen.width, 12, 1e-12);
}

TEST(SvgDrawing, ShapesThatAreNotFiniteAreLeftOutAndNamed) {
  const SvgDrawing drawing =
      drawing_of(svg_file("<path id='wild' d='M0 0L1e400 5 9 9z'/><rect width='9' height='9'/>"));
  EXPECT_EQ(drawing.shapes.size(), 1u);
  ASSERT_EQ(drawing.warnings.size(), 1u);
  EXPECT_NE(drawing.warnings[0].find("wild"), std::string::npos);
}

}  // namespace
}  // namespace relievo
