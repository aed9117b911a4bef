#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "io/image/decode_image.h"
#include "io/image/png.h"

namespace relievo {
namespace {

/// A body that stands still and an arm that hangs from it, turned by so many degrees; the order of
/// the layers may be another one.
std::string frame_text(double degrees, bool arm_first = false) {
  const std::string body =
      R"(<g id="body" data-relievo="part"><circle cx="150" cy="150" r="90" fill="#a65"/></g>)";
  const std::string arm =
      R"(<g id="arm" data-relievo="part"><rect x="300" y="60" width="40" height="150" fill="#56a" )"
      R"(transform="rotate()" +
      std::to_string(degrees) + R"x( 320 80)"/></g>)x";
  return R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300">)" +
         (arm_first ? arm + body : body + arm) + "</svg>";
}

class Sequence : public CliTest {
 protected:
  Image8 pixels(const std::string& name) const {
    const std::string text = read(name);
    auto image = decode_image({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
    EXPECT_TRUE(image) << name;
    return image ? *image : Image8();
  }

  void write_picture(const std::string& name, const Image8& rgba) const {
    const auto bytes = encode_png(rgba);
    write(name, std::string(bytes->begin(), bytes->end()));
  }

  nlohmann::json report(const std::string& name) const { return nlohmann::json::parse(read(name)); }
};

/// A filled disc with a dark outline.
void draw_disc(Image8& rgba, double cx, double cy, double radius) {
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const double r = std::hypot(x - cx, y - cy);
      if (r > radius) continue;
      const bool ink = r > radius - 3;
      for (int c = 0; c < 3; ++c) rgba.at(x, y, c) = ink ? 20 : static_cast<uint8_t>(120 + 40 * c);
      rgba.at(x, y, 3) = 255;
    }
}

TEST_F(Sequence, KeepsScaleNumbersAndWhatStandsStill) {
  write("a.svg", frame_text(0));
  write("b.svg", frame_text(25, true));
  const Outcome outcome =
      relievo({"sequence", "a.svg", "b.svg", "-o", "maps", "--vertices", "2000", "--map-size",
               "200", "--make", "colour,normal,depth,part,occlusion"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = report("maps/sequence.json");
  EXPECT_EQ(json["parts"], (std::vector<std::string>{"body", "arm"}));
  const auto& second = json["frames"][1];
  EXPECT_GT(second["still"], 0.5);
  EXPECT_LT(second["change"]["most99"], 0.01);
  const Image8 part_a = pixels("maps/a-part.png");
  const Image8 part_b = pixels("maps/b-part.png");
  // Of the middle of the body, whatever the order of the layers.
  const Image8 depth_a = pixels("maps/a-depth.png");
  const Image8 depth_b = pixels("maps/b-depth.png");
  EXPECT_EQ(part_a.at(75, 75), part_b.at(75, 75));
  EXPECT_NEAR(depth_a.at(75, 75), depth_b.at(75, 75), 2);
  EXPECT_EQ(pixels("maps/a-normal.png").width, 200);
  EXPECT_EQ(pixels("maps/a-occlusion.png").at(1, 1), 255);
  EXPECT_EQ(pixels("maps/a-colour.png").at(75, 75, 0), 0xaa);
}

/// The figures of docs/sequence.md.
TEST_F(Sequence, OfAWalkDoesNotFlicker) {
  const std::string script = std::string(RELIEVO_EXAMPLES) + "/../scripts/walk-frames.sh";
  ASSERT_EQ(std::system(("sh '" + script + "' '" + folder_.path().string() + "'").c_str()), 0);
  std::vector<std::string> arguments = {"sequence", "-o", "maps", "--map-size", "256"};
  for (int k = 0; k < 10; ++k) arguments.push_back("walk-" + std::to_string(k) + ".svg");
  const Outcome outcome = relievo(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = report("maps/sequence.json");
  for (size_t k = 1; k < json["frames"].size(); ++k) {
    const auto& frame = json["frames"][k];
    EXPECT_GT(frame["still"], 0.6) << k;
    EXPECT_LT(frame["change"]["median"], 0.00001) << k;
    EXPECT_LT(frame["change"]["most99"], 0.005) << k;
    EXPECT_LT(frame["change"]["most"], 0.04) << k;
  }
}

TEST_F(Sequence, GivesTheSameBytesAgain) {
  write("a.svg", frame_text(0));
  write("b.svg", frame_text(25));
  std::vector<std::string> arguments = {"sequence",  "a.svg", "b.svg", "--vertices", "2000",
                                        "--columns", "2",     "-o",    "one"};
  ASSERT_EQ(relievo(arguments).exit_code, 0);
  arguments.back() = "two";
  ASSERT_EQ(relievo(arguments).exit_code, 0);
  for (const char* name :
       {"sheet-colour.png", "sheet-normal.png", "sheet-depth.png", "sheet.json", "sequence.json"})
    EXPECT_EQ(read("one/" + std::string(name)), read("two/" + std::string(name))) << name;
}

/// The same sprites on a grid, and on a sheet where one has lost its margins and lies turned.
TEST_F(Sequence, MapsOfASheetHaveItsLayout) {
  Image8 grid(300, 100, 4);
  draw_disc(grid, 50, 50, 40);
  draw_disc(grid, 260, 45, 30);
  write_picture("grid.png", grid);
  ASSERT_EQ(
      relievo({"sequence", "grid.png", "--grid", "3x1", "-o", "g", "--vertices", "1000"}).exit_code,
      0);
  // Of the third sprite columns 20 to 99 and rows 10 to 79, turned clockwise, at (110, 5).
  Image8 packed(200, 100, 4);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x)
      for (int c = 0; c < 4; ++c) packed.at(x, y, c) = grid.at(x, y, c);
  for (int y = 0; y < 70; ++y)
    for (int x = 0; x < 80; ++x)
      for (int c = 0; c < 4; ++c) packed.at(110 + 69 - y, 5 + x, c) = grid.at(220 + x, 10 + y, c);
  write_picture("packed.png", packed);
  write("packed.json", R"({ "frames": {
    "roll 2": { "frame": {"x":110,"y":5,"w":80,"h":70}, "rotated": true, "trimmed": true,
      "spriteSourceSize": {"x":20,"y":10,"w":80,"h":70}, "sourceSize": {"w":100,"h":100} },
    "roll 0": { "frame": {"x":0,"y":0,"w":100,"h":100} } },
    "meta": { "image": "packed.png" } })");
  const Outcome outcome = relievo({"sequence", "packed.json", "-o", "p", "--vertices", "1000"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* kind : {"colour", "normal", "depth"}) {
    const Image8 g = pixels(std::string("g/grid-") + kind + ".png");
    const Image8 p = pixels(std::string("p/packed-") + kind + ".png");
    ASSERT_EQ(g.width, 300);
    ASSERT_EQ(p.width, 200);
    for (int y = 0; y < 70; ++y)
      for (int x = 0; x < 80; ++x)
        for (int c = 0; c < g.channels; ++c)
          ASSERT_EQ(p.at(110 + 69 - y, 5 + x, c), g.at(220 + x, 10 + y, c)) << kind;
    // Nothing is drawn on the second cell of the grid.
    EXPECT_EQ(g.at(150, 50), kind == std::string("normal") ? 128 : 0);
  }
}

/// Programs write lists with paths of their own machine, without a picture, or in an atlas.
TEST_F(Sequence, FindsThePictureOfAListBesideIt) {
  Image8 sheet(60, 60, 4);
  draw_disc(sheet, 30, 30, 25);
  write_picture("roll.png", sheet);
  const std::string frames = R"("frames": [{ "frame": {"x":0,"y":0,"w":60,"h":60} }])";
  for (const std::string& list :
       {"{" + frames + R"(, "meta": { "image": "/home/someone/out/roll.png" } })",
        "{" + frames + R"(, "meta": { "image": "C:\\art\\roll.png" } })",
        "{" + frames + R"(, "meta": { "image": "packed/sheet.png" } })", "{" + frames + "}",
        R"({ "textures": [{ "image": "roll.png", )" + frames + "}] }"}) {
    write("roll.json", list);
    const Outcome outcome = relievo({"sequence", "roll.json", "-o", "maps", "--vertices", "300"});
    EXPECT_EQ(outcome.exit_code, 0) << list << outcome.err;
    EXPECT_EQ(report("maps/sequence.json")["frames"].size(), 1u);
  }
}

TEST_F(Sequence, RefusesListsOfLayersAndOfSeveralPictures) {
  write_picture("roll.png", Image8(60, 60, 4));
  const auto refused = [&](const std::string& list, const std::string& reason) {
    write("roll.json", list);
    expect_failure({"sequence", "roll.json", "-o", "maps"}, 3, reason);
  };
  const std::string frame = R"("frame": {"x":0,"y":0,"w":6,"h":6})";
  const auto pair = [&](const std::string& a, const std::string& b, const std::string& meta) {
    return R"({ "frames": { ")" + a + "\": {" + frame + "}, \"" + b + "\": {" + frame +
           R"(} }, "meta": {)" + meta + "} }";
  };
  const std::string layers = R"("layers": [{"name":"body"},{"name":"head"}])";
  refused(pair("roll (body) 0.ase", "roll (head) 0.ase", layers), "layers of a frame (body, head)");
  refused(pair("roll-body-0", "roll-head-0", layers), "layers of a frame");
  refused(pair("roll (a) 0", "roll (b) 0", R"("app": "http://www.aseprite.org/")"), "layers");
  refused(R"({ "textures": [{ "image": "a.png", "frames": [] }, { "image": "b.png" }] })",
          "multi-atlas");
  refused(pair("a", "b", R"("related_multi_packs": ["roll-1.json"])"), "multi-atlas");
  // Frames of one name with numbers in parentheses are frames.
  write("roll.json", pair("roll (1).png", "roll (2).png", layers));
  EXPECT_EQ(relievo({"sequence", "roll.json", "-o", "maps"}).exit_code, 0);
}

TEST_F(Sequence, NamesWhatIsWrong) {
  write("a.svg", frame_text(0));
  std::filesystem::create_directory(folder_.path() / "more");
  write("more/a.svg", frame_text(5));
  expect_failure({"sequence", "a.svg", "more/a.svg", "-o", "maps"}, 2, "more/a.svg");
  expect_failure({"sequence", "a.svg", "drawing.svg", "-o", "maps"}, 3, "drawing");
  expect_failure({"sequence", "a.svg", "--grid", "2x", "-o", "maps"}, 2, "8x2");
  expect_failure({"sequence", "a.svg", "--grid", "2x2", "-o", "maps"}, 3, "a.svg");
  Image8 sheet(50, 40, 4);
  write_picture("sheet.png", sheet);
  expect_failure({"sequence", "sheet.png", "--grid", "3x2", "-o", "maps"}, 3, "50 x 40");
  const auto list = [&](const std::string& frame, const std::string& image) {
    write("list.json", R"({ "frames": [ { "frame": )" + frame + R"( } ], "meta": { "image": ")" +
                           image + R"(" } })");
  };
  list(R"({"x":20,"y":0,"w":40,"h":40})", "sheet.png");
  expect_failure({"sequence", "list.json", "-o", "maps"}, 3, "sheet.png");
  list(R"({"x":-1,"y":0,"w":40,"h":40})", "sheet.png");
  expect_failure({"sequence", "list.json", "-o", "maps"}, 3, "frames[0].frame.x");
  list(R"({"x":0,"y":0,"w":40,"h":40})", "../other.png");
  expect_failure({"sequence", "list.json", "-o", "maps"}, 3, "meta.image");
  list(R"({"x":0,"y":0,"w":4,"h":4}, "sourceSize": {"w":32767,"h":32767})", "sheet.png");
  expect_failure({"sequence", "list.json", "-o", "maps"}, 5, "too many pixels");
  expect_failure({"sequence", "sheet.png", "a.svg", "--grid", "1x1", "-o", "maps"}, 2, "sheet");
}

}  // namespace
}  // namespace relievo
