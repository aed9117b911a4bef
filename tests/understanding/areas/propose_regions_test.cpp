#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/ink_drawing.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

TEST(ProposeRegions, ColoursInsideAnInkedOutlineAreTexture) {
  InkDrawing ball(240, 240);
  ball.disc({120, 120}, 80, 240, 200, 60).disc({120, 150}, 30, 60, 90, 200);
  ball.disc({120, 95}, 25, 60, 160, 80);
  const Result<Segmentation> bare = segment_drawing(ball.drawing());
  const Result<Segmentation> inked = segment_drawing(ball.circle({120, 120}, 80).drawing());
  ASSERT_TRUE(bare.ok() && inked.ok());
  EXPECT_GT(bare->parts.size(), 1U);
  EXPECT_EQ(inked->parts.size(), 1U);
}

/// A body on a leg in a boot of another colour. Dashes that cover a share of the border separate
/// the boot from the leg, and both halves of the body.
Drawing body_with_boot(double drawn) {
  Drawing drawing{Image8(300, 420, 4, 255)};
  const auto paint = [&](int x, int y, std::array<int, 3> colour) {
    for (int c = 0; c < 3; ++c) drawing.rgba.at(x, y, c) = static_cast<uint8_t>(colour[c]);
  };
  for (int y = 0; y < 420; ++y)
    for (int x = 0; x < 300; ++x) {
      const double r = distance({x + 0.5, y + 0.5}, {150, 140});
      const bool leg = y >= 140 && y < 356 && x >= 110 && x < 190;
      if (r <= 102)
        paint(x, y, x < 150 ? std::array{90, 130, 230} : std::array{230, 210, 90});
      else if (leg)
        paint(x, y, y < 330 ? std::array{240, 200, 170} : std::array{200, 60, 50});
      const bool rim = leg && (x < 114 || x >= 186 || y >= 352);
      const bool boot_line = leg && std::abs(y - 330) < 2 && (x - 110) % 20 < 20 * drawn;
      const bool body_line = r <= 100 && std::abs(x - 150) < 2 && y % 20 < 20 * drawn;
      if (std::abs(r - 100) < 2 || (r > 100 && (rim || boot_line)) || body_line)
        paint(x, y, {30, 30, 30});
    }
  return drawing;
}

TEST(ProposeRegions, SmallPiecesUniteMoreEasilyThanLargeOnes) {
  const Result<Segmentation> half = segment_drawing(body_with_boot(0.55));
  ASSERT_TRUE(half.ok()) << to_string(half.error());
  EXPECT_EQ(half->labels.at(150, 300), half->labels.at(150, 344)) << "leg and boot";
  EXPECT_NE(half->labels.at(100, 140), half->labels.at(200, 140)) << "both halves of the body";
  EXPECT_NE(half->labels.at(150, 300), half->labels.at(200, 140)) << "leg and body";
  const Result<Segmentation> whole = segment_drawing(body_with_boot(1));
  ASSERT_TRUE(whole.ok()) << to_string(whole.error());
  EXPECT_NE(whole->labels.at(150, 300), whole->labels.at(150, 344)) << "leg and boot";
}

/// A block that is brown on the left and yellow on the right and changes over `width` px in its
/// middle. A line separates both there except for a fifth at the top and at the bottom.
Drawing block_with_change(double width) {
  constexpr std::array<int, 3> umber = {140, 80, 30};
  constexpr std::array<int, 3> yellow = {240, 200, 60};
  Drawing drawing{Image8(400, 300, 4, 255)};
  for (int y = 60; y < 240; ++y)
    for (int x = 40; x < 360; ++x) {
      const double to_right = std::clamp(0.5 + (x + 0.5 - 200) / width, 0.0, 1.0);
      const bool line = std::abs(x + 0.5 - 200) < 3 && y >= 96 && y < 204;
      for (int c = 0; c < 3; ++c)
        drawing.rgba.at(x, y, c) =
            static_cast<uint8_t>(line ? 20 : umber[c] + to_right * (yellow[c] - umber[c]));
    }
  return drawing;
}

TEST(ProposeRegions, AreasThatDifferByShadingAloneAreOne) {
  const Result<Segmentation> shaded = segment_drawing(block_with_change(320));
  const Result<Segmentation> soft = segment_drawing(block_with_change(16));
  const Result<Segmentation> hard = segment_drawing(block_with_change(1));
  ASSERT_TRUE(shaded.ok() && soft.ok() && hard.ok());
  EXPECT_EQ(shaded->parts.size(), 1U);
  EXPECT_EQ(soft->parts.size(), 2U);
  EXPECT_EQ(hard->parts.size(), 2U);
}

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
