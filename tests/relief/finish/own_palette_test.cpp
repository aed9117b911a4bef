#include "relief/finish/own_palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "relief/finish/extend_paint.h"
#include "relief/finish/finish_model.h"
#include "relief/finish/model_texture.h"
#include "support/analytic_discs.h"
#include "support/model_checks.h"

namespace relievo::relief {
namespace {

constexpr int wide = 240;
constexpr int high = 180;
constexpr int own = 10;  // of the own pixels
const Disc lower_disc{{90, 90}, 60};
const Disc upper_disc{{120, 90}, 40, 1, 60};

using PaletteRgb = std::array<uint8_t, 3>;

constexpr std::array<PaletteRgb, 6> palette{
    {{200, 40, 40}, {40, 80, 200}, {250, 220, 60}, {40, 150, 70}, {30, 20, 30}, {255, 255, 255}}};

/// The discs in squares: the back one checked in two colours, the front one in two others, with an
/// outline, on white paper or none.
Drawing checked_discs(bool on_paper) {
  Drawing drawing{Image8(wide, high, 4), own};
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      const Point2 middle{own * (x / own + 0.5), own * (y / own + 0.5)};
      const int check = (x / own + y / own) % 2;
      int colour = on_paper ? 5 : -1;
      for (const Disc& disc : {lower_disc, upper_disc}) {
        const double r = distance(middle, disc.centre);
        if (r < disc.radius)
          colour = r > disc.radius - own ? 4 : check + (disc.radius < lower_disc.radius ? 2 : 0);
      }
      if (colour < 0) continue;
      std::copy(palette[colour].begin(), palette[colour].end(), &drawing.rgba.at(x, y));
      drawing.rgba.at(x, y, 3) = 255;
    }
  return drawing;
}

std::set<PaletteRgb> colours_of(const Image8& rgb) {
  std::set<PaletteRgb> found;
  for (size_t i = 0; i < rgb.pixels.size(); i += 3)
    found.insert({rgb.pixels[i], rgb.pixels[i + 1], rgb.pixels[i + 2]});
  return found;
}

TEST(OwnPalette, ATextureHasTheColoursOfTheDrawing) {
  const Model model =
      assemble(make_discs({lower_disc, upper_disc}, wide, high, 6), Visibility::orbit);
  const auto without_paper = [](std::set<PaletteRgb> found) {
    found.erase(palette[5]);
    return found;
  };
  const std::set<PaletteRgb> painted(palette.begin(), palette.begin() + 5);
  for (const bool on_paper : {false, true}) {
    const DrawnModel dressed = dress_hidden(model, checked_discs(on_paper));
    EXPECT_GT(dressed.drawing.rgba.height, high);  // there are hidden faces
    const std::set<PaletteRgb> found = colours_of(model_texture(dressed.model, dressed.drawing));
    EXPECT_EQ(without_paper(found), painted) << on_paper;
    EXPECT_TRUE(on_paper || found.count(palette[5]) == 0);
  }
}

TEST(OwnPalette, WholeSquaresAreCarriedOverTheOutline) {
  const Model model = assemble(make_discs({lower_disc}, wide, high, 6), Visibility::orbit);
  Drawing drawing = checked_discs(true);
  const Drawing before = drawing;
  extend_paint(model, drawing);
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      const Point2 middle{own * (x / own + 0.5), own * (y / own + 0.5)};
      for (int c = 0; c < 3; ++c) {
        ASSERT_EQ(drawing.rgba.at(x, y, c), drawing.rgba.at(x / own * own, y / own * own, c));
        if (distance(middle, lower_disc.centre) < lower_disc.radius - own) {
          ASSERT_EQ(drawing.rgba.at(x, y, c), before.rgba.at(x, y, c));
        }
      }
      // Beside the outline there is its ink, no paper.
      if (std::abs(distance(middle, lower_disc.centre) - lower_disc.radius - own) < 1 && x < 90) {
        ASSERT_EQ(drawing.rgba.at(x, y), palette[4][0]) << x << " " << y;
      }
    }
}

TEST(OwnPalette, KeepsTheNearestOfTheColoursSeen) {
  ImageF seen(3, 1, 4);
  seen.pixels = {10, 20, 30, 1, 200, 100, 0, 1, 90, 90, 90, 0};
  ImageF filled(2, 1, 3);
  filled.pixels = {90, 90, 90, 150, 90, 10};
  keep_palette(seen, filled);
  EXPECT_EQ(filled.pixels, (std::vector<float>{10, 20, 30, 200, 100, 0}));
}

}  // namespace
}  // namespace relievo::relief
