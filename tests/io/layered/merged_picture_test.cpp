#include "io/layered/merged_picture.h"

#include <gtest/gtest.h>

#include "io/layered/layer_support.h"
#include "kernel/image/compose.h"

namespace relievo {
namespace {

understanding::LayeredDrawing two_discs() {
  return drawing_of(200, 200,
                    {layer("body", disc(200, 200, {100, 120}, 50, red)),
                     layer("head", disc(200, 200, {100, 50}, 30, blue))});
}

/// The two discs on white paper.
Image8 on_white(const Rgba& body, const Rgba& head) {
  Image8 paper(200, 200, 4, 255);
  lay_picture_over(paper, 0, 0, disc(200, 200, {100, 120}, 50, body));
  lay_picture_over(paper, 0, 0, disc(200, 200, {100, 50}, 30, head));
  return paper;
}

TEST(MergedPicture, IsNotTakenWhereItShowsTheSame) {
  auto drawing = two_discs();
  for (const Image8& merged : {drawing.picture.rgba, on_white(red, blue)}) {
    EXPECT_FALSE(compare_with_merged(drawing, merged));
    EXPECT_FALSE(drawing.flat);
    EXPECT_EQ(drawing.marks.size(), 2u);
    EXPECT_TRUE(drawing.warnings.empty());
  }
}

TEST(MergedPicture, IsTheDrawingWhereItShowsMore) {
  auto drawing = two_discs();
  Image8 merged = drawing.picture.rgba;
  paint_disc(merged, {170, 150}, 25, black);
  EXPECT_TRUE(compare_with_merged(drawing, merged));
  EXPECT_TRUE(drawing.flat);
  EXPECT_TRUE(drawing.marks.empty());
  EXPECT_EQ(drawing.picture.rgba.at(170, 150, 3), 255);
  ASSERT_EQ(drawing.warnings.size(), 1u);
  EXPECT_NE(drawing.warnings[0].find("merged"), std::string::npos);
}

TEST(MergedPicture, GivesItsColoursWhereOnlyTheseDiffer) {
  auto drawing = two_discs();
  EXPECT_TRUE(compare_with_merged(drawing, on_white({40, 200, 40, 255}, blue)));
  EXPECT_FALSE(drawing.flat);
  EXPECT_EQ(drawing.marks.size(), 2u);
  EXPECT_EQ(drawing.picture.rgba.at(100, 130, 1), 200);
  EXPECT_EQ(drawing.picture.rgba.at(2, 2, 3), 0);  // no paper
  EXPECT_EQ(drawing.warnings.size(), 1u);
}

TEST(MergedPicture, IsBlankWhereAProgramStoredNone) {
  EXPECT_TRUE(is_blank(Image8(9, 9, 4, 255)));
  EXPECT_TRUE(is_blank(Image8(9, 9, 4)));
  EXPECT_FALSE(is_blank(disc(9, 9, {4, 4}, 2, red)));
}

}  // namespace
}  // namespace relievo
