#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/base/workers.h"
#include "relievo/render.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

/// The whole canvas, pixel by pixel, without a background.
RenderOptions canvas_view(const Model& model, int width) {
  RenderOptions options;
  options.width = width;
  options.height = static_cast<int>(std::lround(width * model.height / model.width));
  options.window = RenderWindow{{0.5 * model.width, 0.5 * model.height}, model.width};
  options.background = Background::transparent;
  options.samples = 4;
  return options;
}

Image8 picture(const Model& model, const RenderOptions& options, const Drawing* drawing = nullptr) {
  Result<Image8> image = render_model(model, drawing, options);
  EXPECT_TRUE(image.ok()) << to_string(image.error());
  return *image;
}

/// Mean of the green channel over a square around (x, y).
double brightness(const Image8& image, int x, int y, int radius = 2) {
  double sum = 0;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) sum += image.at(x + dx, y + dy, 1);
  return sum / ((2 * radius + 1) * (2 * radius + 1));
}

/// Hue in degrees.
double hue(double r, double g, double b) {
  return std::atan2(std::sqrt(3.0) * (g - b), 2 * r - g - b) * 180 / M_PI;
}

TEST(RenderModel, SilhouetteIsTheAnalyticDisc) {
  const Model model = hemisphere(100);
  const Image8 image = picture(model, canvas_view(model, 250));
  int both = 0;
  int either = 0;
  for (int y = 0; y < 250; ++y)
    for (int x = 0; x < 250; ++x) {
      const bool inside = distance({x + 0.5, y + 0.5}, {125, 125}) < 100;
      const bool covered = image.at(x, y, 3) >= 128;
      both += inside && covered ? 1 : 0;
      either += inside || covered ? 1 : 0;
    }
  EXPECT_GT(both, 0.99 * either);
}

TEST(RenderModel, BrighterTowardsTheLight) {
  const Model model = hemisphere(100);
  RenderOptions options = canvas_view(model, 250);
  for (const Point3 light : {Point3{-1, 1, 1}, Point3{1, -1, 1}, Point3{1, 1, 0.5}}) {
    options.light = light;
    const Image8 image = picture(model, options);
    const int dx = light.x > 0 ? 40 : -40;
    const int dy = light.y > 0 ? -40 : 40;
    EXPECT_GT(brightness(image, 125 + dx, 125 + dy), 30 + brightness(image, 125 - dx, 125 - dy));
  }
}

TEST(RenderModel, OcclusionDarkensTheContactOfABallOnAPlane) {
  Model model = hemisphere(60);
  add_plane(model, "ground", 0);
  RenderOptions options = canvas_view(model, 250);
  options.light = {0, 1, 0.6};  // passes the ball's right side: no shadow falls there
  options.light_radius = 0;
  options.samples = 16;
  const Image8 image = picture(model, options);
  const double contact = brightness(image, 125 + 104, 125, 1);
  EXPECT_LT(contact, brightness(image, 12, 12, 1) - 5);
  EXPECT_LT(contact, brightness(image, 125 + 120, 125, 1) - 3);
  options.ambient_rays = 0;
  const Image8 flat = picture(model, options);
  EXPECT_NEAR(brightness(flat, 125 + 104, 125, 1), brightness(flat, 12, 12, 1), 1);
}

TEST(RenderModel, ShadowFallsAwayFromTheLight) {
  Model model = empty_model(250, 250);
  add_plane(model, "ground", 0);
  add_ellipsoid(model, {"ball", {125, 125}, 0, {40, 40, 60}});
  RenderOptions options = canvas_view(model, 250);
  options.light = {-1, 0, 1};
  const Image8 image = picture(model, options);
  EXPECT_GT(brightness(image, 125 - 50, 125), 40 + brightness(image, 125 + 50, 125));
}

TEST(RenderModel, SoftShadowsHaveAWiderBorderThanHardOnes) {
  Model model = empty_model(250, 250);
  add_plane(model, "ground", 0);
  add_ellipsoid(model, {"ball", {100, 125}, 0, {40, 40, 60}});
  RenderOptions options = canvas_view(model, 250);
  options.light = {-1, 0, 0.7};
  options.ambient_rays = 0;
  options.samples = 16;
  const auto border_width = [&](double radius) {
    options.light_radius = radius;
    const Image8 image = picture(model, options);
    const int dark = image.at(150, 125, 1);
    const int lit = image.at(245, 125, 1);
    int width = 0;
    for (int x = 150; x < 245; ++x) {
      const int value = image.at(x, 125, 1);
      width += value > dark + 8 && value < lit - 8 ? 1 : 0;
    }
    return width;
  };
  EXPECT_GT(border_width(12), 5 + border_width(0));
}

