
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/svg/annotations.h"
#include "io/svg/svg_test_support.h"

namespace relievo {
namespace {

const char* const body = "<g id='body' data-relievo='part'><rect width='400' height='400'/></g>";

std::vector<std::string> ids(const Scene& scene) {
  std::vector<std::string> list;
  for (const Part& part : scene.parts) list.push_back(part.id);
  return list;
}

using Names = std::vector<std::string>;

Error error_of(const std::string& content) {
  const auto import = read_parts(svg_file(content));
  EXPECT_FALSE(import.ok()) << content;
  return import ? Error() : import.error();
}

TEST(AnnotatedParts, AGroupIsTheUnionOfItsFilledShapes) {
  const understanding::LayeredDrawing import = import_of(
      svg_file(std::string(body) +
               "<g id='leg' data-relievo='part' data-c='2' data-d='-0.5' data-lean=' .25, -1' "
               "transform='translate(300 0)'>"
               "<rect x='0' y='100' width='200' height='50'/><g><rect x='50' y='50' width='50' "
               "height='200'/>"
               "</g><path d='M0 0L900 900' fill='none' stroke='red'/>"
               "<rect data-relievo='texture' width='999' height='999'/></g>"));
  EXPECT_FALSE(import.proposed);
  ASSERT_EQ(ids(import.scene), (Names{"body", "leg"}));
  const Part& leg = import.scene.parts[1];
  EXPECT_NEAR(area(leg.outline), 200 * 50 + 50 * 200 - 50 * 50, 1e-6);
  ASSERT_EQ(leg.outline.size(), 1u);
  EXPECT_GT(signed_area(leg.outline[0]), 0);
  EXPECT_EQ(leg.c, 2);
  EXPECT_EQ(leg.d, -0.5);
  EXPECT_EQ(leg.lean, (Point2{0.25, -1}));
  EXPECT_EQ(import.scene.parts[0].c, 4);
}

TEST(AnnotatedParts, AnchorsAreTheEndsOfCurvesOfFilledPathsAlone) {
  const understanding::LayeredDrawing import = import_of(
      svg_file(std::string(body) +
               "<g id='leg' data-relievo='part' transform='translate(100 0)'>"
               "<path d='M100,100 C120,80 140,80 160,100 C180,120 180,140 160,160 L100,160Z'/>"
               "<circle cx='130' cy='130' r='20'/>"
               "<path d='M100,100 C110,100 110,110 110,120' fill='none' stroke='red'/>"
               "<path class='join' data-lower='body' d='M100,100 C120,80 140,80 150,91'/></g>"));
  EXPECT_EQ(import.anchors, (std::vector<Point2>{{260, 100}, {260, 160}}));
}

TEST(AnnotatedParts, HolesRunAgainstTheirRing) {
  const understanding::LayeredDrawing import =
      import_of(svg_file("<path data-relievo='part' id='ring' fill-rule='evenodd' "
                         "d='M0 0H300V300H0ZM100 100H200V200H100Z'/>"));
  ASSERT_EQ(ids(import.scene), (Names{"ring"}));
  const Outline& outline = import.scene.parts[0].outline;
  ASSERT_EQ(outline.size(), 2u);
  EXPECT_LT(signed_area(outline[0]) * signed_area(outline[1]), 0);
  EXPECT_NEAR(area(outline), 80000, 1e-6);
}

TEST(AnnotatedParts, TheStrokeOfAFilledShapeBelongsToIt) {
  const understanding::LayeredDrawing import = import_of(svg_file(
      "<rect id='a' data-relievo='part' x='100' y='100' width='100' height='100' stroke='red' "
      "stroke-width='10'/>"));
  EXPECT_NEAR(area(import.scene.parts.at(0).outline), 110 * 110, 0.5);
}

TEST(AnnotatedParts, IgnoredShapesAreNoParts) {
  const understanding::LayeredDrawing import =
      import_of(svg_file(std::string(body) +
                         "<g data-relievo='ignore'><rect data-c='3' data-relievo='ignore' "
                         "width='9' height='9'/></g>"));
  EXPECT_EQ(ids(import.scene), Names{"body"});
}

TEST(AnnotatedParts, RelationsHoldToEveryOverlappedPartBehind) {
  const understanding::LayeredDrawing import = import_of(
      svg_file(std::string(body) +
               "<rect id='far' data-relievo='part' x='600' y='600' width='100' height='100'/>"
               "<rect id='ear' data-relievo='part' data-relation='equal' x='300' width='200' "
               "height='90'/>"));
  ASSERT_EQ(import.scene.relations.size(), 1u);
  EXPECT_EQ(import.scene.relations[0].upper, 2);
  EXPECT_EQ(import.scene.relations[0].lower, 0);
  EXPECT_EQ(import.scene.relations[0].kind, RelationKind::equal);
}

TEST(AnnotatedParts, LayersArePartsNamedByTheirLabel) {
  const understanding::LayeredDrawing import = import_of(
      svg_file("<g inkscape:groupmode='layer' id='l1' inkscape:label='trunk'><rect width='400' "
               "height='400'/>"
               "</g><g inkscape:groupmode='layer' id='l2'><rect x='300' width='300' height='90'/>"
               "<circle cx='600' cy='45' r='80'/></g>"));
  EXPECT_EQ(ids(import.scene), (Names{"trunk", "l2"}));
  EXPECT_FALSE(import.proposed);
}

TEST(AnnotatedParts, ASingleLayerOrLayersOfManyPartsSayNothing) {
  const std::string shapes =
      "<rect width='400' height='400'/><rect x='350' width='200' height='90'/>"
      "<rect x='350' y='150' width='200' height='90'/><circle cx='200' cy='450' r='90'/>";
  const std::string layer = "<g inkscape:groupmode='layer' id='all'>" + shapes + "</g>";
  EXPECT_TRUE(import_of(svg_file(layer)).proposed);
  const std::string two =
      svg_file(layer + "<g inkscape:groupmode='layer'><rect x='800' width='90' height='90'/></g>");
  EXPECT_TRUE(import_of(two).proposed);
  EXPECT_EQ(import_of(two).scene.parts.size(), 5u);
  EXPECT_EQ(read_svg(two)->layers.size(), 2u);
}

TEST(AnnotatedParts, LinesBetweenLayersArePaintedOnlyWhereLayersAreNoParts) {
  const auto layer = [](const std::string& content) {
    return "<g inkscape:groupmode='layer'>" + content + "</g>";
  };
  const std::string upper = layer(
      "<rect x='300' y='100' width='300' height='90'/>"
      "<path id='seam' d='M300 100V190' fill='none' stroke='#00f' stroke-width='4'/>");
  const std::string trunk = "<rect width='400' height='400'/>";
  const auto parts = import_of(svg_file(layer(trunk) + upper));
  EXPECT_FALSE(parts.proposed);
  EXPECT_EQ(parts.scene.joins.size(), 1u);
  EXPECT_EQ(parts.paintable.text.find("seam"), std::string::npos);
  const auto shapes =
      import_of(svg_file(layer(trunk + "<rect x='350' width='200' height='90'/>"
                                       "<rect x='350' y='250' width='200' height='90'/>"
                                       "<circle cx='200' cy='450' r='90'/>") +
                         upper));
  EXPECT_TRUE(shapes.proposed);
  EXPECT_TRUE(shapes.scene.joins.empty());
  EXPECT_NE(shapes.paintable.text.find("seam"), std::string::npos);
}

TEST(AnnotatedParts, UnsoundValuesAreNamed) {
  for (const char* attribute :
       {"data-c='x'", "data-c='-1'", "data-d='0'", "data-c='1e999'", "data-d='2px'",
        "data-flat='1.1'", "data-flat='-1'", "data-lean='0.1'", "data-lean='0.1 2.5'",
        "data-lean='0.1 0 0'", "data-lean='x 0'", "data-relation='over'"}) {
    const Error error = error_of(
        std::string("<rect id='p' data-relievo='part' width='9' height='9' ") + attribute + "/>");
    EXPECT_EQ(error.code, ErrorCode::bad_input) << attribute;
    EXPECT_EQ(error.where, "p") << attribute;
  }
}

TEST(AnnotatedCues, ACueBelongsToItsPartOrTheOneItNames) {
  const understanding::LayeredDrawing import = import_of(svg_file(
      std::string(body) +
      "<g id='hat' data-relievo='part' transform='translate(300 100)'><rect width='300' "
      "height='90'/><path class='cue' data-cue='crease' data-value=' 40 ' d='M0 45H300M5 "
      "5V50'/></g>"
      "<path data-cue='bulge' data-value='1.5' data-part='body' d='M10 10H90V90Z' fill='red'/>"
      "<path data-relievo='cue' data-cue='slope' data-value='-20' data-part='hat' d='M0 0L9 9'/>"));
  ASSERT_EQ(import.scene.parts.size(), 2u);
  EXPECT_NEAR(area(import.scene.parts[1].outline), 27000, 1e-6);
  ASSERT_EQ(import.scene.cues.size(), 4u);
  const Cue& ridge = import.scene.cues[0];
  EXPECT_EQ(ridge.part, 1);
  EXPECT_EQ(ridge.kind, CueKind::crease);
  EXPECT_EQ(ridge.value, 40);
  EXPECT_EQ(ridge.line, (std::vector<Point2>{{300, 145}, {600, 145}}));
  EXPECT_EQ(import.scene.cues[1].line, (std::vector<Point2>{{305, 105}, {305, 150}}));
  EXPECT_EQ(import.scene.cues[2].part, 0);
  EXPECT_EQ(import.scene.cues[2].kind, CueKind::bulge);
  EXPECT_EQ(import.scene.cues[2].line,
            (std::vector<Point2>{{10, 10}, {90, 10}, {90, 90}, {10, 10}}));
  EXPECT_EQ(import.scene.cues[3].kind, CueKind::slope);
  EXPECT_TRUE(import.warnings.empty());
}

TEST(AnnotatedCues, UnsoundCuesAreNamed) {
  for (const char* attributes :
       {"data-cue='dent' data-value='1'", "class='cue' data-value='1'", "data-cue='slope'",
        "data-cue='slope' data-value='76'", "data-cue='bulge' data-value='0'",
        "data-cue='crease' data-value='4x'", "data-cue='slope' data-value='1' data-part='nose'"}) {
    const Error error = error_of(std::string("<g id='p' data-relievo='part'><rect width='9' "
                                             "height='9'/><path id='c' d='M0 0H9' ") +
                                 attributes + "/></g>");
    EXPECT_EQ(error.code, ErrorCode::bad_input) << attributes;
    EXPECT_EQ(error.where, "c") << attributes;
  }
  EXPECT_EQ(
      error_of(std::string(body) + "<path data-cue='slope' data-value='9' d='M0 0H9'/>").where,
      "cue");
}

TEST(AnnotatedJoins, AJoinBelongsToItsPartAndTheOneBehind) {
  const understanding::LayeredDrawing import = import_of(svg_file(
      std::string("<rect id='back' data-relievo='part' width='900' height='900'/>") + body +
      "<g id='arm' data-relievo='part'><rect x='300' y='100' width='300' height='90'/>"
      "<path class='join' d='M300 100V190' fill='none' stroke='blue'/></g>"));
  ASSERT_EQ(import.scene.joins.size(), 1u);
  const Join& join = import.scene.joins[0];
  EXPECT_EQ(join.upper, 2);
  EXPECT_EQ(join.lower, 1);
  EXPECT_EQ(join.line, (std::vector<Point2>{{300, 100}, {300, 190}}));
  EXPECT_NEAR(area(import.scene.parts[2].outline), 27000, 1e-6);
}

TEST(AnnotatedJoins, NamesOverrideWhatContainsTheLine) {
  const std::string parts =
      std::string("<rect id='back' data-relievo='part' width='900' height='900'/>") + body +
      "<rect id='arm' data-relievo='part' x='300' y='100' width='300' height='90'/>";
  const understanding::LayeredDrawing import = import_of(svg_file(
      parts + "<path class='join left' data-upper='arm' data-lower='back' d='M300 100V190'/>"));
  ASSERT_EQ(import.scene.joins.size(), 1u);
  EXPECT_EQ(import.scene.joins[0].upper, 2);
  EXPECT_EQ(import.scene.joins[0].lower, 0);
  EXPECT_EQ(error_of(parts + "<path id='j' class='join' d='M300 100V190'/>").code,
            ErrorCode::bad_input);
  EXPECT_EQ(error_of(parts + "<path class='join' data-upper='nose' d='M300 100V190'/>").code,
            ErrorCode::bad_input);
  const Error order = error_of(
      parts + "<path id='j' class='join' data-upper='back' data-lower='back' d='M300 100V190'/>");
  EXPECT_EQ(order.code, ErrorCode::contradiction);
  EXPECT_EQ(order.where, "j");
  const understanding::LayeredDrawing behind = import_of(
      svg_file(parts + "<path class='join' data-upper='back' data-lower='arm' d='M300 100V190'/>"));
  EXPECT_TRUE(behind.scene.joins.empty());
  ASSERT_EQ(behind.scene.relations.size(), 1u);
  EXPECT_EQ(behind.scene.relations[0].upper, 2);
  EXPECT_EQ(behind.scene.relations[0].lower, 0);
  EXPECT_EQ(behind.scene.relations[0].kind, RelationKind::joined);
  EXPECT_EQ(error_of(parts + "<path class='join' data-upper='arm' d='M950 950V990'/>").code,
            ErrorCode::contradiction);
}

TEST(AnnotatedJoins, InLayersALineAlongTheOutlineIsAJoinAndOthersAreNot) {
  const understanding::LayeredDrawing import = import_of(svg_file(
      "<g inkscape:groupmode='layer' id='trunk'><rect width='400' height='400'/></g>"
      "<g inkscape:groupmode='layer' id='arm'><rect x='300' y='100' width='300' height='90'/>"
      "<path d='M303 100V190' fill='none' stroke='blue'/>"
      "<path d='M320 145H380' fill='none' stroke='black'/>"
      "<path d='M600 100V190' fill='none' stroke='black'/></g>"));
  ASSERT_EQ(import.scene.joins.size(), 1u);
  EXPECT_EQ(import.scene.joins[0].line.front(), (Point2{303, 100}));
}

TEST(AnnotatedJoins, CountEvenWhereTheyAreHidden) {
  const understanding::LayeredDrawing import = import_of(
      svg_file(std::string("<style>.join { visibility: hidden }</style>") + body +
               "<g id='arm' data-relievo='part'><rect x='300' y='100' width='300' height='90'/>"
               "<path class='join' d='M300 100V190'/></g>"));
  EXPECT_EQ(import.scene.joins.size(), 1u);
}

struct Sample {
  const char* name;
  size_t parts;
  size_t joins;
};

class Samples : public testing::TestWithParam<Sample> {};

TEST_P(Samples, HaveTheirPartsAndJoins) {
  const std::string path = std::string(RELIEVO_EXAMPLES) + "/" + GetParam().name;
  const understanding::LayeredDrawing import = import_of(file_bytes(path));
  EXPECT_FALSE(import.proposed);
  EXPECT_TRUE(import.warnings.empty());
  EXPECT_EQ(import.scene.parts.size(), GetParam().parts);
  EXPECT_EQ(import.scene.joins.size(), GetParam().joins);
}

INSTANTIATE_TEST_SUITE_P(All, Samples,
                         testing::Values(Sample{"bunny.svg", 17, 5}, Sample{"elephant.svg", 12, 5},
                                         Sample{"farmer.svg", 20, 4}, Sample{"lamb.svg", 14, 4},
                                         Sample{"unicorn.svg", 16, 4}, Sample{"wolf.svg", 13, 5}));

}  // namespace
}  // namespace relievo
