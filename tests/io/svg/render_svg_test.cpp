#include "io/svg/render_svg.h"

#include <gtest/gtest.h>

#include "io/svg/coverage.h"
#include "io/svg/svg_test_support.h"

namespace relievo {
namespace {

Image8 pixels(const std::string& file, int width = 100, int height = 100) {
  auto drawing = painted_svg(file, width, height);
  EXPECT_TRUE(drawing.ok()) << (drawing ? "" : to_string(drawing.error()));
  return drawing ? std::move(drawing->rgba) : Image8(width, height, 4);
}

TEST(RenderSvg, StraightAlphaOnATransparentGround) {
  const Image8 image =
      pixels(svg_file("<rect width='500' height='1000' fill='#ff8000' "
                      "fill-opacity='.25'/>"));
  EXPECT_NEAR(image.at(10, 10, 0), 255, 2);
  EXPECT_NEAR(image.at(10, 10, 1), 128, 3);
  EXPECT_NEAR(image.at(10, 10, 2), 0, 2);
  EXPECT_NEAR(image.at(10, 10, 3), 64, 1);
  EXPECT_EQ(image.at(80, 10, 3), 0);
}

TEST(RenderSvg, AgreesWithTheGeometryWhateverTheSizeAndRatio) {
  for (const char* root : {"width='300' height='600'", "viewBox='0 0 100 200'", "id='none'",
                           "viewBox='-5 3 80 90' width='50mm' height='120mm'",
                           "viewBox='0 0 80 90' preserveAspectRatio='none' width='7in'"}) {
    const std::string file = svg_file(
        "<path d='M10 10L70 20L40 80z'/><circle cx='60' cy='75' "
        "r='9'/>",
        root);
    const understanding::LayeredDrawing import = import_of(file);
    const Drawing drawing{pixels(file, 640, 400)};
    EXPECT_GT(silhouette_agreement(import.scene, drawing), 0.99) << root;
  }
}

TEST(RenderSvg, JoinsAndIgnoredElementsAreNotPainted) {
  const std::string join = "<path d='M300 100V190' fill='none' stroke='#00f' stroke-width='20' ";
  const std::string parts =
      "<g id='a' data-relievo='part'><rect width='400' height='400' fill='red'/></g>"
      "<g id='b' data-relievo='part'><rect x='300' y='100' width='300' height='90' fill='red'/>";
  for (const char* mark : {"class='join'", "data-relievo='ignore'"}) {
    const Image8 image = pixels(svg_file(parts + join + mark + "/></g>"));
    EXPECT_EQ(image.at(30, 15, 0), 255) << mark;
    EXPECT_EQ(image.at(30, 15, 2), 0) << mark;
  }
  EXPECT_EQ(pixels(svg_file(parts + join + "/></g>")).at(30, 15, 2), 255);
}

TEST(Coverage, AgreementIsIntersectionOverUnion) {
  Scene scene;
  scene.width = 10;
  scene.height = 10;
  Drawing drawing{Image8(100, 100, 4)};
  EXPECT_EQ(silhouette_agreement(scene, drawing), 1);
  scene.parts.push_back(
      {"a", {{{0, 0}, {6, 0}, {6, 10}, {0, 10}}, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}}});
  for (int y = 0; y < 100; ++y) {
    for (int x = 30; x < 100; ++x) drawing.rgba.at(x, y, 3) = 255;
  }
  const double both = 3000 - 200;
  EXPECT_DOUBLE_EQ(silhouette_agreement(scene, drawing), both / (7000 + 6000 - 400 - both));
}

}  // namespace
}  // namespace relievo