TEST(RenderModel, ShadingOfCoarseTrianglesIsThatOfTheSmoothSurface) {
  const Model fine = hemisphere(100, 64);
  const Model coarse = hemisphere(100, 8);
  RenderOptions options = canvas_view(fine, 250);
  options.light = {-1, 0.3, 0.15};
  options.samples = 16;
  const Image8 expected = picture(fine, options);
  const Image8 image = picture(coarse, options);
  double worst = 0;
  for (int y = 50; y <= 200; y += 3)
    for (int x = 50; x <= 200; x += 3)
      if (distance({1.0 * x, 1.0 * y}, {125, 125}) < 90)
        worst =
            std::max(worst, std::abs(brightness(image, x, y, 1) - brightness(expected, x, y, 1)));
  EXPECT_LT(worst, 16);
}

TEST(RenderModel, SteeperAndFlatterSurfacesAreShadedByTheirNormals) {
  const Model round = hemisphere(100, 64);
  RenderOptions options = canvas_view(round, 250);
  options.light = {-1, 0, 1};
  options.samples = 16;
  options.ambient_rays = 0;
  const Image8 expected = picture(round, options);
  for (const double steep : {1.6, 0.0}) {
    Model model = round;
    for (Point3& p : model.positions) p.z *= steep;
    const Image8 image = picture(model, options);
    double worst = 0;
    for (int y = 30; y <= 220; ++y)
      for (int x = 30; x <= 220; ++x)
        if (distance({1.0 * x, 1.0 * y}, {125, 125}) < 98)
          worst =
              std::max(worst, std::abs(brightness(image, x, y, 1) - brightness(expected, x, y, 1)));
    EXPECT_LT(worst, 4) << steep;
  }
}

TEST(RenderModel, SameBytesForAnyNumberOfThreads) {
  const Model model = split_hemisphere(50);
  const Drawing drawing = quarters();
  RenderOptions options = seen_from(View::three_quarter, {});
  options.width = 90;
  options.height = 70;
  options.shading = Shading::textured;
  set_worker_count(1);
  const Image8 one = picture(model, options, &drawing);
  for (const int threads : {2, 5, 0}) {
    set_worker_count(threads);
    EXPECT_TRUE(picture(model, options, &drawing).pixels == one.pixels) << threads;
  }
}

TEST(RenderModel, TexturedFrontViewLiesOnTheDrawingAndKeepsItsHues) {
  Model model = empty_model(160, 160);
  add_plane(model, "sheet", 0);
  Drawing drawing{Image8(160, 160, 4, 255)};
  const std::vector<std::array<uint8_t, 3>> colours = {
      {200, 60, 40}, {60, 170, 80}, {50, 90, 200}, {220, 170, 60}};
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x)
      for (int c = 0; c < 3; ++c)
        drawing.rgba.at(x, y, c) = colours[(x >= 80) + 2 * (y >= 80)][static_cast<size_t>(c)];
  RenderOptions options = canvas_view(model, 160);
  options.shading = Shading::textured;
  const Image8 image = picture(model, options, &drawing);
  for (int y = 4; y < 156; ++y)
    for (int x = 4; x < 156; ++x) {
      if (std::abs(x - 79.5) < 2 || std::abs(y - 79.5) < 2) continue;
      const auto& colour = colours[(x >= 80) + 2 * (y >= 80)];
      ASSERT_NEAR(hue(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)),
                  hue(colour[0], colour[1], colour[2]), 6)
          << x << " " << y;
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(image.at(x, y, c), colour[static_cast<size_t>(c)], 40);
    }
}

