#include "io/layered/compose_layers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "io/layered/layer_support.h"

namespace relievo {
namespace {

constexpr int width = 7;
constexpr int height = 5;

/// A picture with colours times alpha, in floating point, which is composed by the formulas alone.
struct Reference {
  std::vector<std::array<double, 4>> pixels{size_t{width} * height, {0, 0, 0, 0}};
};

/// Computes the colour that multiply and screen show over nothing: no white or black paper.
std::array<double, 4> beside(BlendMode mode, const std::array<double, 3>& c, double alpha) {
  if (mode == BlendMode::multiply) {
    const double paper = std::min({c[0], c[1], c[2]});
    return {alpha * (c[0] - paper), alpha * (c[1] - paper), alpha * (c[2] - paper),
            alpha * (1 - paper)};
  }
  const double shown = mode == BlendMode::screen ? std::max({c[0], c[1], c[2]}) : 1;
  return {alpha * c[0], alpha * c[1], alpha * c[2], alpha * shown};
}

double mixed(BlendMode mode, double b, double s) {
  if (mode == BlendMode::multiply) return b * s;
  if (mode == BlendMode::screen) return 1 - (1 - b) * (1 - s);
  if (mode == BlendMode::overlay) return b <= 0.5 ? 2 * b * s : 1 - 2 * (1 - b) * (1 - s);
  return s;
}

void lay(std::array<double, 4>& below, const std::array<double, 4>& above, double opacity,
         Blending blending) {
  const double b = below[3];
  const double s = above[3] * opacity;
  std::array<double, 3> c = {};
  for (size_t k = 0; k < 3; ++k) c[k] = above[3] > 0 ? above[k] / above[3] : 0;
  const std::array<double, 4> alone = beside(blending.mode, c, s);
  const bool atop = blending.cover == CoverMode::atop;
  for (size_t k = 0; k < 3; ++k) {
    const double own = b > 0 ? below[k] / b : 0;
    below[k] = (1 - s) * below[k] + s * b * mixed(blending.mode, own, c[k]) +
               (atop ? 0 : (1 - b) * alone[k]);
  }
  if (!atop) below[3] = b + (1 - b) * alone[3];
}

void lay(Reference& below, const Reference& above, double opacity, Blending blending) {
  for (size_t i = 0; i < below.pixels.size(); ++i)
    lay(below.pixels[i], above.pixels[i], opacity, blending);
}

Reference reference_of(const RasterLayer& layer) {
  Reference picture;
  for (int y = 0; y < layer.rgba.height; ++y)
    for (int x = 0; x < layer.rgba.width; ++x) {
      const int u = x + layer.x;
      const int v = y + layer.y;
      if (u < 0 || v < 0 || u >= width || v >= height) continue;
      const double alpha = layer.rgba.at(x, y, 3) / 255.0;
      for (int k = 0; k < 3; ++k)
        picture.pixels[size_t(v) * width + u][k] = alpha * layer.rgba.at(x, y, k) / 255.0;
      picture.pixels[size_t(v) * width + u][3] = alpha;
    }
  return picture;
}

/// Composes what is in a group, from layer `next` on, with the groups inside it.
void compose(const LayerStack& stack, int group, size_t& next, Reference& onto) {
  const auto is_inside = [&](int inner) {
    while (inner != group && inner != -1) inner = stack.groups[inner].parent;
    return inner == group;
  };
  while (next < stack.layers.size() && is_inside(stack.layers[next].group)) {
    const RasterLayer& layer = stack.layers[next];
    if (layer.group == group) {
      lay(onto, reference_of(layer), layer.opacity, layer.blending);
      ++next;
      continue;
    }
    int child = layer.group;
    while (stack.groups[child].parent != group) child = stack.groups[child].parent;
    const LayerGroup& own = stack.groups[child];
    Reference inside = own.passes ? onto : Reference();
    compose(stack, child, next, inside);
    if (!own.passes) {
      lay(onto, inside, own.opacity, own.blending);
      continue;
    }
    for (size_t i = 0; i < onto.pixels.size(); ++i)
      for (size_t k = 0; k < 4; ++k)
        onto.pixels[i][k] += own.opacity * (inside.pixels[i][k] - onto.pixels[i][k]);
  }
}

/// A stack of groups in groups with layers of random pixels, places, modes and opacities.
LayerStack random_stack(std::mt19937& random) {
  const auto pick = [&](int count) { return static_cast<int>(random() % count); };
  const std::array modes = {BlendMode::normal, BlendMode::normal, BlendMode::multiply,
                            BlendMode::screen, BlendMode::overlay};
  LayerStack stack;
  const std::function<void(int, int)> fill = [&](int parent, int depth) {
    for (int k = 0; k < 3; ++k) {
      if (depth < 3 && pick(3) == 0) {
        LayerGroup group;
        group.parent = parent;
        group.opacity = pick(2) == 0 ? 1 : 0.6;
        group.passes = pick(2) == 0;
        if (!group.passes) group.blending.mode = modes[pick(5)];
        stack.groups.push_back(group);
        fill(static_cast<int>(stack.groups.size()) - 1, depth + 1);
        continue;
      }
      RasterLayer layer;
      layer.group = parent;
      layer.x = pick(5) - 2;
      layer.y = pick(5) - 2;
      layer.opacity = pick(2) == 0 ? 1 : 0.7;
      layer.blending = {modes[pick(5)], pick(4) == 0 ? CoverMode::atop : CoverMode::over};
      layer.rgba = Image8(3 + pick(6), 3 + pick(4), 4);
      for (uint8_t& value : layer.rgba.pixels) value = static_cast<uint8_t>(random());
      stack.layers.push_back(std::move(layer));
    }
  };
  fill(-1, 0);
  return stack;
}

TEST(ComposeLayers, AgreesWithTheFormulasInFloatingPoint) {
  std::mt19937 random(59);
  for (int round = 0; round < 200; ++round) {
    const LayerStack stack = random_stack(random);
    const auto drawing = composed(width, height, stack);
    ASSERT_TRUE(drawing) << to_string(drawing.error());
    Reference wanted;
    size_t next = 0;
    compose(stack, -1, next, wanted);
    const Image8& rgba = drawing->picture.rgba;
    for (size_t i = 0; i < wanted.pixels.size(); ++i) {
      const double alpha = wanted.pixels[i][3];
      ASSERT_NEAR(rgba.pixels[4 * i + 3] / 255.0, alpha, 0.02) << "round " << round;
      for (size_t k = 0; k < 3; ++k)
        ASSERT_NEAR(rgba.pixels[4 * i + k] / 255.0 * rgba.pixels[4 * i + 3] / 255.0,
                    wanted.pixels[i][k], 0.03)
            << "round " << round << ", pixel " << i;
    }
  }
}

LayerGroup group(const std::string& name, int parent = -1) {
  LayerGroup made;
  made.name = name;
  made.parent = parent;
  return made;
}

RasterLayer in(int group, RasterLayer layer) {
  layer.group = group;
  return layer;
}

TEST(ComposeLayers, TheOpacityOfAGroupShowsNoneOfItsHiddenLayers) {
  LayerStack stack{{group("both")}, {}};
  stack.groups[0].opacity = 0.5;
  stack.layers = {in(0, layer("red", Image8(4, 4, 4, 255))),
                  in(0, layer("black", disc(4, 4, {2, 2}, 9, black)))};
  const auto drawing = composed(4, 4, stack);
  ASSERT_TRUE(drawing);
  EXPECT_EQ(drawing->picture.rgba.at(2, 2, 3), 128);
  EXPECT_EQ(drawing->picture.rgba.at(2, 2, 0), 0);
}

TEST(ComposeLayers, WhatBlendsIsNoPart) {
  const RasterLayer body = layer("body", disc(300, 300, {150, 180}, 90, red));
  const RasterLayer head = layer("head", disc(300, 300, {150, 80}, 50, blue));
  RasterLayer shade = layer("shade", disc(300, 300, {150, 130}, 60, {60, 60, 60, 255}));
  for (const BlendMode mode : {BlendMode::multiply, BlendMode::screen, BlendMode::overlay}) {
    shade.blending.mode = mode;
    auto drawing = drawing_of(300, 300, {body, head, shade});
    EXPECT_EQ(part_names(drawing), (std::vector<std::string>{"body", "head"}));
    EXPECT_TRUE(drawing.warnings.empty());
  }
  shade.role = LayerRole::part;
  auto named = drawing_of(300, 300, {body, head, shade});
  EXPECT_EQ(part_names(named), std::vector<std::string>{"shade"});
}

TEST(ComposeLayers, InkOnAWhiteSheetBelongsToThePartsAlongWhichItRuns) {
  Image8 sheet(300, 300, 4, 255);
  paint_disc(sheet, {150, 180}, 93, black);
  paint_disc(sheet, {150, 180}, 87, {255, 255, 255, 255});
  RasterLayer ink = layer("ink", sheet);
  ink.blending.mode = BlendMode::multiply;
  auto drawing = drawing_of(300, 300,
                            {layer("body", disc(300, 300, {150, 180}, 90, red)),
                             layer("head", disc(300, 300, {150, 80}, 50, blue)), ink});
  EXPECT_EQ(part_names(drawing), (std::vector<std::string>{"body", "head"}));
  const double radius = std::sqrt(part_area(drawing.scene.parts[0]) / 3.14159265);
  EXPECT_NEAR(radius, 93, 1);
  EXPECT_EQ(drawing.picture.rgba.at(150, 180, 0), red[0]);
  EXPECT_EQ(drawing.picture.rgba.at(5, 5, 3), 0);
  EXPECT_EQ(drawing.picture.rgba.at(150, 271, 3), 255);
}

TEST(ComposeLayers, WhatErasesCutsThePartsOfItsGroup) {
  LayerStack stack{{group("body")}, {}};
  RasterLayer hole = in(0, layer("hole", disc(300, 300, {150, 180}, 30, black)));
  hole.blending.cover = CoverMode::below_out;
  stack.layers = {layer("ground", disc(300, 300, {150, 180}, 60, blue)),
                  in(0, layer("ring", disc(300, 300, {150, 180}, 90, red))), hole};
  auto drawing = composed(300, 300, stack);
  ASSERT_TRUE(drawing);
  ASSERT_EQ(drawing->marks.size(), 2u);
  EXPECT_EQ(drawing->marks[0].region.size(), 1u);
  EXPECT_EQ(drawing->marks[1].region.size(), 2u);
  EXPECT_EQ(drawing->picture.rgba.at(150, 180, 2), blue[2]);
  stack.layers[2].blending.cover = CoverMode::below_in;
  drawing = composed(300, 300, stack);
  ASSERT_TRUE(drawing);
  EXPECT_NEAR(bounding_box(drawing->marks[1].region).max.x, 180, 0.1);
  EXPECT_EQ(drawing->picture.rgba.at(230, 180, 3), 0);
}

TEST(ComposeLayers, AMergedGroupIsOneLayer) {
  LayerStack stack{{group("head")}, {}};
  stack.groups[0].merged = true;
  stack.layers = {layer("body", disc(300, 300, {150, 200}, 80, red)),
                  in(0, layer("skull", disc(300, 300, {150, 90}, 50, blue))),
                  in(0, layer("ear", disc(300, 300, {100, 50}, 20, red)))};
  auto drawing = composed(300, 300, stack);
  ASSERT_TRUE(drawing);
  EXPECT_EQ(part_names(*drawing), (std::vector<std::string>{"body", "head"}));
  stack.groups[0].role = LayerRole::part;
  drawing = composed(300, 300, stack);
  ASSERT_TRUE(drawing);
  EXPECT_EQ(part_names(*drawing), std::vector<std::string>{"head"});
  // A part inside it counts more.
  stack.layers[2].role = LayerRole::part;
  drawing = composed(300, 300, stack);
  ASSERT_TRUE(drawing);
  EXPECT_EQ(part_names(*drawing), std::vector<std::string>{"ear"});
}

TEST(ComposeLayers, GroupsThatTakeTooMuchMemoryOrTimeAreRefused) {
  LayerStack stack;
  for (int k = 0; k < 6; ++k) {
    stack.groups.push_back(group("g", k - 1));
    stack.groups.back().opacity = 0.9;
  }
  stack.layers = {in(5, layer("a", Image8(10, 10, 4, 255))), layer("b", Image8(10, 10, 4, 255))};
  const auto with = [&](const ImageLimits& limits) {
    return compose_layers(
               {10, 10}, stack, [&](size_t k) -> Result<Image8> { return stack.layers[k].rgba; },
               limits)
        .ok();
  };
  EXPECT_TRUE(with({}));
  EXPECT_TRUE(with({100, 100, 600}));
  EXPECT_FALSE(with({100, 100, 599}));
  EXPECT_FALSE(with({40, 100, 600}));
}

}  // namespace
}  // namespace relievo
