#include "relief/finish/model_texture.h"

#include <gtest/gtest.h>

#include "support/sample_models.h"

namespace relievo::relief {
namespace {

/// A transparent canvas of 100 x 100 px with a black ring, as a pencil would leave it.
Drawing ring(double inner, double outer) {
  Drawing drawing{Image8(100, 100, 4, 0)};
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const double r = distance({x + 0.5, y + 0.5}, {50, 50});
      if (r > inner && r < outer) drawing.rgba.at(x, y, 3) = 255;
    }
  return drawing;
}

TEST(ModelTexture, UnpaintedInsideIsPaperAndSilhouetteKeepsItsLine) {
  const Model model = hemisphere(40);
  const Image8 texture = model_texture(model, ring(37, 40));
  ASSERT_EQ(texture.channels, 3);
  EXPECT_EQ(texture.at(50, 50), 255);
  for (int x = 0; x < 13; ++x) EXPECT_EQ(texture.at(x, 50), 0) << x;
  EXPECT_EQ(texture.at(0, 0), 0);
}

TEST(ModelTexture, LineThatStopsShortOfTheSilhouetteLeavesPaper) {
  const Image8 texture = model_texture(hemisphere(40), ring(20, 25));
  for (int x = 0; x < 20; ++x) EXPECT_EQ(texture.at(x, 50), 255) << x;
}

TEST(ModelTexture, HalfTransparentPaintMixesWithPaper) {
  Drawing drawing{Image8(100, 100, 4, 0)};
  drawing.rgba.at(50, 50, 0) = 200;
  drawing.rgba.at(50, 50, 3) = 51;
  const Image8 texture = model_texture(hemisphere(40), drawing);
  EXPECT_EQ(texture.at(50, 50, 0), 244);
  EXPECT_EQ(texture.at(50, 50, 1), 204);
}

TEST(ModelTexture, OpaqueDrawingStaysAsItIs) {
  const Drawing drawing = quarters();
  const Image8 texture = model_texture(hemisphere(40), drawing);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (int c = 0; c < 3; ++c) ASSERT_EQ(texture.at(x, y, c), drawing.rgba.at(x, y, c));
}

TEST(ModelTexture, NoDrawingGivesNone) { EXPECT_TRUE(model_texture(hemisphere(40), {}).empty()); }

}  // namespace
}  // namespace relievo::relief