TEST(RenderModel, LargeTexturesAreAveraged) {
  Model model = empty_model(40, 40);
  add_plane(model, "sheet", 0);
  Drawing chessboard{Image8(640, 640, 4, 255)};
  for (int y = 0; y < 640; ++y)
    for (int x = 0; x < 640; ++x)
      for (int c = 0; c < 3; ++c) chessboard.rgba.at(x, y, c) = (x + y) % 2 == 0 ? 255 : 0;
  RenderOptions options = canvas_view(model, 40);
  options.shading = Shading::textured;
  options.samples = 1;
  options.ambient_rays = 0;
  options.light_radius = 0;
  const Image8 image = picture(model, options, &chessboard);
  for (int x = 1; x < 39; ++x) ASSERT_NEAR(image.at(x, 20, 0), image.at(20, 20, 0), 1);
}

TEST(RenderModel, PixelsOfPixelArtAreNotMixed) {
  Model model = empty_model(40, 40);
  add_plane(model, "sheet", 0);
  Drawing halves{Image8(2, 1, 4, 255)};
  std::fill_n(halves.rgba.pixels.begin(), 3, uint8_t{0});
  RenderOptions options = canvas_view(model, 40);
  options.shading = Shading::textured;
  options.samples = 1;
  options.ambient_rays = 0;
  options.light_radius = 0;
  const auto count_mixed = [&] {
    const Image8 image = picture(model, options, &halves);
    int mixed = 0;
    for (int x = 1; x < 39; ++x)
      mixed += image.at(x, 20) != image.at(1, 20) && image.at(x, 20) != image.at(38, 20) ? 1 : 0;
    return mixed;
  };
  EXPECT_GT(count_mixed(), 10);
  halves.pixel_art = 1;
  EXPECT_EQ(count_mixed(), 0);
}

TEST(RenderModel, WindowKeepsItsPointInTheMiddleFromEverySide) {
  Model model = empty_model(300, 300);
  add_ellipsoid(model, {"body", {150, 150}, 0, {140, 140, 40}});
  add_ellipsoid(model, {"button", {90, 200}, 60, {6, 6, 6}});
  RenderOptions options = canvas_view(model, 64);
  options.window = RenderWindow{{90, 200}, 12};
  for (const double yaw : {-40.0, 0.0, 40.0}) {
    options.yaw = yaw;
    const Image8 image = picture(model, options);
    EXPECT_EQ(image.at(32, 32, 3), 255) << yaw;
  }
  options.yaw = 0;
  EXPECT_EQ(picture(model, options).at(63, 32, 3), 255);
}

TEST(RenderModel, TheOpenBackIsShadedToo) {
  const Model model = hemisphere(100);
  RenderOptions options = canvas_view(model, 100);
  options.yaw = 180;
  options.light = {0, 0, 1};
  const Image8 image = picture(model, options);
  EXPECT_EQ(image.at(50, 50, 3), 255);
  EXPECT_GT(brightness(image, 50, 50), 60);
}

TEST(RenderModel, BackgroundsFillWhatTheModelLeaves) {
  const Model model = hemisphere(50);
  RenderOptions options = canvas_view(model, 60);
  EXPECT_EQ(picture(model, options).at(0, 0, 3), 0);
  options.background = Background::white;
  const Image8 white = picture(model, options);
  for (int c = 0; c < 4; ++c) EXPECT_EQ(white.at(0, 0, c), 255);
  options.background = Background::gradient;
  const Image8 gradient = picture(model, options);
  EXPECT_EQ(gradient.at(0, 0, 3), 255);
  EXPECT_LT(gradient.at(0, 59, 1), gradient.at(30, 2, 1));
}

TEST(RenderModel, TheWholeModelIsInThePicture) {
  Model model = empty_model(1000, 1000);
  add_ellipsoid(model, {"far", {900, 100}, 500, {30, 80, 20}});
  add_ellipsoid(model, {"near", {200, 700}, -100, {150, 20, 90}});
  for (const View view : {View::front, View::three_quarter, View::side}) {
    RenderOptions options = seen_from(view, {});
    options.width = 120;
    options.height = 90;
    options.background = Background::transparent;
    options.ambient_rays = 0;
    const Image8 image = picture(model, options);
    int border = 0;
    int covered = 0;
    for (int y = 0; y < 90; ++y)
      for (int x = 0; x < 120; ++x) {
        const bool hit = image.at(x, y, 3) > 0;
        covered += hit ? 1 : 0;
        border += hit && (x < 2 || y < 2 || x >= 118 || y >= 88) ? 1 : 0;
      }
    EXPECT_EQ(border, 0);
    EXPECT_GT(covered, 50);
  }
}

