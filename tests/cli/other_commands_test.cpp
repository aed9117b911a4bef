#include "cli/cli_test.h"
#include "io/image/decode_image.h"
#include "io/image/png.h"
#include "relievo/point.h"

namespace relievo {
namespace {

using Check = CliTest;
using Render = CliTest;
using Help = CliTest;

/// A layer of 100 x 120 px with a rectangle.
std::string layer(int x0, int y0, int x1, int y1) {
  Image8 image(100, 120, 4);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) image.at(x, y, 3) = 255;
  return std::string(to_text(*encode_png(image)));
}

class CheckLayers : public CliTest {
 protected:
  /// What `check` says of a folder of two such layers, back to front, of which it writes the scene.
  Outcome check(const std::pair<std::string, std::string>& back,
                const std::pair<std::string, std::string>& front) {
    std::filesystem::create_directory(folder_.path() / "layers");
    for (const auto& [name, bytes] : {back, front}) write("layers/" + name + ".png", bytes);
    Outcome outcome = relievo({"check", "layers", "-o", "scene-of-layers.json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome;
  }
};

TEST_F(Check, ExplainsPartsAndJoinsAndWritesNothing) {
  const auto before = folder_.names();
  const Outcome outcome = relievo({"check", "scene.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* word : {"2 parts", "body", "leg", "200 x 120", "join"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word << " in " << outcome.out;
  EXPECT_LT(outcome.out.find("body"), outcome.out.find("leg"));
  EXPECT_EQ(folder_.names(), before);
}

TEST_F(Check, TellsWhatAPrinterMakesOfASolid) {
  std::string text = scene_text;
  for (const char* foot : {"180,320", "220,320"})
    text.replace(text.find(foot), 7, std::string(foot, 4) + "380");
  write("long.json", text);
  const std::vector<std::string> solid = {"check", "long.json", "--profile", "solid"};
  const Outcome large = relievo(solid);
  EXPECT_EQ(large.exit_code, 0) << large.err;
  EXPECT_NE(large.out.find("ready to print"), std::string::npos) << large.out;
  // The leg is 40 px wide, of 280.
  std::vector<std::string> tiny = solid;
  tiny.insert(tiny.end(), {"--size", "7"});
  const std::string found = relievo(tiny).out;
  EXPECT_NE(found.find("leg hangs by 0."), std::string::npos) << found;
  tiny.insert(tiny.end(), {"--nozzle", "0.2"});
  EXPECT_NE(relievo(tiny).out.find("ready to print"), std::string::npos);
  const std::string over = relievo({"check", "scene.json", "--profile", "figure"}).out;
  EXPECT_NE(over.find("mm^2 of body hang over"), std::string::npos) << over;
}

TEST_F(Check, FindsThePartsThatStrokesEnclose) {
  write(
      "lines.svg",
      "<svg xmlns='http://www.w3.org/2000/svg' width='400' height='400'><g fill='none' "
      "stroke='#000' stroke-width='6'><circle cx='200' cy='240' r='110'/><circle cx='200' cy='90' "
      "r='50'/></g></svg>");
  const Outcome outcome = relievo({"check", "lines.svg"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("2 parts"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("made of lines"), std::string::npos) << outcome.err;
}

TEST_F(Check, FindsThePartsInThePictureWhereShapesThatArePaintedAreNotRead) {
  write(
      "faded.svg",
      "<svg xmlns='http://www.w3.org/2000/svg' width='400' height='400'><linearGradient id='fade'>"
      "<stop offset='0.4' stop-color='#36c'/><stop offset='1' stop-color='#36c' "
      "stop-opacity='0'/></linearGradient><circle cx='200' cy='200' r='150' fill='url(#fade)'/>"
      "<circle cx='150' cy='150' r='15'/></svg>");
  const Outcome outcome = relievo({"check", "faded.svg"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("not those that are painted"), std::string::npos) << outcome.err;
}

TEST_F(Check, FindsTheLettersOfADrawingThatIsTextAlone) {
  write("words.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100'><g id='title'>"
        "<text x='10' y='50'>Once upon a time</text></g></svg>");
  for (const char* command : {"check", "build"}) {
    std::vector<std::string> arguments = {command, "words.svg"};
    if (command == std::string("build")) arguments.insert(arguments.end(), {"-o", "words.glb"});
    const Outcome outcome = relievo(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* word : {"no shape of the drawing makes a part", "understood as "})
      EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " in " << outcome.err;
  }
}

TEST_F(Check, ListsCuesAndSaysWhichHaveNoEffect) {
  std::string text = scene_text;
  text.insert(text.rfind('}'), R"(, "cues": [
    { "part": "body", "kind": "crease", "line": [[50,160],[250,160]], "value": -30 },
    { "part": "leg", "kind": "bulge", "line": [[10,10],[20,20]], "value": 2 } ])");
  write("cued.json", text);
  const Outcome outcome = relievo({"check", "cued.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* word : {"crease", "-30 degrees", "150", "bulge"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word << " in " << outcome.out;
  EXPECT_NE(outcome.err.find("a bulge of \"leg\" lies outside that part"), std::string::npos);
  EXPECT_EQ(outcome.err.find("a crease"), std::string::npos) << outcome.err;
}

TEST_F(Check, ReadsDrawings) {
  const Outcome outcome = relievo({"check", "drawing.svg"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("head"), std::string::npos) << outcome.out;
}

TEST_F(Check, NamesAnOutlineThatCrossesItself) {
  write("eight.json", R"({ "format": "relievo-scene", "version": 1,
    "canvas": { "width": 400, "height": 300 },
    "parts": [ { "id": "knot", "outline": [[[100,50],[300,250],[300,50],[100,250]]] } ] })");
  const Outcome outcome = relievo({"check", "eight.json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("parts[0] (\"knot\"): its outline crosses itself at 200 150"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(relievo({"check", "scene.json"}).err.find("crosses"), std::string::npos);
}

TEST_F(Check, DrawsWhatItUnderstood) {
  const Outcome outcome = relievo({"check", "scene.json", "--overlay", "seen.png"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("seen.png"), std::string::npos);
  const auto picture = decode_image(to_bytes(read("seen.png")));
  ASSERT_TRUE(picture);
  ASSERT_EQ(picture->width, 1200);  // 3 px for each of the canvas
  const auto channel = [&](int x, int y, int c) { return picture->at(3 * x, 3 * y, c); };
  // The join is blue, the ranges that follow from it go from green to red.
  EXPECT_GT(channel(200, 160, 2), channel(200, 160, 0) + 150);
  for (const int x : {180, 220}) {
    EXPECT_GT(channel(x, 166, 1), channel(x, 166, 0) + 50);
    EXPECT_GT(channel(x, 214, 0), channel(x, 214, 1) + 50);
  }
  // The body's outline under the leg is magenta; nothing is drawn outside.
  EXPECT_GT(std::min(channel(200, 220, 0), channel(200, 220, 2)), channel(200, 220, 1) + 100);
  EXPECT_EQ(channel(50, 50, 1), 255);
}

TEST_F(Check, DrawsWhatLiesBehindInADarkerShade) {
  std::string scene = scene_text;
  scene.replace(scene.find("\"joins\""), std::string::npos, R"("relations": [
    { "upper": "leg", "lower": "body", "relation": "below", "range": [[180,300],[220,300]] } ] })");
  write("behind.json", scene);
  ASSERT_EQ(relievo({"check", "behind.json", "--overlay", "seen.png"}).exit_code, 0);
  const auto picture = decode_image(to_bytes(read("seen.png")));
  ASSERT_TRUE(picture);
  for (const Point2 p : {Point2{180, 190}, Point2{200, 160}, Point2{220, 190}, Point2{200, 220}}) {
    const auto x = static_cast<int>(3 * p.x);
    const auto y = static_cast<int>(3 * p.y);
    EXPECT_NEAR(picture->at(x, y, 0), 0x70, 8) << p.x << " " << p.y;
    EXPECT_NEAR(picture->at(x, y, 1), 0, 8);
    EXPECT_NEAR(picture->at(x, y, 2), 0x60, 8);
  }
}

TEST_F(Check, OverlayObeysTheRulesOfFiles) {
  expect_failure({"check", "scene.json", "--overlay", "seen.jpg"}, 2, ".png");
  expect_failure({"check", "scene.json", "--overlay", "nowhere/seen.png"}, 6, "folder");
  std::filesystem::create_directory(folder_.path() / "layers");
  write("layers/body.png", layer(10, 20, 90, 60));
  expect_failure({"check", "layers", "--overlay", "layers/body.png"}, 2, "never overwritten");
}

TEST_F(Check, ReadsAFolderOfLayers) {
  std::filesystem::create_directory(folder_.path() / "layers");
  write("layers/body.png", layer(10, 20, 90, 60));
  const Outcome outcome = relievo({"check", "layers"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("body"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("80 x 40"), std::string::npos) << outcome.out;
  expect_failure({"build", "layers", "--preview", "layers/body.png", "-o", "m.glb"}, 2, "body.png");
  std::filesystem::create_directory(folder_.path() / "empty");
  expect_failure({"build", "empty", "-o", "m.glb"}, 3, "holds no layers");
}

TEST_F(CheckLayers, ListsJoinsOfLimbsBehind) {
  const Outcome guessed =
      check({"1-far-leg", layer(40, 40, 56, 110)}, {"2-body", layer(10, 10, 90, 70)});
  ASSERT_EQ(guessed.exit_code, 0);
  const std::string line = guessed.out.substr(guessed.out.find("\njoin ") + 1);
  for (const char* word : {"2-body", "1-far-leg", "from behind", "% sure"})
    EXPECT_LT(line.find(word), line.find('\n')) << word << " in " << guessed.out;
  const Outcome said = relievo({"check", "scene-of-layers.json"});
  EXPECT_NE(said.out.find("from behind"), std::string::npos) << said.out;
  EXPECT_EQ(said.out.find("guessed"), std::string::npos) << said.out;
}

TEST_F(CheckLayers, GuessesHowLayersConnectAndWritesTheScene) {
  const Outcome outcome =
      check({"1-body", layer(10, 10, 90, 70)}, {"2-leg", layer(40, 40, 56, 110)});
  ASSERT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("guessed"), std::string::npos) << outcome.out;
  EXPECT_NE(read("scene-of-layers.json").find("\"upper\": \"2-leg\""), std::string::npos);
  EXPECT_TRUE(exists("scene-of-layers.png"));
  EXPECT_EQ(relievo({"build", "scene-of-layers.json", "-o", "m.obj"}).exit_code, 0);
  const Outcome stacked = relievo({"check", "layers", "--connect", "none"});
  EXPECT_EQ(stacked.exit_code, 0) << stacked.err;
  EXPECT_EQ(stacked.out.find("guessed"), std::string::npos) << stacked.out;
  expect_failure({"check", "layers", "--connect", "some"}, 2, "connect");
}

TEST_F(Render, DrawsScenesAndModels) {
  ASSERT_EQ(relievo({"build", "drawing.svg", "-o", "m.glb", "--vertices", "3000"}).exit_code, 0);
  for (const char* input : {"m.glb", "drawing.svg"}) {
    const Outcome outcome = relievo({"render", input, "-o", "p.png", "--size", "120"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "p.png\n");
    const auto picture = decode_image(to_bytes(read("p.png")));
    ASSERT_TRUE(picture);
    EXPECT_EQ(std::max(picture->width, picture->height), 120);
  }
}

TEST_F(Render, OptionsChangeThePicture) {
  ASSERT_EQ(relievo({"build", "drawing.svg", "-o", "m.glb", "--vertices", "3000"}).exit_code, 0);
  const auto picture = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments = {"render", "m.glb", "-o", "p.png", "--size", "100"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = relievo(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read("p.png");
  };
  const std::string plain = picture({});
  EXPECT_EQ(picture({"--view", "three-quarter"}), plain);
  for (const std::vector<std::string>& change :
       std::vector<std::vector<std::string>>{{"--view", "front"},
                                             {"--view", "side"},
                                             {"--view", "sheet"},
                                             {"--yaw", "-40"},
                                             {"--pitch", "30"},
                                             {"--light", "60", "10"},
                                             {"--clay"},
                                             {"--window", "200", "100", "80"}})
    EXPECT_FALSE(picture(change) == plain) << change[0] << " " << change.back();
}

TEST_F(Help, IsAResultAndBeginsWithExamples) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--help"},
                                             {"help"},
                                             {"help", "segment"},
                                             {"build", "--help"},
                                             {"check", "-h"},
                                             {"render", "-h"}}) {
    const Outcome outcome = relievo(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_LT(outcome.out.find("Example"), outcome.out.find("Usage"));
  }
}

TEST_F(Help, LostResultsAreAFailure) {
  const Outcome outcome = run_into("/dev/full", folder_.path(), {"check", "scene.json"});
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_NE(outcome.err.find("standard output"), std::string::npos) << outcome.err;
}

TEST_F(Help, TellsTheVersion) {
  const Outcome outcome = relievo({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.substr(0, 8), "relievo ");
  EXPECT_EQ(outcome.err, "");
}

}  // namespace
}  // namespace relievo
