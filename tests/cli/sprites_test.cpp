#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <vector>

#include "cli/cli_test.h"
#include "io/image/decode_image.h"
#include "io/image/png.h"
#include "io/mesh/glb_decode.h"
#include "io/project/project_file.h"
#include "kernel/image/enlarge.h"
#include "support/label_maps.h"

namespace relievo {
namespace {

using namespace testing;
using Rgb = std::array<uint8_t, 3>;

/// A man of 24 px in six colours: ink, hair, skin, shirt, trousers and mouth.
constexpr std::array<std::string_view, 24> man = {
    "........................", ".........kkkkkk.........", "........khhhhhhk........",
    ".......khhhhhhhhk.......", ".......khhsssshhk.......", ".......khsksskshk.......",
    ".......khsssssshk.......", "........kssmmssk........", ".........kssssk.........",
    ".......kkkkkkkkkk.......", "......krrrrrrrrrrk......", ".....krrkrrrrrrkrrk.....",
    ".....krrkrrrrrrkrrk.....", "....krrkkrrrrrrkkrrk....", "....kssk.krrrrk.kssk....",
    "....kssk.kbbbbk.kssk....", ".....kk..kbbbbk..kk.....", ".........kbkkbk.........",
    "........kbbkkbbk........", "........kbbkkbbk........", "........kbbk.kbbk.......",
    ".......khhhk.khhhk......", ".......khhhk.khhhk......", "........kkk...kkk......."};

Rgb colour_of(char letter) {
  switch (letter) {
    case 'h':
      return {120, 70, 30};
    case 's':
      return {240, 200, 160};
    case 'r':
      return {200, 50, 50};
    case 'b':
      return {50, 70, 180};
    case 'm':
      return {230, 110, 120};
    default:
      return {40, 30, 40};
  }
}

Image8 sprite() {
  Image8 rgba(24, 24, 4);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) {
      if (man[y][x] == '.') continue;
      const Rgb colour = colour_of(man[y][x]);
      std::copy(colour.begin(), colour.end(), &rgba.at(x, y));
      rgba.at(x, y, 3) = 255;
    }
  return rgba;
}

/// A fox of 64 px whose nine areas touch each other, without outlines.
Image8 fox() {
  const Image16 labels =
      painted(64, 64,
              {oval(50, 38, 12, 8, 0), oval(59, 35, 4, 5, 0), oval(31, 43, 15, 13, 0),
               box(18, 50, 25, 62), box(36, 50, 43, 62), box(6, 4, 13, 16), box(25, 4, 32, 16),
               oval(19, 23, 15, 13, 0), oval(19, 29, 7, 6, 0)});
  const std::array<Rgb, 10> colours{{{},
                                     {200, 90, 30},
                                     {250, 240, 230},
                                     {225, 130, 60},
                                     {90, 45, 30},
                                     {90, 45, 30},
                                     {150, 60, 30},
                                     {150, 60, 30},
                                     {240, 150, 50},
                                     {250, 240, 230}}};
  Image8 rgba(64, 64, 4);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      if (labels.at(x, y) == 0) continue;
      const Rgb& colour = colours[labels.at(x, y)];
      std::copy(colour.begin(), colour.end(), &rgba.at(x, y));
      rgba.at(x, y, 3) = 255;
    }
  return rgba;
}

/// The drawing smoothed, as programs draw that are not made for pixel art.
Image8 smoothed(const Image8& rgba) {
  Image8 out(rgba.width, rgba.height, 4, 255);
  for (int y = 1; y + 1 < rgba.height; ++y)
    for (int x = 1; x + 1 < rgba.width; ++x)
      for (int c = 0; c < 4; ++c)
        out.at(x, y, c) = static_cast<uint8_t>((4 * rgba.at(x, y, c) + rgba.at(x - 1, y, c) +
                                                rgba.at(x + 1, y, c) + rgba.at(x, y - 1, c) +
                                                rgba.at(x, y + 1, c)) /
                                               8);
  return out;
}

