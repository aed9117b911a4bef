#include <cmath>

#include "cli/cli_test.h"
#include "io/image/decode_image.h"
#include "io/image/png.h"
#include "io/project/project_file.h"
#include "support/label_maps.h"

namespace relievo {
namespace {

using namespace testing;

/// A drawing of a leg on a body with its labels.
class Segment : public CliTest {
 protected:
  void SetUp() override {
    const Image16 labels = painted(120, 100, {oval(60, 35, 50, 28, 0), box(48, 35, 70, 92)});
    Image8 drawing(120, 100, 3, 255);
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 120; ++x)
        if (labels.at(x, y) > 0) drawing.at(x, y, labels.at(x, y)) = 60;
    write("fox.png", std::string(to_text(*encode_png(drawing))));
    write("labels.png", std::string(to_text(*encode_png(labels))));
  }
};

TEST_F(Segment, MakesASceneThatBuilds) {
  const Outcome outcome = relievo({"segment", "fox.png", "--labels", "labels.png", "-o", "fox.json",
                                   "--overlay", "overlay.png", "--report", "report.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("fox.json\n"), std::string::npos);
  EXPECT_NE(read("fox.json").find("\"drawing\": \"fox.png\""), std::string::npos);
  EXPECT_NE(read("report.json").find("\"confidence\""), std::string::npos);
  const auto overlay = decode_image(to_bytes(read("overlay.png")));
  ASSERT_TRUE(overlay.ok());
  EXPECT_EQ(overlay->width % 120, 0);
  const Outcome built = relievo({"build", "fox.json", "-o", "fox.glb", "--vertices", "2000"});
  EXPECT_EQ(built.exit_code, 0) << built.err;
}

TEST_F(Segment, AProjectBuildsAndSegmentsToTheSameAgain) {
  const std::vector<std::string> arguments = {"segment", "fox.png", "--labels", "labels.png"};
  auto to_project = arguments;
  to_project.insert(to_project.end(), {"-o", "fox.relievo"});
  ASSERT_EQ(relievo(to_project).exit_code, 0);
  ASSERT_EQ(relievo({"segment", "fox.relievo", "-o", "again.relievo"}).exit_code, 0);
  EXPECT_EQ(read("again.relievo"), read("fox.relievo"));
  auto to_scene = arguments;
  to_scene.insert(to_scene.end(), {"-o", "fox.json"});
  ASSERT_EQ(relievo(to_scene).exit_code, 0);
  for (const char* input : {"fox.relievo", "fox.json"})
    ASSERT_EQ(relievo({"build", input, "-o", std::string(input) + ".ply", "--vertices", "2000"})
                  .exit_code,
              0);
  EXPECT_EQ(read("fox.relievo.ply"), read("fox.json.ply"));
  const Outcome check = relievo({"check", "fox.relievo"});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("2 parts"), std::string::npos);
}

TEST_F(Segment, ShowsWhiteLinesOnGrey) {
  Image8 ring(120, 120, 4, 255);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x)
      ring.at(x, y, 3) = std::abs(std::hypot(x - 60, y - 60) - 40) < 3 ? 255 : 0;
  write("ring.png", std::string(to_text(*encode_png(ring))));
  ASSERT_EQ(
      relievo({"segment", "ring.png", "-o", "ring.relievo", "--overlay", "seen.png"}).exit_code, 0);
  const auto overlay = decode_image(to_bytes(read("seen.png")));
  ASSERT_TRUE(overlay.ok());
  EXPECT_LT(overlay->at(2, 2), 128);
  // In the line, which is lighter than what it surrounds, below the part's colour.
  const auto seen = [&](int y) {
    return overlay->at(60 * overlay->width / 120, y * overlay->height / 120);
  };
  EXPECT_GT(seen(20), seen(50) + 30);
}

TEST_F(Segment, KeepsWhatTheEditorPutIntoAProject) {
  ASSERT_EQ(
      relievo({"segment", "fox.png", "--labels", "labels.png", "-o", "fox.relievo"}).exit_code, 0);
  auto project = decode_project(to_bytes(read("fox.relievo")));
  ASSERT_TRUE(project.ok());
  const std::map<std::string, std::string> kept = {{"colors", R"({"part-1":"#ff8000"})"},
                                                   {"settings", R"({"vertices":9000})"}};
  project->other_keys = kept;
  write("edited.relievo", std::string(to_text(*encode_project(*project))));
  ASSERT_EQ(relievo({"segment", "edited.relievo", "-o", "again.relievo"}).exit_code, 0);
  EXPECT_EQ(decode_project(to_bytes(read("again.relievo")))->other_keys, kept);
}

/// A part of a scene file, from its id to the end of its line.
std::string part_line(const std::string& scene, const std::string& id) {
  const size_t at = scene.find("\"id\": \"" + id + "\"");
  return at == std::string::npos ? "" : scene.substr(at, scene.find('\n', at) - at);
}

TEST_F(Segment, FindsThePartsOfLineArt) {
  // Two discs with outlines, one over the other.
  const Image16 areas =
      painted(160, 120, {disc(60, 60, 40), disc(60, 60, 37), disc(105, 60, 35), disc(105, 60, 32)});
  Image8 lines(160, 120, 3, 255);
  Image8 strokes(160, 120, 4);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      const bool line = areas.at(x, y) % 2 == 1;
      for (int c = 0; c < 3; ++c) lines.at(x, y, c) = line ? 0 : 255;
      if (x < 100 || x > 110 || y < 55 || y > 65) continue;
      strokes.at(x, y, 0) = 255;
      strokes.at(x, y, 3) = 255;
    }
  write("lines.png", std::string(to_text(*encode_png(lines))));
  write("strokes.png", std::string(to_text(*encode_png(strokes))));
  ASSERT_EQ(relievo({"segment", "lines.png", "-o", "lines.json", "-q"}).exit_code, 0);
  const std::string plain = read("lines.json");
  EXPECT_NE(part_line(plain, "part-1"), "");
  EXPECT_NE(part_line(plain, "part-2"), "");
  EXPECT_EQ(part_line(plain, "part-3"), "");
  const Outcome named =
      relievo({"segment", "lines.png", "--scribbles", "strokes.png", "-o", "named.relievo", "-q"});
  ASSERT_EQ(named.exit_code, 0) << named.err;
  EXPECT_NE(relievo({"check", "named.relievo"}).out.find("#ff0000"), std::string::npos);
}

TEST_F(Segment, CopiesADrawingFromElsewhereOverNothing) {
  std::filesystem::create_directory(folder_.path() / "out");
  const std::vector<std::string> arguments = {"segment",    "fox.png", "--labels",
                                              "labels.png", "-o",      "out/a.json"};
  ASSERT_EQ(relievo(arguments).exit_code, 0);
  EXPECT_EQ(read("out/a.png"), read("fox.png"));
  ASSERT_EQ(relievo(arguments).exit_code, 0);
  write("out/a.png", "something else");
  for (int again = 0; again < 2; ++again) {
    const Outcome outcome = relievo(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(read("out/a.png"), "something else");
    EXPECT_EQ(read("out/a-2.png"), read("fox.png"));
  }
  EXPECT_FALSE(exists("out/a-3.png"));
  EXPECT_NE(read("out/a.json").find("\"a-2.png\""), std::string::npos);
}

TEST_F(Segment, APictureIsBuiltInOneStep) {
  const Outcome built =
      relievo({"build", "fox.png", "-o", "fox.ply", "--overlay", "seen.png", "--vertices", "2000"});
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_TRUE(decode_image(to_bytes(read("seen.png"))).ok());
  EXPECT_NE(built.err.find("was understood as"), std::string::npos) << built.err;
  EXPECT_NE(built.err.find("relievo segment fox.png --scribbles"), std::string::npos) << built.err;
  ASSERT_EQ(relievo({"segment", "fox.png", "-o", "fox.relievo"}).exit_code, 0);
  ASSERT_EQ(relievo({"build", "fox.relievo", "-o", "two.ply", "--vertices", "2000"}).exit_code, 0);
  EXPECT_EQ(read("fox.ply"), read("two.ply"));
}

TEST_F(Segment, HintsForALargePictureMayHaveItsSizeOrTheReducedOne) {
  const Image16 labels =
      painted(3600, 2400, {oval(1800, 840, 1500, 670, 0), box(1440, 840, 2100, 2200)});
  Image8 drawing(3600, 2400, 3, 255);
  Image8 mask(3600, 2400, 1);
  for (int y = 0; y < 2400; ++y)
    for (int x = 0; x < 3600; ++x)
      if (labels.at(x, y) > 0) {
        drawing.at(x, y, labels.at(x, y)) = 60;
        mask.at(x, y) = 255;
      }
  write("large.png", std::string(to_text(*encode_png(drawing))));
  write("large-labels.png", std::string(to_text(*encode_png(labels))));
  write("large-mask.png", std::string(to_text(*encode_png(mask))));
  write("strokes.json", R"({"format": "relievo-scribbles", "version": 1, "parts": ["body", "leg"],
    "strokes": [{"kind": "hard", "part": "body", "width": 40, "points": [[900, 840]]},
                {"kind": "hard", "part": "leg", "width": 40, "points": [[1800, 2000]]}]})");
  const Outcome outcome =
      relievo({"segment", "large.png", "--labels", "large-labels.png", "-o", "large.relievo"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("reduced to 1800 x 1200 px, 1/2"), std::string::npos) << outcome.err;
  const auto project = decode_project(to_bytes(read("large.relievo")));
  ASSERT_TRUE(project.ok());
  ASSERT_EQ(project->segmentation->labels.width, 1800);
  EXPECT_EQ(decode_image(project->drawing.bytes)->width, 1800);
  for (int y = 0; y < 1200; ++y)
    for (int x = 0; x < 1800; ++x)
      ASSERT_EQ(project->segmentation->labels.at(x, y), labels.at(2 * x + 1, 2 * y + 1));
  for (const std::vector<std::string>& hint :
       {std::vector<std::string>{"--figure", "large-mask.png"}, {"--scribbles", "strokes.json"}}) {
    const Outcome hinted =
        relievo({"segment", "large.png", hint[0], hint[1], "-o", "hinted.relievo"});
    ASSERT_EQ(hinted.exit_code, 0) << hinted.err;
    const auto found = decode_project(to_bytes(read("hinted.relievo")));
    ASSERT_TRUE(found.ok());
    EXPECT_EQ(found->scene.parts.size(), 2U) << hint[0];
    EXPECT_NE(found->segmentation->labels.at(900, 1000), 0) << hint[0];
  }
}

TEST_F(Segment, AMaskSaysWhatTheFigureIs) {
  Image8 mask(120, 100, 3);
  for (int y = 20; y < 80; ++y)
    for (int x = 30; x < 90; ++x)
      for (int c = 0; c < 3; ++c) mask.at(x, y, c) = 255;
  write("mask.png", std::string(to_text(*encode_png(mask))));
  const std::vector<std::string> arguments = {"segment",  "fox.png", "--figure",
                                              "mask.png", "-o",      "cut.relievo"};
  const Outcome outcome = relievo(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto project = decode_project(to_bytes(read("cut.relievo")));
  ASSERT_TRUE(project.ok());
  const Image16& labels = project->segmentation->labels;
  const auto drawing = decode_image(project->drawing.bytes);
  ASSERT_TRUE(drawing.ok());
  // Each pixel of the small picture became 3 x 3.
  ASSERT_EQ(labels.width, 360);
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) {
      ASSERT_EQ(labels.at(x, y) != 0, mask.at(x / 3, y / 3, 0) != 0) << x << ", " << y;
      ASSERT_EQ(drawing->at(x, y, 3) != 0, mask.at(x / 3, y / 3, 0) != 0) << x << ", " << y;
    }
  write("small.png", std::string(to_text(*encode_png(Image16(10, 10, 1)))));
  expect_failure({"segment", "fox.png", "--figure", "small.png", "-o", "a.json"}, 3, "120 x 100");
}

TEST_F(Segment, SaysWhatIsWrong) {
  expect_failure({"segment", "fox.png", "--labels", "labels.png", "--scribbles", "labels.png", "-o",
                  "fox.json"},
                 2, "--scribbles");
  expect_failure({"segment", "fox.png", "--labels", "fox.png", "-o", "fox.json"}, 3, "colours");
  write("small.png", std::string(to_text(*encode_png(Image16(10, 10, 1)))));
  expect_failure({"segment", "fox.png", "--labels", "small.png", "-o", "fox.json"}, 3, "120 x 100");
  write("empty.png", std::string(to_text(*encode_png(Image16(120, 100, 1)))));
  expect_failure({"segment", "fox.png", "--labels", "empty.png", "-o", "fox.json"}, 3, "no parts");
  expect_failure({"segment", "labels.png", "--labels", "labels.png", "-o", "fox.gif"}, 2, ".json");
  write("broken.relievo", "PK\x03\x04 no zip");
  expect_failure({"segment", "broken.relievo", "-o", "fox.json"}, 3, "broken.relievo");
}

}  // namespace
}  // namespace relievo
