#include "kernel/image/blend.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace relievo {
namespace {

using Pixel = std::array<uint8_t, 4>;

Pixel laid(Pixel below, Pixel above, Blending blending, double opacity = 1) {
  blend_over(below.data(), above.data(), opacity, blending);
  return below;
}

Pixel laid(Pixel below, Pixel above, BlendMode mode, double opacity = 1) {
  return laid(below, above, {mode, CoverMode::over}, opacity);
}

void expect_near(const Pixel& pixel, const Pixel& wanted, const std::string& what) {
  for (size_t k = 0; k < 4; ++k) EXPECT_NEAR(pixel[k], wanted[k], 1) << what << ", channel " << k;
}

TEST(Blend, ModesGiveTheValuesOfTheirFormulas) {
  // On 0.2, 0.5 and 0.8 lies 0.25.
  const Rgb below = {0.2, 0.5, 0.8};
  const Rgb above = {0.25, 0.25, 0.25};
  const auto expect = [&](BlendMode mode, const Rgb& wanted) {
    const Rgb result = blend(mode, below, above);
    for (size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(result[k], wanted[k], 1e-9) << static_cast<int>(mode) << ", channel " << k;
  };
  expect(BlendMode::normal, {0.25, 0.25, 0.25});
  expect(BlendMode::multiply, {0.05, 0.125, 0.2});
  expect(BlendMode::screen, {0.4, 0.625, 0.85});
  expect(BlendMode::overlay, {0.1, 0.25, 0.7});
  expect(BlendMode::darken, {0.2, 0.25, 0.25});
  expect(BlendMode::lighten, {0.25, 0.5, 0.8});
  expect(BlendMode::color_dodge, {0.8 / 3, 2.0 / 3, 1});
  expect(BlendMode::color_burn, {0, 0, 0.2});
  expect(BlendMode::hard_light, {0.1, 0.25, 0.4});
  expect(BlendMode::soft_light, {0.12, 0.375, 0.72});
  expect(BlendMode::difference, {0.05, 0.25, 0.55});
  expect(BlendMode::exclusion, {0.35, 0.5, 0.65});
  expect(BlendMode::add, {0.45, 0.75, 1});
  expect(BlendMode::linear_burn, {0, 0, 0.05});
  expect(BlendMode::subtract, {0, 0.25, 0.55});
  expect(BlendMode::divide, {0.8, 1, 1});
  expect(BlendMode::vivid_light, {0, 0, 0.6});
  expect(BlendMode::linear_light, {0, 0, 0.3});
  expect(BlendMode::pin_light, {0.2, 0.5, 0.5});
}

TEST(Blend, SoftLightBrightensByTheRootOfWhatIsNotDark) {
  // 0.5 + (2 * 0.75 - 1) * (sqrt(0.5) - 0.5), and ((16 * 0.1 - 12) * 0.1 + 4) * 0.1 = 0.296
  const Rgb result = blend(BlendMode::soft_light, {0.5, 0.1, 0}, {0.75, 0.75, 0.75});
  EXPECT_NEAR(result[0], 0.5 + 0.5 * (std::sqrt(0.5) - 0.5), 1e-9);
  EXPECT_NEAR(result[1], 0.1 + 0.5 * (0.296 - 0.1), 1e-9);
  EXPECT_EQ(result[2], 0);
}

TEST(Blend, HueSaturationAndColourKeepTheLightBelow) {
  const auto light = [](const Rgb& c) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; };
  const auto range = [](const Rgb& c) {
    return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]});
  };
  const Rgb below = {0.5, 0.4, 0.3};
  const Rgb above = {0.2, 0.3, 0.9};
  for (const BlendMode mode : {BlendMode::hue, BlendMode::saturation, BlendMode::color})
    EXPECT_NEAR(light(blend(mode, below, above)), light(below), 1e-9);
  EXPECT_NEAR(light(blend(BlendMode::luminosity, below, above)), light(above), 1e-9);
  const Rgb hue = blend(BlendMode::hue, below, above);
  EXPECT_NEAR(range(hue), range(below), 1e-9);
  EXPECT_NEAR((hue[1] - hue[0]) / range(hue), 0.1 / 0.7, 1e-9);
  EXPECT_NEAR(range(blend(BlendMode::luminosity, below, above)), range(below), 1e-9);
  // A bright blue cannot be as light as a pale yellow: it is moved towards grey.
  for (const double v : blend(BlendMode::color, {1, 1, 0.7}, {0, 0, 1})) {
    EXPECT_GE(v, -1e-9);
    EXPECT_LE(v, 1 + 1e-9);
  }
}

