#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "kernel/geometry/polygon.h"
#include "relief/finish/finish_model.h"
#include "relief/finish/hidden_patches.h"
#include "support/analytic_discs.h"
#include "support/model_checks.h"

namespace relievo::relief {
namespace {

constexpr int width = 240;
constexpr int height = 180;
const Disc back{{90, 90}, 60};
const Disc front{{120, 90}, 40, 1, 60};

using Rgb = std::array<double, 3>;
constexpr Rgb brown = {160, 100, 50};

/// The discs as the front view shows them: the back one blue, the other red, both inked in black.
Drawing drawn_discs() {
  Drawing drawing{Image8(width, height, 4)};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const Disc& disc : {back, front}) {
        const double r = distance({x + 0.5, y + 0.5}, disc.centre);
        if (r > disc.radius + 1) continue;
        uint8_t* rgba = &drawing.rgba.at(x, y);
        const bool ink = r > disc.radius - 2;
        const bool blue = disc.radius == back.radius;
        rgba[0] = !ink && !blue ? 220 : 0;
        rgba[1] = 0;
        rgba[2] = !ink && blue ? 200 : 0;
        rgba[3] = 255;
      }
  return drawing;
}

/// The pixel of a picture at texture coordinates.
const uint8_t* pixel_at(const Drawing& drawing, Point2 uv) {
  const Image8& rgba = drawing.rgba;
  return &rgba.at(static_cast<int>(uv.x * rgba.width), static_cast<int>(uv.y * rgba.height));
}

std::vector<std::array<int, 3>> hidden_triangles(const Model& model, int part) {
  const ModelPart& run = model.parts[part];
  const auto end = model.triangles.begin() + run.first_triangle + run.triangle_count;
  return {end - run.hidden_count, end};
}

TEST(Hidden, IsWhatLiesBehindAnotherPart) {
  // The front disc inside the back one, well above it.
  const DiscRelief relief = make_discs({back, {{90, 90}, 30, 1, 80}}, width, height, 6);
  const Model model = assemble(relief, Visibility::orbit);
  const double covered = std::abs(signed_area(relief.scene.parts[1].outline[0]));
  EXPECT_NEAR(front_area(model, hidden_triangles(model, 0)), covered, 1e-9 * covered);
  EXPECT_EQ(model.parts[1].hidden_count, 0);
}

TEST(Hidden, NothingWhereOnlyTheFrontIsKept) {
  const DiscRelief relief = make_discs({back, front}, width, height, 6);
  const Model model = assemble(relief, Visibility::relief);
  const Drawing drawing = drawn_discs();
  const DrawnModel dressed = dress_hidden(model, drawing);
  EXPECT_TRUE(dressed.model.uvs == model.uvs);
  EXPECT_EQ(dressed.drawing.rgba.height, drawing.rgba.height);
}

TEST(Hidden, PaperBesideTheInkDoesNotShow) {
  const Model model = assemble(make_discs({back}, width, height, 6), Visibility::orbit);
  // The outline's ink blends into white paper over the last two pixels.
  Drawing drawing = drawn_discs();
  const auto radius = [](int x, int y) { return distance({x + 0.5, y + 0.5}, back.centre); };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (radius(x, y) > back.radius - 1.4)
        for (int c = 0; c < 4; ++c)
          drawing.rgba.at(x, y, c) = radius(x, y) > back.radius - 0.5 ? 255 : 120;
  const Drawing dressed = dress_hidden(model, drawing).drawing;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 78; ++x) {
      const double r = radius(x, y);
      if (r < back.radius - 3) {
        EXPECT_EQ(dressed.rgba.at(x, y, 2), drawing.rgba.at(x, y, 2));
      } else if (r < back.radius + 1.5) {
        EXPECT_LT(dressed.rgba.at(x, y, 0), 60) << x << " " << y;
      } else if (r > back.radius + 6) {
        EXPECT_EQ(dressed.rgba.at(x, y, 0), drawing.rgba.at(x, y, 0));
      }
    }
}

