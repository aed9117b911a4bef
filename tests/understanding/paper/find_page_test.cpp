#include <gtest/gtest.h>

#include <array>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

Drawing page_with_snowman() {
  InkDrawing ink(300, 400);
  ink.arc({150, 120}, 70, 0.36, 1.14).arc({150, 260}, 100, 0, 1);
  return ink.drawing();
}

TEST(FindPage, TheTableAroundAPageIsNoPart) {
  const Drawing page = page_with_snowman();
  const Result<Segmentation> plain = segment_drawing(page);
  ASSERT_TRUE(plain.ok());
  const auto is_table = [](int x, int y, int kind) {
    if (kind == 0) return y < 10 + x / 30;  // a strip that thins out
    if (kind == 1) return x < 14 || y > 380;
    if (kind == 2) return x < 14 || y < 12 || x > 288 || y > 380;
    return x + y / 12 < 36 || y - x / 14 < 8 || x + y / 12 > 296 || y - x / 14 > 372;  // turned
  };
  for (const int kind : {0, 1, 2, 3})
    for (const std::array<uint8_t, 3> table :
         {std::array<uint8_t, 3>{40, 42, 45}, {150, 100, 60}}) {
      Drawing photo = page;
      for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 300; ++x)
          for (int c = 0; c < 3 && is_table(x, y, kind); ++c) photo.rgba.at(x, y, c) = table[c];
      const Result<Segmentation> s = segment_drawing(photo);
      ASSERT_TRUE(s.ok()) << to_string(s.error());
      EXPECT_EQ(s->parts.size(), plain->parts.size()) << kind << " " << int{table[0]};
      for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 300; ++x)
          if (is_table(x, y, kind)) {
            ASSERT_EQ(s->labels.at(x, y), 0) << x << ", " << y;
          }
      EXPECT_NE(s->labels.at(150, 140), s->labels.at(150, 260));
    }
}

/// A white body with corners is no page: paper lies around it.
TEST(FindPage, ABoxOnPaperIsAPart) {
  InkDrawing ink(300, 400);
  ink.line({20, 20}, {280, 20}).line({280, 20}, {280, 380});
  ink.line({280, 380}, {20, 380}).line({20, 380}, {20, 20});
  const Result<Segmentation> s = segment_drawing(ink.drawing());
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 1U);
  EXPECT_NE(s->labels.at(150, 200), 0);
  EXPECT_EQ(s->labels.at(5, 200), 0);
}

}  // namespace
}  // namespace relievo::understanding