TEST(ContactSheet, ViewsHaveOneScale) {
  const Model model = hemisphere(100);
  RenderOptions options;
  options.width = 80;
  options.height = 100;
  options.background = Background::transparent;
  double last = 0;
  RunContext context;
  context.progress = [&](const char*, double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
  };
  const Result<Image8> sheet = render_contact_sheet(model, nullptr, options, context);
  ASSERT_TRUE(sheet.ok());
  ASSERT_EQ(sheet->width, 240);
  ASSERT_EQ(sheet->height, 100);
  const auto rows = [&](int x0) {
    int count = 0;
    for (int y = 0; y < 100; ++y) {
      bool covered = false;
      for (int x = x0; x < x0 + 80; ++x) covered = covered || sheet->at(x, y, 3) > 0;
      count += covered ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(rows(0), 60);
  EXPECT_NEAR(rows(0), rows(160), 1);
  EXPECT_GT(last, 0.6);
}

TEST(RenderModel, OptionsOutOfRangeAreRefused) {
  const Model model = hemisphere(10, 4);
  const std::vector<void (*)(RenderOptions&)> wrong = {
      [](RenderOptions& o) { o.width = 0; },
      [](RenderOptions& o) { o.height = -5; },
      [](RenderOptions& o) { o.yaw = NAN; },
      [](RenderOptions& o) {
        o.light = {0, 0, 0};
      },
      [](RenderOptions& o) { o.light_radius = 80; },
      [](RenderOptions& o) { o.samples = 0; },
      [](RenderOptions& o) { o.ambient_rays = 65; },
      [](RenderOptions& o) {
        o.window = RenderWindow{{0, 0}, 0};
      },
      [](RenderOptions& o) { o.shading = Shading::textured; },
  };
  for (size_t i = 0; i < wrong.size(); ++i) {
    RenderOptions options;
    wrong[i](options);
    EXPECT_EQ(render_model(model, nullptr, options).error().code, ErrorCode::usage) << i;
  }
  RenderOptions huge;
  huge.width = huge.height = 16384;
  EXPECT_EQ(render_model(model, nullptr, huge).error().code, ErrorCode::limit);
  huge.width = huge.height = 8000;
  EXPECT_EQ(render_contact_sheet(model, nullptr, huge).error().code, ErrorCode::limit);
}

TEST(RenderModel, ModelsThatCannotBeSeenAreRefused) {
  EXPECT_EQ(render_model(empty_model(5, 5), nullptr, {}).error().code, ErrorCode::bad_input);
  const std::vector<void (*)(Model&)> damages = {
      [](Model& m) { m.positions[3].y = std::numeric_limits<double>::infinity(); },
      [](Model& m) { m.normals[3].z = NAN; },
      [](Model& m) { m.uvs[3].x = NAN; },
  };
  for (const auto damage : damages) {
    Model broken = hemisphere(10, 4);
    damage(broken);
    const Result<Image8> refused = render_model(broken, nullptr, {});
    EXPECT_EQ(refused.error().code, ErrorCode::bad_input);
    EXPECT_EQ(refused.error().where, "vertex 3");
  }
}

TEST(RenderModel, ExtremeCoordinatesGiveAPictureOrAnError) {
  for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
    Model model = hemisphere(10, 4);
    for (Point3& p : model.positions) p = scale * p;
    RenderOptions options = canvas_view(model, 20);
    EXPECT_TRUE(render_model(model, nullptr, options).ok()) << scale;
    options.window.reset();
    EXPECT_TRUE(render_model(model, nullptr, options).ok()) << scale;
  }
}

TEST(RenderModel, StopsWhenCancelled) {
  const Model model = hemisphere(10, 4);
  std::atomic<bool> cancel{true};
  RunContext context;
  context.cancel = &cancel;
  EXPECT_EQ(render_model(model, nullptr, {}, context).error().code, ErrorCode::interrupted);
  cancel = false;
  context.progress = [&](const char*, double) { cancel = true; };
  EXPECT_EQ(render_model(model, nullptr, {}, context).error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace relievo
