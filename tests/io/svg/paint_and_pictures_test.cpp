#include <gtest/gtest.h>

#include "io/svg/svg_test_support.h"

namespace relievo {
namespace {

const std::string torso = "<rect id='body' x='200' y='200' width='500' height='500' fill='#da5'/>";

/// The names of the marks that are no mere paint, with spaces between them.
std::string marks_in(const std::string& content) {
  const auto drawing = read_svg(svg_file(content));
  EXPECT_TRUE(drawing.ok());
  std::string names;
  if (!drawing) return names;
  for (const understanding::Mark& mark : drawing->marks)
    if (!mark.blends) names += (names.empty() ? "" : " ") + mark.name;
  return names;
}

TEST(SvgPaint, WhatBlendsWithSomethingBelowIsPaint) {
  const std::string shade = "<rect id='shade' x='100' y='600' width='800' height='300' ";
  for (const char* mode : {"multiply", "screen", "overlay", "darken"})
    EXPECT_EQ(marks_in(torso + shade + "style='mix-blend-mode:" + mode + "'/>"), "body");
  EXPECT_EQ(marks_in(torso + shade + "style='mix-blend-mode:normal'/>"), "body shade");
  EXPECT_EQ(marks_in("<style>#shade{mix-blend-mode:multiply}</style>" + torso + shade + "/>"),
            "body");
  EXPECT_EQ(marks_in(torso + "<g style='mix-blend-mode:multiply'>" + shade + "/></g>"), "body");
}

TEST(SvgPaint, WhatBlendsWithNothingIsAMark) {
  const std::string apart =
      "<rect id='apart' x='10' y='10' width='90' height='90' style='mix-blend-mode:multiply'/>";
  EXPECT_EQ(marks_in(torso + apart), "body apart");
  const std::string eye = "<rect id='eye' x='300' y='300' width='90' height='90'/>";
  const std::string group = "<g style='mix-blend-mode:multiply'>" + torso + eye + "</g>";
  EXPECT_EQ(marks_in(group), "body eye");
  EXPECT_EQ(marks_in("<rect id='paper' width='1000' height='1000' fill='#fff'/>" + group),
            "paper body eye");
  // An isolated group lies over what is below it as a whole.
  EXPECT_EQ(marks_in(torso + "<g style='isolation:isolate'><rect id='eye' x='300' y='300' "
                             "width='90' height='90' style='mix-blend-mode:multiply'/></g>"),
            "body eye");
}

TEST(SvgPaint, DeclaredPartsDoNotGrowByTheirShades) {
  const auto parts = import_of(svg_file(
      "<g data-relievo='part' id='all'>" + torso +
      "<rect x='100' y='600' width='800' height='300' style='mix-blend-mode:multiply'/></g>"));
  ASSERT_EQ(parts.scene.parts.size(), 1u);
  EXPECT_NEAR(area(parts.scene.parts[0].outline), 250'000, 1);
}

TEST(SvgPaint, ALineAroundTheFaintestPaintMakesABodyOfIt) {
  const std::string glass =
      "<rect id='glass' x='200' y='200' width='500' height='500' fill='#39c' "
      "stroke='#123' stroke-width='10' fill-opacity='";
  const auto marks_of = [&](const std::string& opacity) {
    return read_svg(svg_file(glass + opacity + "'/>"))->marks;
  };
  ASSERT_EQ(marks_of("0.2").size(), 1u);
  EXPECT_TRUE(marks_of("0.2")[0].filled);
  EXPECT_NEAR(area(marks_of("0.2")[0].region), 510 * 510, 1);
  EXPECT_FALSE(marks_of("0")[0].filled) << "a line alone";
}

/// Pictures of 40 x 40 px: one opaque all over, and one with an opaque square of 20 px in it.
const std::string opaque_picture =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAACgAAAAoAQMAAAC2MCouAAAABlBMVEXAYCAAAACNj38IAAAAAnRSTlP/"
    "AOW3MEoAAAAMSURBVHjaY2AYWQAAAPAAAThpWlEAAAAASUVORK5CYII=";
const std::string cut_out_picture =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAACgAAAAoAQMAAAC2MCouAAAABlBMVEXAYCAAAACNj38IAAAAAnRSTlP/"
    "AOW3MEoAAAAWSURBVHjaY/gPAgxkkgcYmAeEJN/NAJZsmrGoDIToAAAAAElFTkSuQmCC";

std::string image(const std::string& name, const std::string& picture, int x, int y) {
  return "<image id='" + name + "' x='" + std::to_string(x) + "' y='" + std::to_string(y) +
         "' width='400' height='400' href='" + picture + "'/>";
}

TEST(SvgPictures, ADrawingOfOnePictureIsFlat) {
  EXPECT_TRUE(read_svg(svg_file(image("a", opaque_picture, 0, 0)))->flat);
  EXPECT_TRUE(read_svg(svg_file(image("a", cut_out_picture, 0, 0)))->flat);
  EXPECT_FALSE(read_svg(svg_file(image("a", cut_out_picture, 0, 0) + torso))->flat);
}

TEST(SvgPictures, SeveralCutOutPicturesAreLayers) {
  const auto drawing = import_of(
      svg_file(image("a", cut_out_picture, 0, 0) + image("b", cut_out_picture, 150, 150)));
  EXPECT_FALSE(drawing.flat);
  ASSERT_EQ(drawing.scene.parts.size(), 2u);
  EXPECT_EQ(drawing.scene.parts[1].id, "b");
  EXPECT_NEAR(area(drawing.scene.parts[1].outline), 40'000, 400);
}

TEST(SvgPictures, AreMarksByTheirAlphaAndPaintWhereTheyCoverOthers) {
  EXPECT_EQ(marks_in(torso + image("hat", cut_out_picture, 100, 0)), "body hat");
  EXPECT_EQ(marks_in(torso + image("photo", opaque_picture, 300, 300)), "body");
  EXPECT_EQ(marks_in(image("photo", opaque_picture, 300, 300) + torso), "photo body");
}

TEST(SvgPictures, ThoseThatCannotBeReadAreNamed) {
  for (const char* href : {"photo.png", "data:image/gif;base64,R0lGODlhAQABAAAAACw="}) {
    const auto drawing = read_svg(svg_file(torso + image("photo", href, 0, 0)));
    ASSERT_TRUE(drawing.ok());
    ASSERT_EQ(drawing->warnings.size(), 1u) << href;
    EXPECT_NE(drawing->warnings[0].find("photo is a picture"), std::string::npos);
    EXPECT_EQ(drawing->paintable.text.find("<image"), std::string::npos);
  }
}

}  // namespace
}  // namespace relievo