TEST(Hidden, ADarkGroundBesideThePaintDoesNotShow) {
  const Model model = assemble(make_discs({back}, width, height, 6), Visibility::orbit);
  // Paint without ink on black, into which it blends over the last pixel.
  Drawing drawing{Image8(width, height, 4, 255)};
  const auto radius = [](int x, int y) { return distance({x + 0.5, y + 0.5}, back.centre); };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double paint = std::clamp(back.radius - 0.5 - radius(x, y), 0.0, 1.0);
      for (int c = 0; c < 3; ++c)
        drawing.rgba.at(x, y, c) = static_cast<uint8_t>(paint * (c == 0 ? 230 : 120));
    }
  const Drawing dressed = dress_hidden(model, drawing).drawing;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (radius(x, y) < back.radius + 1.5) {
        EXPECT_EQ(dressed.rgba.at(x, y, 0), 230) << x << " " << y;
      } else if (radius(x, y) > back.radius + 6) {
        EXPECT_EQ(dressed.rgba.at(x, y, 0), 0);
      }
    }
}

/// Green paper, the darker the farther to the right.
Rgb green_paper(int x) {
  const double light = 1 - 0.4 * x / width;
  return {light * 150, light * 210, light * 120};
}

/// The back disc on that paper, painted where `paint` says how much of a pixel is.
template <class Paint>
Drawing brown_on_green(Paint paint) {
  Drawing drawing{Image8(width, height, 4, 255)};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double share = paint(x, y);
      for (size_t c = 0; c < 3; ++c)
        drawing.rgba.at(x, y, static_cast<int>(c)) =
            static_cast<uint8_t>(share * brown[c] + (1 - share) * green_paper(x)[c]);
    }
  return drawing;
}

double from_centre(int x, int y) { return distance({x + 0.5, y + 0.5}, back.centre); }

/// How far a pixel is from the brown, the sum of all channels.
double off_brown(const Image8& rgba, int x, int y) {
  double sum = 0;
  for (size_t c = 0; c < 3; ++c) sum += std::abs(rgba.at(x, y, static_cast<int>(c)) - brown[c]);
  return sum;
}

TEST(Hidden, ColouredPaperInUnevenLightBesideThePaintDoesNotShow) {
  const Model model = assemble(make_discs({back}, width, height, 6), Visibility::orbit);
  const Drawing drawing = brown_on_green(
      [](int x, int y) { return std::clamp((back.radius - from_centre(x, y)) / 2, 0.0, 1.0); });
  const Drawing dressed = dress_hidden(model, drawing).drawing;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (from_centre(x, y) < back.radius + 1.5) {
        EXPECT_LT(off_brown(dressed.rgba, x, y), 6) << x << " " << y;
      } else if (from_centre(x, y) > back.radius + 6) {
        EXPECT_EQ(dressed.rgba.at(x, y, 1), drawing.rgba.at(x, y, 1));
      }
    }
}

TEST(Hidden, InkOnColouredPaperStays) {
  const Model model = assemble(make_discs({back}, width, height, 6), Visibility::orbit);
  Drawing drawing = brown_on_green([](int x, int y) { return from_centre(x, y) < 60 ? 1 : 0; });
  const auto is_ink = [](int x, int y) { return std::abs(from_centre(x, y) - 59) < 1.5; };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3 && is_ink(x, y); ++c) drawing.rgba.at(x, y, c) = 20;
  const Drawing dressed = dress_hidden(model, drawing).drawing;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (is_ink(x, y)) {
        EXPECT_LT(dressed.rgba.at(x, y, 1), 60) << x << " " << y;
      }
}

