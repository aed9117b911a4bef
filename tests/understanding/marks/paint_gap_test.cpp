#include "understanding/marks/paint_gap.h"

#include <gtest/gtest.h>

#include <utility>

namespace relievo::understanding {
namespace {

Mark square(double left, double top, double side) {
  Mark mark;
  mark.region = {{{left, top}, {left + side, top}, {left + side, top + side}, {left, top + side}}};
  return mark;
}

/// A canvas of 40 x 40 px, and a painting of half its size that is opaque in columns [left, right)
/// and in all rows.
struct PaintGaps : ::testing::Test {
  LayeredDrawing drawing;

  PaintGaps() { drawing.scene.width = drawing.scene.height = 40; }

  PaintGap gap(int left, int right) const {
    Image8 painting(20, 20, 4);
    for (int y = 0; y < 20; ++y)
      for (int x = left; x < right; ++x) painting.at(x, y, 3) = 255;
    return find_paint_gap(drawing, painting);
  }
};

TEST_F(PaintGaps, AreNoneWhereAllIsPaintedAndRead) {
  drawing.marks = {square(0, 0, 40)};
  EXPECT_EQ(gap(0, 20).bare, 0);
  EXPECT_EQ(gap(0, 20).loose, 0);
}

TEST_F(PaintGaps, AreTheShareOfTheMarkWithTheLeastPaint) {
  drawing.marks = {square(0, 0, 40), square(20, 20, 20)};
  EXPECT_DOUBLE_EQ(gap(0, 15).bare, 0.5) << "a quarter of the first, half of the second";
  EXPECT_EQ(gap(0, 15).loose, 0);
}

TEST_F(PaintGaps, AreTheShareOfThePaintThatIsInNoMark) {
  drawing.marks = {square(0, 0, 20)};
  EXPECT_EQ(gap(0, 10).bare, 0);
  EXPECT_DOUBLE_EQ(gap(0, 10).loose, 0.45) << "a row of the rest lies beside the mark";
  drawing.scene.parts = {{"below", square(0, 20, 20).region}};
  EXPECT_EQ(gap(0, 10).loose, 0) << "declared parts count too";
  drawing.left_out = std::exchange(drawing.scene.parts, {})[0].outline;
  EXPECT_EQ(gap(0, 10).loose, 0) << "and what is left out with a word";
}

TEST_F(PaintGaps, LeaveOutWhatNeedsNoPaint) {
  drawing.marks = {square(20, 0, 20), square(0, 0, 40), square(38, 0, 1)};
  drawing.marks[0].blends = true;
  drawing.marks[1].blurred = true;
  EXPECT_EQ(gap(0, 10).bare, 0);
  EXPECT_EQ(gap(0, 10).loose, 0);
}

}  // namespace
}  // namespace relievo::understanding
