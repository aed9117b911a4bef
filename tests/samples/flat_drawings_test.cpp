#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "io/image/decode_image.h"
#include "io/scribbles/scribbles_json.h"
#include "io/svg/read_svg.h"
#include "io/svg/render_svg.h"
#include "kernel/image/outlines.h"
#include "relievo/files.h"
#include "understanding/labels/segment_drawing.h"
#include "understanding/scene/propose_scene.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

class FlatDrawings : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(folder_)) GTEST_SKIP() << "the flat drawings are not at " << folder_;
  }

  Drawing drawing(const std::string& name) const {
    const Result<Bytes> bytes = read_file(folder_ / name);
    EXPECT_TRUE(bytes.ok()) << name;
    if (fs::path(name).extension() == ".svg")
      return *render_svg(
          read_svg({reinterpret_cast<const char*>(bytes->data()), bytes->size()})->paintable, 792,
          612);
    return {*decode_image(*bytes)};
  }

  Result<understanding::Segmentation> segment(const std::string& name) const {
    return understanding::segment_drawing(drawing(name));
  }

  Result<understanding::Segmentation> segment(const std::string& name,
                                              const std::string& strokes) const {
    return understanding::segment_drawing(drawing(name), scribbles("scribbles/" + strokes));
  }

  understanding::Scribbles scribbles(const std::string& name) const {
    const Result<Bytes> bytes = read_file(fs::path(RELIEVO_TEST_DATA) / (name + ".json"));
    const Result<understanding::Scribbles> scribbles =
        read_scribbles({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    EXPECT_TRUE(scribbles.ok()) << (scribbles.ok() ? "" : to_string(scribbles.error()));
    return *scribbles;
  }

  /// Intersection over union of all parts and the figure as another person cut it out.
  double agreement_with_mask(const understanding::Segmentation& s, const std::string& name) const {
    const Image8 mask = drawing(name + "/mask.png").rgba;
    double both = 0;
    double either = 0;
    for (size_t i = 0; i < s.labels.pixels.size(); ++i) {
      const bool ours = s.labels.pixels[i] != 0;
      const bool theirs = mask.pixels[4 * i] > 127;
      both += ours && theirs ? 1 : 0;
      either += ours || theirs ? 1 : 0;
    }
    return both / either;
  }

  const fs::path folder_ = fs::path(RELIEVO_SHARED_DATA) / "flat";
};

/// A point of the drawing and the name that the test gives to the part there; "" is background.
struct Spot {
  int x, y;
  std::string part;
};

/// Points of one name must have one label, others another.
void expect_parts(const understanding::Segmentation& s, const std::vector<Spot>& spots) {
  std::map<std::string, int> label_of = {{"", 0}};
  std::map<int, std::string> name_of = {{0, ""}};
  for (const Spot& spot : spots) {
    const int label = s.labels.at(spot.x, spot.y);
    EXPECT_EQ(label_of.emplace(spot.part, label).first->second, label)
        << spot.part << " at " << spot.x << ", " << spot.y;
    EXPECT_EQ(name_of.emplace(label, spot.part).first->second, spot.part)
        << "at " << spot.x << ", " << spot.y;
  }
}

TEST_F(FlatDrawings, Chicken) {
  const Result<understanding::Segmentation> s = segment("F06_chicken_tuxpaint.png");
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_LE(s->parts.size(), 14U) << "blades of grass are tubes";
  expect_parts(*s, {{10, 10, ""},
                    {420, 200, ""},
                    {200, 100, "head"},
                    {180, 200, "head"},
                    {240, 45, "head"},
                    {200, 290, "body"},
                    {50, 270, "left wing"},
                    {350, 270, "right wing"}});
}

TEST_F(FlatDrawings, Frog) {
  const Result<understanding::Segmentation> s = segment("F07_frog_tuxpaint.png");
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  expect_parts(*s, {{20, 20, ""},
                    {470, 200, "near eye"},
                    {519, 195, "near eye"},
                    {600, 220, "far eye"},
                    {420, 330, "body"},
                    {340, 300, "body"},
                    {270, 380, "thigh"},
                    {120, 450, "far leg"},
                    {620, 350, "far arm"}});
  EXPECT_FALSE(s->bridges.empty());
}

TEST_F(FlatDrawings, Snowman) {
  const Result<understanding::Segmentation> s = segment("F08_snowman_stamp.png");
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  expect_parts(*s, {{10, 60, ""},
                    {130, 40, "hat"},
                    {130, 110, "hat"},
                    {110, 180, "head"},
                    {80, 270, "upper ball"},
                    {60, 380, "lower ball"},
                    {200, 360, "broom"}});
}

TEST_F(FlatDrawings, Pig) {
  const Result<understanding::Segmentation> s = segment("F09_pig_lear.gif");
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_LE(s->parts.size(), 20U);
  expect_parts(*s, {{10, 10, ""}, {200, 120, "body"}, {250, 150, "body"}, {60, 110, "head"}});
}

/// Few strokes are all the parts that there are, and nothing of the figure is lost to them.
TEST_F(FlatDrawings, FewStrokesNameAllParts) {
  for (const auto& [name, strokes] : std::map<std::string, std::string>{
           {"F03_kid_stick/texture.png", "F03_kid_stick"},
           {"F06_chicken_tuxpaint.png", "F06_chicken_tuxpaint"},
           {"F07_frog_tuxpaint.png", "F07_frog_tuxpaint"},
           {"F08_snowman_stamp.png", "F08_snowman_stamp"},
           {"F10_cat_carrot.png", "F10_cat_carrot"},
           {"F12_sleeping_cat_openclipart.svg", "F12_sleeping_cat_openclipart"}}) {
    const Result<understanding::Segmentation> plain = segment(name);
    const Result<understanding::Segmentation> s = segment(name, strokes);
    ASSERT_TRUE(plain.ok() && s.ok()) << name;
    EXPECT_GE(s->parts.size(), 5U) << name;
    EXPECT_LE(s->parts.size(), 8U) << name;
    for (const understanding::SegmentedPart& part : s->parts)
      EXPECT_FALSE(part.proposed) << name << part.id;
    EXPECT_TRUE(s->notes.empty()) << name << ": a part without any area";
    for (size_t i = 0; i < s->labels.pixels.size(); ++i)
      ASSERT_EQ(s->labels.pixels[i] == 0, plain->labels.pixels[i] == 0) << name << " " << i;
  }
}

/// Four dots tell the ground between the legs from a belly, which has the same lines.
TEST_F(FlatDrawings, PigWithDotsOnTheGround) {
  const Result<understanding::Segmentation> s = segment("F09_pig_lear.gif", "F09_pig_lear_ground");
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_LE(s->parts.size(), 10U) << "the tail and what is drawn of the ground are tubes";
  expect_parts(*s, {{10, 10, ""},
                    {105, 205, ""},
                    {140, 200, ""},
                    {180, 205, ""},
                    {222, 195, ""},
                    {200, 120, "body"},
                    {95, 185, "body"},
                    {248, 205, "body"}});
}

TEST_F(FlatDrawings, Cat) {
  const Result<understanding::Segmentation> s = segment("F10_cat_carrot.png");
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_LE(s->parts.size(), 10U);
  expect_parts(*s, {{5, 5, ""}, {100, 60, "head"}, {30, 62, "tail"}});
}

TEST_F(FlatDrawings, SleepingCat) {
  const Result<understanding::Segmentation> s = segment("F12_sleeping_cat_openclipart.svg");
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_LE(s->parts.size(), 12U);
  expect_parts(*s, {{10, 10, ""}, {200, 270, "head"}, {500, 170, "body"}});
  EXPECT_FALSE(s->bridges.empty());
}

TEST_F(FlatDrawings, PhotographsAndScansNeedOneStrokeAPart) {
  for (const auto& [name, strokes] : std::map<std::string, std::string>{
           {"F01_kid_man/texture.png", "F01_kid_man"},
           {"F02_kid_bug/texture.png", "F02_kid_bug"},
           {"F04_gopher_dandy_pencil.png", "F04_gopher_dandy_pencil"},
           {"F05_gopher_pirate_pencil.png", "F05_gopher_pirate_pencil"}}) {
    const Result<understanding::Segmentation> s = segment(name, strokes);
    ASSERT_TRUE(s.ok()) << name << ": " << to_string(s.error());
    EXPECT_TRUE(s->notes.empty()) << s->notes[0];
    double drawn = 0;
    double proposed = 0;
    for (const understanding::SegmentedPart& part : s->parts)
      (part.proposed ? proposed : drawn) += static_cast<double>(part.area);
    EXPECT_LT(proposed, 0.05 * drawn) << name;
    EXPECT_EQ(s->labels.at(2, 2), 0) << name;
  }
}

/// What is not understood of a drawing alone takes eight strokes at most.
TEST_F(FlatDrawings, FewStrokesMendWhatIsWrong) {
  const std::map<std::string, std::vector<Spot>> spots = {{"F01_kid_man/texture.png",
                                                           {{10, 10, ""},
                                                            {250, 310, "trunk"},
                                                            {110, 260, "left arm"},
                                                            {400, 235, "right arm"},
                                                            {225, 110, "head"},
                                                            {180, 440, "left leg"},
                                                            {370, 430, "right leg"}}},
                                                          {"F02_kid_bug/texture.png",
                                                           {{5, 5, ""},
                                                            {225, 127, ""},
                                                            {250, 131, ""},
                                                            {215, 109, "upper arm"},
                                                            {225, 143, "lower arm"},
                                                            {130, 180, "body"}}},
                                                          {"F04_gopher_dandy_pencil.png",
                                                           {{5, 5, ""},
                                                            {92, 425, ""},
                                                            {66, 425, "umbrella"},
                                                            {105, 540, "umbrella"},
                                                            {232, 627, "left foot"},
                                                            {394, 624, "right foot"},
                                                            {240, 290, "body"}}},
                                                          {"F05_gopher_pirate_pencil.png",
                                                           {{5, 5, ""},
                                                            {40, 205, "parrot"},
                                                            {85, 280, "parrot"},
                                                            {150, 425, "belly"},
                                                            {140, 360, "left coat"},
                                                            {320, 320, "right coat"}}},
                                                          {"F09_pig_lear.gif",
                                                           {{10, 10, ""},
                                                            {105, 205, ""},
                                                            {140, 200, ""},
                                                            {12, 112, "head"},
                                                            {50, 95, "head"},
                                                            {200, 120, "body"},
                                                            {95, 185, "body"},
                                                            {248, 205, "body"}}},
                                                          {"F11_rabbits_potter.jpg",
                                                           {{5, 5, ""},
                                                            {240, 485, ""},
                                                            {60, 440, ""},
                                                            {150, 45, "mother"},
                                                            {187, 50, "mother"},
                                                            {150, 150, "mother"},
                                                            {30, 250, "dress"},
                                                            {70, 300, "dress"},
                                                            {180, 290, "heads"},
                                                            {150, 345, "coats"},
                                                            {250, 340, "coats"},
                                                            {380, 310, "son's head"},
                                                            {400, 400, "son"}}}};
  for (const auto& [name, places] : spots) {
    SCOPED_TRACE(name);
    const std::string stem = name.substr(0, name.find_first_of("./"));
    const understanding::Scribbles strokes = scribbles("few_strokes/" + stem);
    EXPECT_LE(strokes.strokes.size(), 8U);
    const Result<understanding::Segmentation> s =
        understanding::segment_drawing(drawing(name), strokes);
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    expect_parts(*s, places);
  }
}

/// Of all figures only the snowman is turned with one arm in front of him and one behind: to the
/// left, so that his right side is nearer. The twigs of the broom in his hand may hide that.
TEST_F(FlatDrawings, FiguresThatAreNotTurnedDoNotLean) {
  for (const auto& [name, strokes] : std::map<std::string, std::string>{
           {"F01_kid_man/texture.png", "F01_kid_man"},
           {"F02_kid_bug/texture.png", "F02_kid_bug"},
           {"F04_gopher_dandy_pencil.png", "F04_gopher_dandy_pencil"},
           {"F05_gopher_pirate_pencil.png", "F05_gopher_pirate_pencil"},
           {"F06_chicken_tuxpaint.png", ""},
           {"F07_frog_tuxpaint.png", ""},
           {"F08_snowman_stamp.png", ""},
           {"F09_pig_lear.gif", ""},
           {"F10_cat_carrot.png", ""},
           {"F12_sleeping_cat_openclipart.svg", ""}}) {
    const Result<understanding::Segmentation> s =
        strokes.empty() ? segment(name) : segment(name, strokes);
    ASSERT_TRUE(s.ok()) << name << ": " << to_string(s.error());
    const Result<understanding::Proposal> proposal = understanding::propose_scene(s->labels);
    ASSERT_TRUE(proposal.ok()) << name << ": " << to_string(proposal.error());
    const std::vector<understanding::ProposedLean>& leans = proposal->joining.leans;
    if (name != "F08_snowman_stamp.png") {
      EXPECT_TRUE(leans.empty()) << name;
    }
    for (const understanding::ProposedLean& proposed : leans)
      EXPECT_GT(proposed.lean.x, 0.1) << name;
  }
}

/// The strokes of a real drawing bound the figure that another person cut out of it.
TEST_F(FlatDrawings, SilhouettesAgreeWithMasks) {
  for (const auto& [name, strokes] : std::map<std::string, std::string>{
           {"F01_kid_man", "F01_kid_man"}, {"F02_kid_bug", "F02_kid_bug"}}) {
    const Result<understanding::Segmentation> s = segment(name + "/texture.png", strokes);
    ASSERT_TRUE(s.ok());
    // Masks are drawn a little around the ink.
    EXPECT_GT(agreement_with_mask(*s, name), 0.85) << name;
  }
}

TEST_F(FlatDrawings, AStickFigureIsWhole) {
  const Result<understanding::Segmentation> s = segment("F03_kid_stick/texture.png");
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_LE(s->parts.size(), 12U);
  EXPECT_GT(agreement_with_mask(*s, "F03_kid_stick"), 0.5);
}

/// Outlines in the scene cover what is seen of their parts, and of the background nothing.
TEST_F(FlatDrawings, OutlinesCoverTheLabels) {
  for (const char* name : {"F06_chicken_tuxpaint.png", "F08_snowman_stamp.png"}) {
    const Result<understanding::Segmentation> s = segment(name);
    ASSERT_TRUE(s.ok());
    const Result<understanding::Proposal> proposal = understanding::propose_scene(s->labels);
    ASSERT_TRUE(proposal.ok());
    const understanding::PartRegions& regions = proposal->regions;
    for (int part = 0; part < regions.count(); ++part) {
      const Part& drawn = proposal->scene.parts[part];
      const Mask filled = fill_outline(drawn.outline, regions.map.width, regions.map.height);
      int64_t covered = 0;
      int64_t outside = 0;
      for_each_pixel(filled, [&](int x, int y) {
        covered += regions.part_at(x, y) == part ? 1 : 0;
        outside += regions.part_at(x, y) < 0 ? 1 : 0;
      });
      const auto pixels = static_cast<double>(pixel_count(regions.visible[part]));
      EXPECT_GT(static_cast<double>(covered), 0.96 * pixels - 20) << name << " " << drawn.id;
      EXPECT_LT(static_cast<double>(outside), 0.03 * pixels + 20) << name << " " << drawn.id;
    }
  }
}

}  // namespace
}  // namespace relievo