TEST(Blend, AlphaMixesWhatLiesBelowWithTheBlend) {
  // multiply of 100 on 200 is 78.4; half of it over 200 is 139.2
  expect_near(laid({200, 200, 200, 255}, {100, 100, 100, 255}, BlendMode::multiply, 0.5),
              {139, 139, 139, 255}, "half");
  // Half of the pixel below is empty: (0.5 * 78.4 + 0.5 * black of (1 - 100 / 255)) / alpha
  const double alpha = 0.5 + 0.5 * (1 - 100 / 255.0);
  const double colour = 0.5 * 78.4 / alpha;
  expect_near(laid({200, 200, 200, 128}, {100, 100, 100, 255}, BlendMode::multiply),
              {static_cast<uint8_t>(colour), static_cast<uint8_t>(colour),
               static_cast<uint8_t>(colour), static_cast<uint8_t>(255 * alpha)},
              "rim");
}

TEST(Blend, ASheetOfInkHidesNothingAndFillsNothing) {
  const Pixel nothing = {0, 0, 0, 0};
  expect_near(laid({10, 120, 230, 255}, {255, 255, 255, 255}, BlendMode::multiply),
              {10, 120, 230, 255}, "white on paint");
  EXPECT_EQ(laid(nothing, {255, 255, 255, 255}, BlendMode::multiply)[3], 0);
  EXPECT_EQ(laid(nothing, {0, 0, 0, 255}, BlendMode::screen)[3], 0);
  expect_near(laid(nothing, {0, 0, 0, 255}, BlendMode::multiply), {0, 0, 0, 255}, "ink");
  // Red ink on white paper, seen on white: the same as the sheet itself.
  const Pixel red = laid(nothing, {200, 100, 50, 255}, BlendMode::multiply);
  for (size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(red[k] * red[3] / 255.0 + 255 - red[3], (std::array{200, 100, 50}[k]), 1.5);
  const uint8_t grey[] = {200, 200, 200, 255};
  EXPECT_NEAR(alpha_alone(grey, BlendMode::multiply), 55, 1e-9);
  EXPECT_NEAR(alpha_alone(grey, BlendMode::screen), 200, 1e-9);
  EXPECT_NEAR(alpha_alone(grey, BlendMode::overlay), 255, 1e-9);
}

TEST(Blend, CoverModesKeepWhatPorterAndDuffSay) {
  const Pixel below = {200, 0, 0, 204};  // alpha 0.8
  const Pixel above = {0, 0, 200, 102};  // alpha 0.4
  const auto with = [&](CoverMode cover) { return laid(below, above, {BlendMode::normal, cover}); };
  expect_near(with(CoverMode::over), {109, 0, 91, 224}, "over");  // 0.4 + 0.8 * 0.6
  expect_near(with(CoverMode::atop), {120, 0, 80, 204}, "atop");
  expect_near(with(CoverMode::source_in), {0, 0, 200, 82}, "source in");
  expect_near(with(CoverMode::below_in), {200, 0, 0, 82}, "below in");
  expect_near(with(CoverMode::below_out), {200, 0, 0, 122}, "below out");
  expect_near(with(CoverMode::below_atop), {160, 0, 40, 102}, "below atop");
}

}  // namespace
}  // namespace relievo
