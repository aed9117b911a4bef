#include <gtest/gtest.h>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

/// A brown body on two legs whose feet are `gap` px apart.
InkDrawing standing(double gap) {
  InkDrawing figure(400, 400);
  figure.disc({200, 120}, 80, 150, 100, 60);
  for (const double toward : {-1.0, 1.0}) {
    for (double y = 180; y < 310; y += 4) figure.disc({200 + toward * 35, y}, 14, 150, 100, 60);
    figure.disc({200 + toward * (28 + gap / 2), 320}, 28, 60, 60, 160);
  }
  return figure;
}

/// A brown disc of radius 120 with a white one in it, open to the page through a slit of 4 px.
InkDrawing letter_c(double inner) {
  InkDrawing figure(400, 400);
  figure.disc({200, 200}, 120, 150, 100, 60).disc({200, 200}, inner, 255, 255, 255);
  for (double x = 200 + inner - 2; x < 324; ++x) figure.disc({x, 200}, 2, 255, 255, 255);
  return figure;
}

int label_at(const InkDrawing& figure, int x, int y) {
  const Result<Segmentation> s = segment_drawing(figure.drawing());
  EXPECT_TRUE(s.ok()) << to_string(s.error());
  return s.ok() ? s->labels.at(x, y) : -1;
}

TEST(Slits, BetweenFeetOpenTheGapBetweenLegs) {
  for (const double gap : {3, 4, 8, 20}) {
    EXPECT_EQ(label_at(standing(gap), 200, 250), 0) << gap << " px";
    EXPECT_NE(label_at(standing(gap), 165, 250), 0) << "a leg, " << gap << " px";
  }
}

TEST(Slits, AreIgnoredInGrainyPaint) {
  InkDrawing figure = letter_c(40);
  for (double y = 80; y < 320; y += 9)
    for (double x = 80; x < 320; x += 9)
      if (distance({x, y}, {200, 200}) < 115) figure.disc({x, y}, 1.5, 255, 255, 255);
  EXPECT_NE(label_at(figure, 200, 200), 0);
}

TEST(Slits, AreNoGapsInALineAroundSomethingWhite) {
  // A white muzzle beyond the rim of a brown head; its outline has a gap of 3 px.
  InkDrawing figure(400, 400);
  figure.disc({160, 200}, 110, 150, 100, 60).disc({275, 200}, 40, 255, 255, 255);
  figure.arc({275, 200}, 40, 0.014, 0.986);
  EXPECT_NE(label_at(figure, 290, 200), 0);
}

}  // namespace
}  // namespace relievo::understanding
