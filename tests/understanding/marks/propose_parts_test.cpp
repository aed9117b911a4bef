#include "understanding/marks/propose_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "io/svg/coverage.h"
#include "io/svg/render_svg.h"
#include "io/svg/svg_test_support.h"

namespace relievo::understanding {
namespace {

using Names = std::vector<std::string>;

Names proposed(const std::string& content) {
  const LayeredDrawing import = import_of(svg_file(content));
  EXPECT_TRUE(import.proposed);
  Names names;
  for (const Part& part : import.scene.parts) names.push_back(part.id);
  return names;
}

const std::string large_circle = "<circle id='body' cx='500' cy='500' r='300' fill='#c84'/>";

TEST(ProposeParts, WhatStandsOutIsAPartAndWhatLiesInsideIsTexture) {
  EXPECT_EQ(
      proposed(large_circle + "<ellipse id='ear' cx='500' cy='220' rx='60' ry='120' fill='#a63'/>"
                              "<circle id='spot' cx='560' cy='600' r='30' fill='#742'/>"),
      (Names{"body", "ear"}));
}

TEST(ProposeParts, AFrameIsOneWithWhatShowsThroughItsHoles) {
  const std::string head = "<circle id='head' cx='160' cy='600' r='90' fill='#8c4'/>";
  const std::string frame =
      "<path id='frame' fill='#264' fill-rule='evenodd' d='M250 300H750V700H250ZM300 "
      "350H470V650H300Z"
      "M530 350H700V650H530Z'/>";
  const auto rings_of_last = [](const std::string& content) {
    const LayeredDrawing import = import_of(svg_file(content));
    EXPECT_EQ(import.scene.parts.back().id, "frame");
    return import.scene.parts.back().outline.size();
  };
  const std::string plates =
      "<rect id='plates' x='200' y='340' width='600' height='400' fill='#4a7'/>";
  EXPECT_EQ(rings_of_last(head + plates + frame), 1u);
  EXPECT_EQ(rings_of_last(head + frame), 3u) << "nothing shows through";
}

TEST(ProposeParts, ADarkTwinBehindIsOnePartWithItsFill) {
  const LayeredDrawing import = import_of(svg_file(
      "<circle id='line' cx='500' cy='500' r='310'/>" + large_circle +
      "<circle id='line2' cx='640' cy='420' r='80'/><circle id='eye' cx='640' cy='420' r='72' "
      "fill='#fff'/><circle id='pupil' cx='650' cy='420' r='25'/>"));
  ASSERT_EQ(import.scene.parts.size(), 2u);
  EXPECT_EQ(import.scene.parts[0].id, "line");
  EXPECT_NEAR(area(import.scene.parts[0].outline), 3.14159 * 310 * 310, 200);
  EXPECT_EQ(import.scene.parts[1].id, "line2");
}

TEST(ProposeParts, ALineDrawnAroundAFillBelongsToIt) {
  EXPECT_EQ(proposed(large_circle +
                     "<path fill-rule='evenodd' d='M190 500a310 310 0 0 0 620 0a310 310 0 0 "
                     "0 -620 0zM200 500a300 300 0 0 0 600 0a300 300 0 0 0 -600 0z'/>"),
            Names{"body"});
}

TEST(ProposeParts, BackgroundsAreNoPart) {
  EXPECT_EQ(proposed("<rect id='page' width='1000' height='1000' fill='#eef'/>" + large_circle),
            Names{"body"});
}

TEST(ProposeParts, TranslucentShadingIsTexture) {
  EXPECT_EQ(proposed(large_circle + "<circle cx='700' cy='500' r='200' opacity='.2'/>"),
            Names{"body"});
}

TEST(ProposeParts, WideStrokesAreLimbsAndThinOnesExtendWhatTheyTouch) {
  const LayeredDrawing import = import_of(
      svg_file(large_circle +
               "<path id='arm' d='M700 600L950 900' fill='none' stroke='#c84' stroke-width='60'/>"
               "<path id='whisker' d='M300 500H100' fill='none' stroke='#000' stroke-width='4'/>"));
  ASSERT_EQ(import.scene.parts.size(), 2u);
  EXPECT_EQ(import.scene.parts[1].id, "arm");
  EXPECT_TRUE(contains(import.scene.parts[0].outline, {150, 500}));
}

TEST(ProposeParts, WhatLiesApartIsAPartOfItsOwn) {
  EXPECT_EQ(proposed("<circle id='a' cx='200' cy='200' r='90'/>"
                     "<circle id='a' cx='700' cy='700' r='90'/>"),
            (Names{"a", "a-2"}));
}

class LayeredDrawings : public testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(LayeredDrawings, PartsCoverTheDrawing) {
  const auto [name, part_count] = GetParam();
  const std::string file = file_bytes(std::string(RELIEVO_SHARED_DATA) + "/layered/" + name);
  if (file.empty()) GTEST_SKIP() << "no drawing " << name << " in " << RELIEVO_SHARED_DATA;
  const LayeredDrawing import = import_of(file);
  const auto drawing = painted_svg(file, static_cast<int>(std::lround(import.scene.width)),
                                   static_cast<int>(std::lround(import.scene.height)));
  ASSERT_TRUE(drawing.ok());
  EXPECT_GE(silhouette_agreement(import.scene, *drawing), 0.995);
  EXPECT_EQ(static_cast<int>(import.scene.parts.size()), part_count);
  for (const Part& part : import.scene.parts) {
    Outline nested = part.outline;
    orient_by_nesting(nested);
    EXPECT_EQ(nested, part.outline) << part.id;
    for (const Ring& ring : part.outline) {
      for (size_t i = 0; i < ring.size(); ++i) {
        EXPECT_GT(distance(ring[i], ring[(i + 1) % ring.size()]), 0) << part.id;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, LayeredDrawings,
                         testing::Values(std::pair("L01_snail_twemoji.svg", 4),
                                         std::pair("L02_squirrel_twemoji.svg", 4),
                                         std::pair("L03_dog_twemoji.svg", 5),
                                         std::pair("L04_gourami_openclipart.svg", 5),
                                         std::pair("L05_ferris_cuddly.svg", 11),
                                         std::pair("L06_squirrel_reading_openclipart.svg", 12),
                                         std::pair("L07_penguin_openclipart.svg", 7),
                                         std::pair("L08_gopher_hearthug.svg", 12),
                                         std::pair("L09_ziggy_zig.svg", 6),
                                         std::pair("L10_gopher_ballet.svg", 14),
                                         std::pair("L11_caterpillar_openclipart.svg", 20)));

}  // namespace
}  // namespace relievo::understanding