TEST(Hidden, PaperThatAnOutlineCutOffIsPaintedWhereItIsNarrow) {
  const Model model = assemble(make_discs({back}, width, height, 6), Visibility::orbit);
  // From the left a sliver reaches into the disc, from below a broad bay.
  const auto is_sliver = [](int x, int y) { return x < 50 && std::abs(y - 90) < 2; };
  const auto is_bay = [](int x, int y) { return y > 130 && std::abs(x - 90) < 10; };
  const Drawing drawing = brown_on_green([&](int x, int y) {
    return from_centre(x, y) < back.radius && !is_sliver(x, y) && !is_bay(x, y) ? 1 : 0;
  });
  const Drawing dressed = dress_hidden(model, drawing).drawing;
  for (int x = 31; x < 52; ++x)
    for (int y = 84; y < 96; ++y) EXPECT_LT(off_brown(dressed.rgba, x, y), 6) << x << " " << y;
  for (int x = 84; x < 96; ++x)
    for (int y = 134; y < 144; ++y)
      EXPECT_EQ(dressed.rgba.at(x, y, 1), drawing.rgba.at(x, y, 1)) << x << " " << y;
}

TEST(Hidden, ThinLimbsKeepTheirColour) {
  // A grey limb of 6 px on black: as grey as black that blends into white.
  std::vector<Disc> discs = {back};
  for (int k = 0; k < 12; ++k) discs.push_back({{149.0 + 4 * k, 90}, 3, 1, 10});
  const Model model = assemble(make_discs(discs, width, height, 2), Visibility::orbit);
  Drawing drawing{Image8(width, height, 4, 255)};
  const auto is_limb = [](int x, int y) { return x > 151 && x < 196 && std::abs(y - 89.5) < 3; };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        drawing.rgba.at(x, y, c) = from_centre(x, y) < back.radius ? 0 : is_limb(x, y) ? 120 : 255;
  const Drawing dressed = dress_hidden(model, drawing).drawing;
  for (int x = 165; x < 190; ++x)
    for (int y = 88; y < 92; ++y) EXPECT_EQ(dressed.rgba.at(x, y, 0), 120) << x << " " << y;
}

TEST(Hidden, WhatTouchesGoesOnWithTheDrawing) {
  // Over its middle the back disc is nearly flat: the front one lies less than 1 px above it.
  const DiscRelief relief = make_discs({back, {{90, 90}, 6, 0.01, 60.2}}, width, height, 3);
  EXPECT_EQ(assemble(relief, Visibility::orbit).parts[0].hidden_count, 0);
}

TEST(Hidden, HasTheColourOfItsOwnPartWithoutItsInk) {
  const Model model = assemble(make_discs({back, front}, width, height, 6), Visibility::orbit);
  const auto found = hidden_patches(model, drawn_discs());
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].part, 0);
  const std::vector<uint8_t> colours = hidden_colours(model, found);
  for (const auto& triangle : hidden_triangles(model, 0))
    for (const int v : triangle) {
      EXPECT_EQ(colours[3 * v], 0);
      EXPECT_EQ(colours[3 * v + 2], 200);
    }
}

TEST(Hidden, DressedModelShowsItAndElseTheDrawing) {
  const Model model = assemble(make_discs({back, front}, width, height, 6), Visibility::orbit);
  const Drawing drawing = drawn_discs();
  const auto [dressed, picture] = dress_hidden(model, drawing);
  ASSERT_EQ(dressed.triangles.size(), model.triangles.size());
  for (size_t t = 0; t < model.triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k)
      EXPECT_TRUE(dressed.positions[dressed.triangles[t][k]] ==
                  model.positions[model.triangles[t][k]]);
  EXPECT_EQ(dressed.parts[0].hidden_count, 0);
  const int seen = model.parts[0].triangle_count - model.parts[0].hidden_count;
  ASSERT_LT(seen, model.parts[0].triangle_count);
  for (int t = seen; t < model.parts[0].triangle_count; ++t)
    for (const int v : dressed.triangles[t]) {
      EXPECT_EQ(pixel_at(picture, dressed.uvs[v])[2], 200);
      EXPECT_EQ(pixel_at(picture, dressed.uvs[v])[0], 0);
    }
  for (int t = 0; t < seen; ++t)
    for (const int v : dressed.triangles[t]) {
      const Point2 uv = dressed.uvs[v];
      EXPECT_NEAR(uv.x * width, dressed.positions[v].x, 1e-9);
      EXPECT_NEAR(uv.y * picture.rgba.height, height - dressed.positions[v].y, 1e-9);
    }
}

}  // namespace
}  // namespace relievo::relief
