#include "io/project/project_file.h"

#include <gtest/gtest.h>

#include <random>

#include "io/archive/archive.h"
#include "io/archive/zip_archive.h"
#include "io/image/png.h"
#include "io/project/project_json.h"
#include "io/scene/scene_json.h"
#include "io/support/damage.h"
#include "io/support/temporary_folder.h"
#include "support/label_maps.h"

namespace relievo {
namespace {

using namespace testing;

Part part(const std::string& id, double x0, double x1) {
  return {id, {{{x0, 10}, {x1, 10}, {x1, 60}, {x0, 60}}}, 3.5, -1};
}

/// A project that uses everything that one can hold; seeds have different labels.
Project everything(unsigned seed = 4) {
  Project project;
  project.name = "wölf";
  project.drawing = {"wolf.png", "image", "image/png", *encode_png(Image8(96, 80, 4, 200))};
  project.scene.width = 96;
  project.scene.height = 80;
  project.scene.drawing = "drawing";
  project.scene.parts = {part("body", 10, 60), part("leg", 40, 80)};
  understanding::SegmentationRecord& record = project.segmentation.emplace();
  record.labels = random_labels(seed);
  record.scribbles.parts = {"body", "leg"};
  record.scribbles.complete = true;
  record.scribbles.count = 12;
  record.scribbles.strokes = {{understanding::ScribbleKind::soft, 1, {{1, 2}, {3.25, 4}}, 5},
                              {understanding::ScribbleKind::outside, 0, {{90, 70}}, 3}};
  record.parts = {{300, "body", understanding::CompletionKind::ellipse},
                  {2, "leg", understanding::CompletionKind::membrane}};
  record.order = {{2, 300, 0.625, false, true}, {300, 7, 1, true, false}};
  record.joins = {{2, 300, 0.75}};
  understanding::Corrections& said = record.corrections;
  said.parts[2] = {"leg", Outline{{{0, 0}, {9, 0}, {9, 9}}}, 2.5, -1.0, 0.5, Point2{0, 0.25}};
  said.parts[300] = {};
  said.order = {{2, 300}};
  said.joins = {{2, 300, {{1, 1}, {2, 2.5}}}};
  said.no_joins = {{7, 2}};
  said.relations = {{7, 2, RelationKind::free, {{{1, 2}, {3, 4}}}},
                    {7, 300, RelationKind::equal, std::nullopt}};
  said.cues = {{2, CueKind::bulge, {{1, 1}, {2, 2.5}}, 1.25},
               {300, CueKind::crease, {{0, 1}, {5, 1}}, -40}};
  said.robin = {{2, 300, {1, 2}, {3, 4}, 0.25, std::nullopt}};
  return project;
}

Project reread(const Project& project) {
  const auto bytes = encode_project(project);
  EXPECT_TRUE(bytes.ok()) << (bytes.ok() ? "" : to_string(bytes.error()));
  auto again = decode_project(*bytes);
  EXPECT_TRUE(again.ok()) << (again.ok() ? "" : to_string(again.error()));
  return again.ok() ? std::move(*again) : Project();
}

TEST(ProjectFile, KeepsEverything) {
  const Project project = everything();
  const Project again = reread(project);
  EXPECT_EQ(write_project_json(again), write_project_json(project));
  EXPECT_EQ(*write_scene(again.scene), *write_scene(project.scene));
  EXPECT_EQ(again.drawing.bytes, project.drawing.bytes);
  ASSERT_TRUE(again.segmentation);
  EXPECT_EQ(again.segmentation->labels.pixels, project.segmentation->labels.pixels);
  // The text itself is compared with what was put in, so that nothing is lost in both.
  const understanding::Corrections& said = again.segmentation->corrections;
  EXPECT_EQ(said.parts.at(2).id, "leg");
  EXPECT_EQ(said.parts.at(2).outline, project.segmentation->corrections.parts.at(2).outline);
  EXPECT_FALSE(said.parts.at(300).c);
  ASSERT_EQ(said.cues.size(), 2U);
  EXPECT_EQ(said.cues[1].part, 300);
  EXPECT_EQ(said.cues[1].kind, CueKind::crease);
  EXPECT_EQ(said.cues[1].line, (std::vector<Point2>{{0, 1}, {5, 1}}));
  EXPECT_EQ(said.cues[1].value, -40);
  EXPECT_EQ(said.relations[0].range->second, (Point2{3, 4}));
  EXPECT_EQ(said.no_joins, project.segmentation->corrections.no_joins);
  EXPECT_EQ(again.segmentation->scribbles.strokes[0].part, 1);
  EXPECT_TRUE(again.segmentation->scribbles.complete);
  EXPECT_EQ(again.segmentation->scribbles.count, 12);
  EXPECT_EQ(again.segmentation->order[1].kept, false);
}

TEST(ProjectFile, KeepsKeysThatOnlyTheEditorUnderstands) {
  Project project = everything();
  project.other_keys = {{"colors", R"({"body":"#ff8000"})"},
                        {"settings", R"({"deep":[1,null,{"é":0.25}]})"}};
  const Project again = reread(project);
  EXPECT_EQ(again.other_keys, project.other_keys);
  EXPECT_EQ(*encode_project(again), *encode_project(project));
}

TEST(ProjectFile, GivesTheSameBytesWhateverTheTimeZone) {
  const auto here = encode_project(everything());
  setenv("TZ", "Asia/Tokyo", 1);
  tzset();
  const auto there = encode_project(everything());
  unsetenv("TZ");
  tzset();
  EXPECT_EQ(*here, *there);
  EXPECT_EQ(*here, *encode_project(reread(everything())));
}

TEST(ProjectFile, BeginsWithItsMimetype) {
  const auto bytes = encode_project(everything());
  EXPECT_TRUE(is_project(*bytes));
  EXPECT_EQ(std::string(to_text(*bytes)).substr(30, 31), "mimetypeapplication/vnd.relievo");
  const auto other = pack_archive({{"mimetype", to_bytes("image/openraster")}});
  EXPECT_FALSE(is_project(*other));
  EXPECT_FALSE(decode_project(*other).ok());
}

TEST(ProjectFile, OfALayeredDrawingNeedsNoSegmentation) {
  Project project = everything();
  project.segmentation.reset();
  project.scene.drawing = "drawing.png";
  project.picture = *encode_png(Image8(96, 80, 4, 100));
  const Project again = reread(project);
  EXPECT_FALSE(again.segmentation);
  EXPECT_EQ(again.picture, project.picture);
}

/// A project with one entry replaced, or removed where `text` is empty.
Result<Project> with_entry(const std::string& name, const std::string& text) {
  auto entries = unpack_archive(*encode_project(everything()));
  std::vector<ArchiveEntry> kept;
  for (ArchiveEntry& entry : *entries) {
    if (entry.name == name) entry.bytes = to_bytes(text);
    if (entry.name != name || !text.empty()) kept.push_back(std::move(entry));
  }
  return decode_project(*pack_archive(kept));
}

TEST(ProjectFile, SaysWhichEntryIsWrong) {
  for (const char* entry : {"project.json", "scene.json", "labels.png"}) {
    const auto missing = with_entry(entry, "");
    ASSERT_FALSE(missing.ok()) << entry;
    EXPECT_EQ(missing.error().where, entry);
    const auto broken = with_entry(entry, "{");
    ASSERT_FALSE(broken.ok()) << entry;
    EXPECT_EQ(broken.error().where.find(entry), 0U);
    EXPECT_EQ(broken.error().code, ErrorCode::bad_input);
  }
}

TEST(ProjectFile, RefusesNewerVersionsAndUnsoundValues) {
  const std::string good = write_project_json(everything());
  ASSERT_TRUE(read_project_json(good).ok());
  const auto refused = [&](const std::string& from, const std::string& to, const char* where) {
    std::string text = good;
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const auto project = read_project_json(text);
    ASSERT_FALSE(project.ok()) << to;
    EXPECT_NE(project.error().where.find(where), std::string::npos) << project.error().where;
  };
  refused("\"version\": 1", "\"version\": 2", "version");
  refused("\"version\": 1", "\"version\": 0", "version");
  refused("relievo-project", "relievo-scene", "format");
  refused("\"membrane\"", "\"magic\"", "segmentation.parts[1].completion");
  refused("\"label\": 300", "\"label\": 70000", "segmentation.parts[0].label");
  refused("\"confidence\": 0.625", "\"confidence\": 2", "segmentation.order[0].confidence");
  refused("\"kind\": \"soft\"", "\"kind\": \"loud\"", "strokes[0].kind");
  refused("\"width\": 5.0", "\"width\": 0", "strokes[0].width");
  refused("\"part\": \"leg\"", "\"part\": \"tail\"", "strokes[0].part");
  refused("\"no_joins\"", "\"no_join\"", "corrections.no_join");
}

TEST(ProjectFile, DamageOfTenSeedsNeverCrashes) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Bytes good = *encode_project(everything(seed));
    for (size_t length = 0; length < good.size(); length += 97)
      EXPECT_FALSE(decode_project(ByteView(good).first(length)).ok()) << length;
    survive_damage(good, 60, [](ByteView bytes) { return decode_project(bytes); });
    // Inside the archive no checksum protects the text.
    survive_damage(to_bytes(write_project_json(everything(seed))), 200, [](ByteView bytes) {
      return read_project_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
  }
}

TEST(ProjectFile, DamagedFilesAreRefusedOrRead) {
  const Bytes good = *encode_project(everything());
  std::mt19937 random(7);
  for (int trial = 0; trial < 400; ++trial) {
    Bytes bytes = good;
    for (int k = draw(random, 1, 4); k > 0; --k)
      bytes[random() % bytes.size()] ^= static_cast<uint8_t>(1U << (random() % 8));
    const auto project = decode_project(bytes);
    if (!project.ok()) {
      EXPECT_FALSE(project.error().message.empty());
    }
  }
}

}  // namespace
}  // namespace relievo