class Sprites : public CliTest {
 protected:
  void SetUp() override {
    write_picture("man.png", sprite());
    write_picture("fox.png", fox());
  }

  void write_picture(const std::string& name, const Image8& rgba) const {
    write(name, std::string(to_text(*encode_png(rgba))));
  }

  Image8 picture(const std::string& name) const {
    const auto image = decode_image(to_bytes(read(name)));
    EXPECT_TRUE(image) << name;
    return image ? *image : Image8();
  }

  relief::DrawnModel built(std::vector<std::string> options, const std::string& drawing) const {
    options.insert(options.begin(), {"build", drawing, "-o", "model.glb", "--vertices", "4000"});
    const Outcome outcome = relievo(options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    auto model = decode_glb(to_bytes(read("model.glb")));
    return model ? std::move(*model) : relief::DrawnModel();
  }
};

std::set<Rgb> colours_of(const Image8& rgba) {
  std::set<Rgb> colours;
  for (size_t i = 0; i < rgba.pixels.size(); i += 4)
    if (rgba.pixels[i + 3] > 0)
      colours.insert({rgba.pixels[i], rgba.pixels[i + 1], rgba.pixels[i + 2]});
  return colours;
}

TEST_F(Sprites, HandsAndFeetArePartOfTheModel) {
  ASSERT_EQ(relievo({"build", "man.png", "--part-map", "parts.png"}).exit_code, 0);
  const auto parts = decode_png_values(to_bytes(read("parts.png")));
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->width % 24, 0);
  ASSERT_EQ(parts->width, parts->height);
  const int side = parts->width / 24;
  EXPECT_EQ(side, 2048 / 24);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x)
      EXPECT_EQ(parts->at(side * x + side / 2, side * y + side / 2) > 0, man[y][x] != '.')
          << x << ", " << y;
}

TEST_F(Sprites, AFoxOfNineAreasHasMostOfThem) {
  const relief::DrawnModel model = built({}, "fox.png");
  EXPECT_GE(model.model.parts.size(), 7U);
  EXPECT_LE(model.model.parts.size(), 10U);
}

TEST_F(Sprites, SixColoursStaySix) {
  const std::set<Rgb> six = colours_of(sprite());
  ASSERT_EQ(six.size(), 6U);
  for (const char* profile : {"relief", "figure"}) {
    const relief::DrawnModel model = built({"--profile", profile}, "man.png");
    EXPECT_EQ(model.drawing.pixel_art, 1);
    std::set<Rgb> found = colours_of(model.drawing.rgba);
    if (std::string(profile) == "figure") found.erase({236, 230, 218});  // of its base
    EXPECT_EQ(found, six) << profile;
  }
}

TEST_F(Sprites, IsToldByItsStepsOrByTheOption) {
  write_picture("smooth.png", smoothed(fox()));
  EXPECT_EQ(built({}, "fox.png").drawing.pixel_art, 1);
  EXPECT_EQ(built({"--pixel-art", "no"}, "fox.png").drawing.pixel_art, 0);
  EXPECT_EQ(built({}, "smooth.png").drawing.pixel_art, 0);
  EXPECT_EQ(built({"--pixel-art", "yes"}, "smooth.png").drawing.pixel_art, 1);
  expect_failure({"build", "fox.png", "-o", "x.glb", "--pixel-art", "maybe"}, 2, "--pixel-art");
}

TEST_F(Sprites, IsTheSameWhetherItWasEnlargedBefore) {
  write_picture("large.png", enlarged(sprite(), 13));
  built({}, "man.png");
  const std::string first = read("model.glb");
  built({}, "large.png");
  EXPECT_TRUE(read("model.glb") == first);
}

