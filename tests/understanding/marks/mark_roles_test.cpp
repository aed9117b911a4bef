#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/svg/svg_test_support.h"
#include "understanding/marks/silhouettes.h"

namespace relievo::understanding {
namespace {

using Names = std::vector<std::string>;

const std::string trunk = "<circle id='body' cx='500' cy='450' r='300' fill='#c84'/>";
const std::string leg = "<path id='leg' d='M560 650h120v280h-120z' fill='#b73'/>";

LayeredDrawing roles_of(const std::string& content) {
  LayeredDrawing import = import_of(svg_file(content));
  EXPECT_TRUE(import.proposed);
  return import;
}

Names names(const LayeredDrawing& import) {
  Names names;
  for (const Part& part : import.scene.parts) names.push_back(part.id);
  return names;
}

bool covered(const LayeredDrawing& import, Point2 p) {
  return std::any_of(import.scene.parts.begin(), import.scene.parts.end(),
                     [&](const Part& part) { return contains(part.outline, p); });
}

/// Whether a warning begins with the name and says the word.
bool says(const LayeredDrawing& import, const std::string& name, const std::string& word) {
  return std::any_of(
      import.warnings.begin(), import.warnings.end(), [&](const std::string& warning) {
        return warning.rfind(name, 0) == 0 && warning.find(word) != std::string::npos;
      });
}

TEST(MarkRoles, ThickPensDrawnOverTheColoursBelongToThePartsAlongThem) {
  const LayeredDrawing import =
      roles_of(trunk + leg +
               "<g fill='none' stroke='#000' stroke-width='40'>"
               "<path id='around' d='M500 150A300 300 0 0 1 700 674V930H540V747A300 300 0 1 1 500 "
               "150M680 930H560'/></g>");
  EXPECT_EQ(names(import), (Names{"body", "leg"}));
  EXPECT_TRUE(contains(import.scene.parts[0].outline, {185, 450})) << "ink beside the body";
  EXPECT_FALSE(contains(import.scene.parts[0].outline, {710, 900})) << "ink beside the leg";
  EXPECT_TRUE(contains(import.scene.parts[1].outline, {710, 900}));
}

TEST(MarkRoles, ADarkPlateBelowAllColoursIsTheirOutline) {
  const LayeredDrawing import = roles_of(
      "<path id='plate' d='M500 130A320 320 0 0 1 700 700V950H540V766A320 320 0 1 1 500 "
      "130z' fill='#111'/>" +
      trunk + leg);
  EXPECT_EQ(names(import), (Names{"body", "leg"}));
  EXPECT_TRUE(covered(import, {500, 135}));
  EXPECT_TRUE(contains(import.scene.parts[1].outline, {690, 900}));
}

TEST(MarkRoles, DarkLimbsBesideTheBodyStayParts) {
  EXPECT_EQ(names(roles_of(trunk + "<path id='tail' d='M700 400L980 60' fill='none' stroke='#000' "
                                   "stroke-width='44'/>")),
            (Names{"body", "tail"}));
  EXPECT_EQ(names(roles_of(trunk + "<path id='arm' d='M700 380h280v120h-280z' fill='#111'/>")),
            (Names{"body", "arm"}));
}

TEST(MarkRoles, ShadesOfTheSameHueAndClearOnesAreTexture) {
  const std::string crescent =
      "<path d='M260 600A283 283 0 0 0 740 600A330 330 0 0 1 260 600z' fill='#a62'/>";
  EXPECT_EQ(names(roles_of(trunk + leg + crescent)), (Names{"body", "leg"}));
  EXPECT_EQ(
      names(roles_of(trunk + leg + "<path d='M560 560h120v200h-120z' fill='#fff' opacity='.6'/>")),
      (Names{"body", "leg"}));
  EXPECT_EQ(
      names(roles_of(trunk + leg + "<path id='cloth' d='M540 560h160v200h-160z' fill='#28c'/>"))
          .back(),
      "cloth");
}

TEST(MarkRoles, CastShadowsAreLeftOutAndNamed) {
  for (const char* paint : {"fill='#333' opacity='.6'", "fill='#111'"}) {
    const LayeredDrawing import =
        roles_of("<ellipse id='shadow' cx='560' cy='930' rx='330' ry='40' " + std::string(paint) +
                 "/>" + trunk + leg);
    EXPECT_EQ(names(import), (Names{"body", "leg"})) << paint;
    EXPECT_FALSE(covered(import, {300, 935}));
    EXPECT_TRUE(says(import, "shadow", "cast shadow"));
  }
  EXPECT_EQ(names(roles_of("<ellipse id='island' cx='560' cy='930' rx='330' ry='40' fill='#4a4'/>" +
                           trunk + leg))
                .front(),
            "island");
}

TEST(MarkRoles, BlurredShadowsAreLeftOut) {
  const LayeredDrawing import = roles_of(
      "<filter id='soft'><feGaussianBlur stdDeviation='8'/></filter><g filter='url(#soft)'>"
      "<path id='shadow' d='M200 920h600v40h-600z' fill='#777'/></g>" +
      trunk + leg);
  EXPECT_EQ(names(import), (Names{"body", "leg"}));
}

TEST(MarkRoles, LinesApartFromEverythingAreMotionLines) {
  const LayeredDrawing import =
      roles_of(trunk +
               "<path id='whoosh' d='M20 100h100' stroke='#000' stroke-width='8'/>"
               "<path id='hair' d='M500 145v-100' stroke='#000' stroke-width='8'/>");
  EXPECT_EQ(names(import), Names{"body"});
  EXPECT_FALSE(covered(import, {60, 100}));
  EXPECT_TRUE(covered(import, {500, 60}));
  EXPECT_TRUE(says(import, "whoosh", "motion line"));
  EXPECT_FALSE(says(import, "hair", ""));
}

TEST(MarkRoles, SkyAndGroundAreBackground) {
  const LayeredDrawing import = roles_of(
      "<rect id='sky' width='1000' height='700' fill='#cdf'/>"
      "<rect id='ground' y='700' width='1000' height='300' fill='#8a4'/>" +
      trunk + leg);
  EXPECT_EQ(names(import), (Names{"body", "leg"}));
  EXPECT_TRUE(says(import, "sky", "background"));
  EXPECT_TRUE(says(import, "ground", "background"));
  EXPECT_EQ(names(roles_of("<rect id='box' x='200' y='200' width='600' height='600' fill='#888'/>"
                           "<circle id='knob' cx='500' cy='200' r='90' fill='#c33'/>")),
            (Names{"box", "knob"}));
}

TEST(MarkRoles, ATileBehindAFigureIsBackground) {
  const std::string tile = "<rect id='tile' x='50' y='50' width='900' height='900' rx='120'/>";
  const std::string disc = "<circle id='disc' cx='500' cy='500' r='490'/>";
  const std::string cat =
      "<path id='body' d='M300 450h500v400h-500z' fill='#c84'/>"
      "<path id='head' d='M150 200h350v350h-350z' fill='#da6'/>"
      "<path id='tail' d='M700 500L820 300L860 330L760 520z' fill='#b73'/>";
  const Names parts = {"body", "head", "tail"};
  for (const std::string& behind : {tile, disc}) {
    const LayeredDrawing import = roles_of(behind + cat);
    EXPECT_EQ(names(import), parts);
    EXPECT_TRUE(says(import, behind == tile ? "tile" : "disc", "background"));
  }
  EXPECT_EQ(names(roles_of(disc + cat + "<path id='foot' d='M310 700h80v300h-80z'/>"))[0], "disc")
      << "what stands out of it shows that it is a body";
  EXPECT_EQ(names(roles_of(disc + "<circle id='face' cx='500' cy='560' r='340' fill='#da6'/>"
                                  "<circle cx='420' cy='500' r='40'/>"))[0],
            "disc")
      << "a mane lies behind a round face";
}

TEST(MarkRoles, HatchingIsTexture) {
  std::string hatching;
  for (int x = 300; x < 700; x += 20)
    hatching += "<path d='M" + std::to_string(x) + " 400l60 120' stroke='#000' stroke-width='5'/>";
  EXPECT_EQ(names(roles_of(trunk + hatching)), Names{"body"});
}

TEST(MarkRoles, MasksCutLikeClipPaths) {
  const LayeredDrawing import = roles_of(
      "<mask id='m'><rect width='1000' height='1000' fill='#fff'/><rect y='500' width='1000' "
      "height='500' fill='#000'/></mask><g mask='url(#m)'>" +
      trunk + "</g>");
  ASSERT_EQ(import.scene.parts.size(), 1U);
  EXPECT_TRUE(covered(import, {500, 450}));
  EXPECT_FALSE(covered(import, {500, 550}));
  EXPECT_TRUE(import.warnings.empty());
}

TEST(MarkRoles, MasksInUnitsOfTheBoxCutToo) {
  const LayeredDrawing import = roles_of(
      "<mask id='m' maskContentUnits='objectBoundingBox'><rect width='1' height='.55' "
      "fill='#fff'/></mask><g mask='url(#m)'>" +
      trunk + "</g>");
  ASSERT_EQ(import.scene.parts.size(), 1U);
  EXPECT_TRUE(covered(import, {500, 450}));
  EXPECT_FALSE(covered(import, {500, 550}));
  EXPECT_TRUE(import.warnings.empty());
}

TEST(MarkRoles, PicturesAndTextThatBecomeNoPartsAreNamedWithTheirLayer) {
  const LayeredDrawing import = roles_of(
      "<g id='face'><image id='eyes' href='data:,'/><text id='word'>Hm</text>"
      "<circle id='ball' cx='500' cy='500' r='200'/></g>");
  EXPECT_TRUE(says(import, "image eyes in face", "no part"));
  EXPECT_TRUE(says(import, "text word in face", "no part"));
}

TEST(MarkRoles, DrawingsWithoutAnyFillAreLineArt) {
  const std::string line =
      "<circle cx='500' cy='500' r='300' fill='none' stroke='#000' "
      "stroke-width='12'/>";
  EXPECT_TRUE(roles_of(line).line_art);
  EXPECT_FALSE(roles_of(trunk + line).line_art);
}

TEST(MarkRoles, TracedInkIsLineArt) {
  const std::string frame =
      "<path fill-rule='evenodd' d='M100 100h800v800h-800zM130 130h500v740h-500zM660 "
      "130h210v740h-210z'/>";
  EXPECT_TRUE(roles_of(frame).line_art);
  EXPECT_TRUE(roles_of("<rect width='1000' height='1000' fill='#fff'/>" + frame +
                       "<circle cx='300' cy='300' r='20'/>")
                  .line_art);
  EXPECT_FALSE(roles_of(frame + leg).line_art) << "with a colour";
  EXPECT_FALSE(roles_of("<path fill-rule='evenodd' d='M100 100h800v800h-800zM300 "
                        "300h300v300h-300z'/>")
                   .line_art)
      << "a figure with a hole";
}

}  // namespace
}  // namespace relievo::understanding
