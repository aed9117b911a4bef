#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "io/image/decode_image.h"
#include "io/image/png.h"
#include "io/project/project_file.h"
#include "relievo/bytes.h"

namespace relievo {
namespace {

/// A flat drawing without labels: two circles of ink, one above the other.
class SegmentDrawing : public CliTest {
 protected:
  void SetUp() override {
    Image8 drawing(240, 300, 3, 255);
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 240; ++x) {
        const double head = std::hypot(x - 120, y - 90) - 50;
        const double body = std::hypot(x - 120, y - 200) - 70;
        const bool ink = std::abs(head) < 2 || (std::abs(body) < 2 && head > 0);
        for (int c = 0; c < 3; ++c) drawing.at(x, y, c) = ink ? 20 : 255;
      }
    write_png("figure.png", drawing);
    write_png("blank.png", Image8(60, 40, 3, 255));
  }

  void write_png(const std::string& name, const Image8& image) const {
    const Bytes png = *encode_png(image);
    write(name, {png.begin(), png.end()});
  }
};

TEST_F(SegmentDrawing, PartsAreFoundAndBuilt) {
  const Outcome segmented = relievo({"segment", "figure.png", "-o", "figure.relievo"});
  ASSERT_EQ(segmented.exit_code, 0) << segmented.err;
  EXPECT_NE(segmented.err.find("2 parts,"), std::string::npos) << segmented.err;
  const Outcome built = relievo({"build", "figure.relievo", "-o", "figure.ply"});
  EXPECT_EQ(built.exit_code, 0) << built.err;
  EXPECT_TRUE(exists("figure.ply"));
}

TEST_F(SegmentDrawing, GivesThePartsAsLayersToPaintOn) {
  const Outcome outcome = relievo({"segment", "figure.png", "-o", "figure.psd"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Outcome check = relievo({"check", "figure.psd"});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  const auto parts_of = [](const std::string& text) { return text.substr(0, text.find(" part")); };
  const std::string parts = parts_of(outcome.err).substr(std::string("relievo: ").size());
  EXPECT_NE(check.out.find(", " + parts + " part"), std::string::npos) << check.out << outcome.err;
}

TEST_F(SegmentDrawing, AsManyPartsAreFoundAsAreSaidAndTheProjectKeepsIt) {
  const Outcome one = relievo({"segment", "figure.png", "--parts", "1", "-o", "one.relievo"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_NE(one.err.find("1 part,"), std::string::npos) << one.err;
  const auto project = decode_project(to_bytes(read("one.relievo")));
  ASSERT_TRUE(project.ok());
  EXPECT_EQ(project->segmentation->scribbles.count, 1);
  const Outcome two = relievo({"segment", "one.relievo", "--parts", "2", "-o", "two.relievo"});
  ASSERT_EQ(two.exit_code, 0) << two.err;
  EXPECT_NE(two.err.find("2 parts,"), std::string::npos) << two.err;
  expect_failure({"segment", "figure.png", "--parts", "0", "-o", "a.relievo"}, 2, "--parts");
}

TEST_F(SegmentDrawing, StrokesNameTheirParts) {
  write("strokes.json", R"({"format": "relievo-scribbles", "version": 1, "parts": ["snow head"],
    "strokes": [{"kind": "hard", "part": "snow head", "width": 4, "points": [[110, 80], [130, 80]]},
                {"kind": "hole", "width": 4, "points": [[120, 220]]}]})");
  const Outcome segmented =
      relievo({"segment", "figure.png", "--scribbles", "strokes.json", "-o", "scene.json"});
  ASSERT_EQ(segmented.exit_code, 0) << segmented.err;
  EXPECT_NE(segmented.err.find("1 part,"), std::string::npos) << segmented.err;
  EXPECT_NE(read("scene.json").find("\"snow head\""), std::string::npos);
}

TEST_F(SegmentDrawing, StrokesOnAProjectLeaveWhatWasSaidOfItsParts) {
  ASSERT_EQ(relievo({"segment", "figure.png", "-o", "figure.relievo"}).exit_code, 0);
  const std::string archive = read("figure.relievo");
  auto project = decode_project(to_bytes(archive));
  ASSERT_TRUE(project.ok());
  const understanding::PartLabel head = project->segmentation->labels.at(120, 90);
  const understanding::PartLabel body = project->segmentation->labels.at(120, 220);
  project->segmentation->corrections.parts[head].id = "head";
  project->segmentation->corrections.parts[head].c = 1.5;
  project->segmentation->corrections.parts[body].c = 2.5;
  const Bytes corrected = *encode_project(*project);
  write("corrected.relievo", {corrected.begin(), corrected.end()});
  write("strokes.json",
        R"({"format": "relievo-scribbles", "version": 1, "complete": false, "parts": ["belly"],
    "strokes": [{"kind": "hard", "part": "belly", "width": 4, "points": [[110, 220], [130, 220]]}]})");
  ASSERT_EQ(relievo({"segment", "corrected.relievo", "--scribbles", "strokes.json", "-o",
                     "again.relievo"})
                .exit_code,
            0);
  const auto again = decode_project(to_bytes(read("again.relievo")));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->segmentation->labels.at(120, 90), head);
  std::map<std::string, double> inflations;
  for (const Part& part : again->scene.parts) inflations[part.id] = part.c;
  ASSERT_EQ(inflations.size(), 2u);
  EXPECT_EQ(inflations["head"], 1.5);
  EXPECT_NE(inflations["belly"], 2.5) << "another part lies where that was said";
}

TEST_F(SegmentDrawing, PartsRemovedAndDrawnInTheEditorStaySo) {
  ASSERT_EQ(relievo({"segment", "figure.png", "-o", "figure.relievo"}).exit_code, 0);
  auto project = decode_project(to_bytes(read("figure.relievo")));
  ASSERT_TRUE(project.ok());
  // As the editor writes it: the record names all parts that were found, the scene has those that
  // there are.
  Scene& scene = project->scene;
  ASSERT_EQ(scene.parts.size(), 2U);
  const std::string removed = scene.parts[1].id;
  const std::string left = scene.parts[0].id;
  const Outline nose = {{{110, 180}, {130, 180}, {130, 200}, {110, 200}}};
  scene.parts = {scene.parts[0], {"nose", nose, 3, 1}};
  scene.joins.clear();
  scene.robin.clear();
  scene.relations = {{1, 0, RelationKind::equal, std::nullopt}};
  project->name = "my figure";
  const Bytes edited = *encode_project(*project);
  write("edited.relievo", {edited.begin(), edited.end()});

  ASSERT_EQ(relievo({"segment", "edited.relievo", "-o", "again.relievo"}).exit_code, 0);
  const auto again = decode_project(to_bytes(read("again.relievo")));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->name, "my figure");
  ASSERT_EQ(again->scene.parts.size(), 2U);
  EXPECT_EQ(again->scene.parts[0].id, left);
  EXPECT_EQ(again->scene.parts[1].id, "nose");
  EXPECT_EQ(again->scene.parts[1].outline[0].size(), 4U);
  ASSERT_EQ(again->scene.relations.size(), 1U);
  EXPECT_EQ(again->scene.relations[0].kind, RelationKind::equal);
  EXPECT_EQ(again->segmentation->parts.size(), 2U) << "so that it is known what was removed";
  // Once more from its own result, and with strokes on the part that was removed.
  ASSERT_EQ(relievo({"segment", "again.relievo", "-o", "third.relievo"}).exit_code, 0);
  EXPECT_EQ(read("third.relievo"), read("again.relievo"));
  const int y =
      again->segmentation->labels.at(120, 90) == again->segmentation->parts[1].label ? 90 : 220;
  write("strokes.json",
        R"({"format": "relievo-scribbles", "version": 1, "complete": false, "parts": [")" +
            removed + R"("], "strokes": [{"kind": "hard", "part": ")" + removed +
            R"(", "width": 4, "points": [[110, )" + std::to_string(y) + R"(], [130, )" +
            std::to_string(y) + "]]}]}");
  const Outcome back =
      relievo({"segment", "again.relievo", "--scribbles", "strokes.json", "-o", "back.relievo"});
  ASSERT_EQ(back.exit_code, 0) << back.err;
  EXPECT_EQ(decode_project(to_bytes(read("back.relievo")))->scene.parts.size(), 3U);
}

TEST_F(SegmentDrawing, AScribblePictureDoesTheSame) {
  Image8 strokes(240, 300, 4, 0);
  for (int y = 78; y < 84; ++y)
    for (int x = 110; x < 130; ++x) {
      strokes.at(x, y, 0) = 255;
      strokes.at(x, y, 3) = 255;
    }
  write_png("strokes.png", strokes);
  const Outcome segmented =
      relievo({"segment", "figure.png", "--scribbles", "strokes.png", "-o", "scene.json"});
  ASSERT_EQ(segmented.exit_code, 0) << segmented.err;
  EXPECT_NE(read("scene.json").find("\"#ff0000\""), std::string::npos);
}

TEST_F(SegmentDrawing, VectorsAreTakenAsThePictureThatTheyPaint) {
  // One path of ink around two areas, so that no shape of the file is a part.
  write("figure.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="240" height="300">
    <path d="M70 90 a50 50 0 0 1 100 0 a50 50 0 0 1 -100 0
             M96.4 134.1 a70 70 0 1 0 47.2 0" fill="none" stroke="black" stroke-width="4"/></svg>)");
  const Outcome segmented = relievo({"segment", "figure.svg", "-o", "figure.relievo"});
  ASSERT_EQ(segmented.exit_code, 0) << segmented.err;
  EXPECT_NE(segmented.err.find("2 parts,"), std::string::npos) << segmented.err;
  ASSERT_EQ(relievo({"segment", "figure.svg", "-o", "scene.json"}).exit_code, 0);
  const auto picture = decode_image(to_bytes(read("scene.png")));
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture->width, 1280);
  EXPECT_EQ(picture->height, 1600);
  for (const char* input : {"figure.relievo", "scene.json"})
    ASSERT_EQ(relievo({"build", input, "-o", std::string(input) + ".ply", "--vertices", "2000"})
                  .exit_code,
              0);
  EXPECT_EQ(read("figure.relievo.ply"), read("scene.json.ply"));
  ASSERT_EQ(relievo({"segment", "figure.relievo", "-o", "again.relievo"}).exit_code, 0);
  EXPECT_EQ(read("again.relievo"), read("figure.relievo"));
}

TEST_F(SegmentDrawing, ALayeredDrawingKeepsItsOwnParts) {
  write("figure.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400">
    <circle id="body" cx="200" cy="230" r="120" fill="#c84"/>
    <circle id="head" cx="200" cy="90" r="60" fill="#468"/></svg>)");
  for (const char* output : {"scene.json", "figure.relievo", "figure.psd"}) {
    const Outcome segmented = relievo({"segment", "figure.svg", "-o", output});
    ASSERT_EQ(segmented.exit_code, 0) << segmented.err;
    EXPECT_NE(segmented.err.find("2 parts,"), std::string::npos) << segmented.err;
  }
  const auto parts = nlohmann::json::parse(read("scene.json"))["parts"];
  EXPECT_EQ(parts[0]["id"], "body");
  EXPECT_EQ(parts[1]["id"], "head");
  EXPECT_EQ(decode_project(to_bytes(read("figure.relievo")))->scene.parts[1].id, "head");
  for (const char* input : {"scene.json", "figure.relievo", "figure.psd"})
    EXPECT_EQ(relievo({"build", input, "-o", "figure.glb", "--vertices", "2000"}).exit_code, 0);
  const Outcome again = relievo({"segment", "figure.psd", "-o", "again.json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(nlohmann::json::parse(read("again.json"))["parts"][1]["id"], "head");
  // An option that asks for parts finds them in the pixels.
  const Outcome asked = relievo({"segment", "figure.psd", "--parts", "2", "-o", "found.json"});
  ASSERT_EQ(asked.exit_code, 0) << asked.err;
  EXPECT_NE(nlohmann::json::parse(read("found.json"))["parts"][0]["id"], "body");
  expect_failure({"segment", "figure.svg", "-o", "a.json", "--report", "r.json"}, 2, "--report");
}

TEST_F(SegmentDrawing, MistakesAreExplained) {
  write("broken.svg", "<svg");
  expect_failure({"segment", "broken.svg", "-o", "a.relievo"}, 3, "broken.svg");
  expect_failure({"segment", "blank.png", "-o", "a.relievo"}, 3, "blank");
  write_png("small.png", Image8(9, 9, 4, 255));
  expect_failure({"segment", "figure.png", "--scribbles", "small.png", "-o", "a.relievo"}, 3,
                 "small.png");
  expect_failure({"segment", "figure.png", "--scribbles", "none.json", "-o", "a.relievo"}, 6,
                 "none.json");
}

}  // namespace
}  // namespace relievo
