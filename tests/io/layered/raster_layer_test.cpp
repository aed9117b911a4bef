#include "io/layered/raster_layer.h"

#include <gtest/gtest.h>

#include "io/layered/layer_support.h"

namespace relievo {
namespace {

using Names = std::vector<std::string>;
constexpr double pi = 3.14159265358979323846;

TEST(RasterLayer, OutlinesAreExactToAFractionOfAPixel) {
  auto drawing = drawing_of(200, 200, {layer("body", disc(200, 200, {100.3, 99.6}, 60, red))});
  ASSERT_EQ(part_names(drawing), Names{"body"});
  const Part& body = drawing.scene.parts[0];
  EXPECT_NEAR(part_area(body), pi * 60 * 60, 0.003 * pi * 60 * 60);
  for (const Point2 p : body.outline[0]) EXPECT_NEAR(distance(p, {100.3, 99.6}), 60, 0.15);
}

TEST(RasterLayer, WhatStandsOutIsAPartAndWhatLiesInsideIsTexture) {
  auto drawing = drawing_of(300, 300,
                            {layer("body", disc(300, 300, {150, 180}, 90, red)),
                             layer("ear", disc(300, 300, {150, 80}, 40, blue)),
                             layer("spot", disc(300, 300, {170, 200}, 9, black))});
  EXPECT_EQ(part_names(drawing), (Names{"body", "ear"}));
  EXPECT_TRUE(drawing.proposed);
  EXPECT_EQ(drawing.picture.rgba.at(170, 200, 0), 0);
}

TEST(RasterLayer, ALineAroundAFillTellsThatItIsAPartOfItsOwn) {
  const auto proposed = [](bool outlined) {
    Image8 leg = disc(300, 300, {150, 170}, 50, outlined ? black : red);
    paint_disc(leg, {150, 170}, 46, {205, 50, 45, 255});
    auto drawing = drawing_of(
        300, 300, {layer("body", disc(300, 300, {150, 150}, 120, red)), layer("leg", leg)});
    return part_names(drawing);
  };
  EXPECT_EQ(proposed(true), (Names{"body", "leg"}));
  EXPECT_EQ(proposed(false), Names{"body"});
}

TEST(RasterLayer, RolesAreNotOverruled) {
  RasterLayer body = layer("body", disc(300, 300, {150, 150}, 120, red));
  body.role = LayerRole::texture;
  RasterLayer spot = layer("spot", disc(300, 300, {150, 150}, 12, blue));
  spot.role = LayerRole::part;
  spot.c = 2;
  spot.d = -1;
  auto drawing = drawing_of(300, 300, {body, spot});
  ASSERT_EQ(part_names(drawing), Names{"spot"});
  EXPECT_FALSE(drawing.proposed);
  EXPECT_EQ(drawing.scene.parts[0].c, 2);
  EXPECT_EQ(drawing.scene.parts[0].d, -1);
}

TEST(RasterLayer, LayersMoveAndAreCutAtTheCanvas) {
  RasterLayer sprite = layer("sprite", disc(80, 80, {40, 40}, 38, red));
  sprite.x = 60;
  sprite.y = -40;
  RasterLayer beside = sprite;
  beside.x = 2'000'000'000;
  const auto drawing = drawing_of(100, 100, {sprite, beside});
  ASSERT_EQ(drawing.marks.size(), 1u);
  const Box2 box = bounding_box(drawing.marks[0].region);
  EXPECT_NEAR(box.min.x, 62, 0.1);
  EXPECT_NEAR(box.max.x, 100, 1e-9);
  EXPECT_NEAR(box.min.y, 0, 1e-9);
  EXPECT_NEAR(box.max.y, 38, 0.1);
}

TEST(RasterLayer, PaintsAsStraightAlphaOver) {
  RasterLayer ground = layer("", transparent(2, 1));
  ground.rgba.pixels = {100, 0, 0, 255, 200, 100, 0, 128};
  RasterLayer top = layer("", transparent(2, 1));
  top.opacity = 0.5;
  top.rgba.pixels = {0, 200, 0, 255, 0, 0, 200, 128};
  const auto drawing = drawing_of(2, 1, {ground, top});
  const std::vector<uint8_t> half = {50, 100, 0, 255};
  EXPECT_TRUE(std::equal(half.begin(), half.end(), drawing.picture.rgba.pixels.begin()));
  // 64/255 over 128/255: alpha 0.251 + 0.502 * 0.749, colours by their shares of it.
  EXPECT_EQ(drawing.picture.rgba.at(1, 0, 3), 160);
  EXPECT_EQ(drawing.picture.rgba.at(1, 0, 0), 120);
  EXPECT_EQ(drawing.picture.rgba.at(1, 0, 2), 80);
}

TEST(RasterLayer, FaintLayersAndBackgroundsAreNoParts) {
  auto drawing = drawing_of(100, 100,
                            {layer("paper", Image8(100, 100, 4, 255)),
                             layer("shade", disc(100, 100, {50, 50}, 30, {0, 0, 0, 100}))});
  ASSERT_FALSE(drawing.flat);
  ASSERT_TRUE(understanding::make_parts(drawing));
  EXPECT_TRUE(drawing.flat);  // the picture may show parts where the layers are none
  EXPECT_TRUE(drawing.scene.parts.empty());
  auto faint = drawing_of(100, 100,
                          {layer("a", disc(100, 100, {50, 50}, 30, {0, 0, 0, 60})),
                           layer("b", disc(100, 100, {50, 50}, 9, {0, 0, 0, 50}))});
  const Status status = understanding::make_parts(faint);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::bad_input);
}

TEST(RasterLayer, LinesOverOneLayerOfColoursAreAFlatDrawing) {
  Image8 lines = disc(300, 300, {150, 150}, 92, black);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x)
      if (distance({x + 0.5, y + 0.5}, {150, 150}) < 88) lines.at(x, y, 3) = 0;
  auto drawing =
      drawing_of(300, 300,
                 {layer("paper", Image8(300, 300, 4, 255)),
                  layer("colours", disc(300, 300, {150, 150}, 90, red)), layer("lines", lines)});
  ASSERT_TRUE(understanding::make_parts(drawing));
  EXPECT_TRUE(drawing.flat);
}

}  // namespace
}  // namespace relievo