TEST_F(Sprites, ScenesAndProjectsBuildTheSameModel) {
  for (const char* output : {"man.json", "man.relievo"})
    ASSERT_EQ(relievo({"segment", "man.png", "-o", output}).exit_code, 0);
  built({}, "man.png");
  const std::string model = read("model.glb");
  for (const char* input : {"man.json", "man.relievo"}) {
    built({}, input);
    EXPECT_TRUE(read("model.glb") == model) << input;
  }
}

TEST_F(Sprites, ASceneOfItsOwnSizeKeepsThePicture) {
  write("scene.json", R"({"format": "relievo-scene", "version": 1, "drawing": "man.png",
    "canvas": {"width": 24, "height": 24},
    "parts": [{"id": "man", "outline": [[[4, 1], [20, 1], [20, 24], [4, 24]]]}]})");
  const relief::DrawnModel model = built({}, "scene.json");
  EXPECT_EQ(model.drawing.rgba.width, 24);
  EXPECT_EQ(model.drawing.pixel_art, 1);
}

TEST_F(Sprites, HintsHaveTheSizeOfTheFile) {
  Image16 labels(24, 24, 1);
  Image8 mask(24, 24, 1);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) {
      labels.at(x, y) = man[y][x] == '.' ? 0 : y < 10 ? 2 : 1;
      mask.at(x, y) = man[y][x] != '.' && y < 10 ? 255 : 0;
    }
  write("labels.png", std::string(to_text(*encode_png(labels))));
  write("mask.png", std::string(to_text(*encode_png(mask))));
  write("strokes.json", R"({"format": "relievo-scribbles", "version": 1, "parts": ["head", "body"],
    "strokes": [{"kind": "hard", "part": "head", "width": 2, "points": [[12, 6]]},
                {"kind": "hard", "part": "body", "width": 2, "points": [[12, 12], [12, 14]]}]})");
  const Outcome outcome =
      relievo({"segment", "man.png", "--labels", "labels.png", "-o", "man.relievo"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("became 13 x 13"), std::string::npos) << outcome.err;
  const auto project = decode_project(to_bytes(read("man.relievo")));
  ASSERT_TRUE(project);
  EXPECT_EQ(project->segmentation->labels.pixels, enlarged(labels, 13).pixels);
  ASSERT_EQ(relievo({"segment", "man.png", "--figure", "mask.png", "-o", "head.relievo"}).exit_code,
            0);
  const auto head = decode_project(to_bytes(read("head.relievo")));
  ASSERT_TRUE(head);
  const Image16& found = head->segmentation->labels;
  EXPECT_NE(found.at(12 * 13, 5 * 13), 0);
  EXPECT_EQ(found.at(12 * 13, 12 * 13), 0);
  ASSERT_EQ(
      relievo({"segment", "man.png", "--scribbles", "strokes.json", "-o", "two.relievo"}).exit_code,
      0);
  const auto two = decode_project(to_bytes(read("two.relievo")));
  ASSERT_TRUE(two);
  EXPECT_NE(two->segmentation->labels.at(12 * 13, 6 * 13),
            two->segmentation->labels.at(12 * 13, 12 * 13));
}

TEST_F(Sprites, FramesHaveWholeMultiplesOfItsSizeAndItsColours) {
  for (const auto& [option, width] :
       {std::pair<const char*, int>{"1008", 1008}, {"24", 24}, {"", 24 * (1024 / 24)}}) {
    std::vector<std::string> words = {"sequence", "man.png", "-o", "maps", "--vertices", "500"};
    if (option[0] != 0) words.insert(words.end(), {"--map-size", option});
    ASSERT_EQ(relievo(words).exit_code, 0);
    const Image8 colour = picture("maps/man-colour.png");
    ASSERT_EQ(colour.width, width);
    EXPECT_EQ(colour.pixels, enlarged(sprite(), width / 24).pixels);
    EXPECT_EQ(picture("maps/man-normal.png").width, width);
  }
}

}  // namespace
}  // namespace relievo
