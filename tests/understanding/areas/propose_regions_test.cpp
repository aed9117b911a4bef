#include <gtest/gtest.h>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

TEST(ProposeRegions, AScarfOfManyStripesIsNotManyParts) {
  InkDrawing figure(600, 400);
  figure.circle({160, 200}, 120).circle({160, 160}, 20);
  for (int k = 0; k < 26; ++k) figure.line({300.0 + 10 * k, 180}, {300.0 + 10 * k, 220}, 2);
  figure.line({280, 180}, {560, 180}, 2).line({280, 220}, {560, 220}, 2);
  figure.line({280, 180}, {280, 220}, 2).line({560, 180}, {560, 220}, 2);
  const Result<Segmentation> s = segment_drawing(figure.drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_LE(s->parts.size(), 20U);
  for (int k = 0; k < 27; ++k) EXPECT_NE(s->labels.at(295 + 10 * k, 200), 0) << k;
}

}  // namespace
}  // namespace relievo::understanding
