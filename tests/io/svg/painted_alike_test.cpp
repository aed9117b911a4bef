/// Parts and painting agree: compares the marks of generated drawings with their
/// painting.

#include <gtest/gtest.h>

#include <sstream>

#include "io/svg/coverage.h"
#include "io/svg/render_svg.h"
#include "io/svg/svg_test_support.h"

namespace relievo {
namespace {

constexpr int canvas_side = 400;  ///< of the drawings, px

std::string drawing(const std::string& content) {
  return svg_file(content, "width='400' height='400' viewBox='0 0 400 400'");
}

/// All marks of a drawing as one part.
Scene marks_of(const understanding::LayeredDrawing& drawing) {
  std::vector<Region> regions;
  for (const understanding::Mark& mark : drawing.marks) regions.push_back(mark.region);
  Scene scene;
  scene.width = drawing.scene.width;
  scene.height = drawing.scene.height;
  scene.parts.push_back({"all", unite(regions)});
  return scene;
}

bool is_at_rim(const Image8& mask, int x, int y) {
  for (int v = std::max(0, y - 1); v <= std::min(mask.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(mask.width - 1, x + 1); ++u)
      if (mask.at(u, v) != mask.at(x, y)) return true;
  return false;
}

/// Pixels away from the rim of the marks, and how many of them are painted where there is no mark,
/// or are not where there is one.
struct Comparison {
  int inside = 0;
  int wrong = 0;
};

Comparison compared(const std::string& file) {
  const auto read = read_svg(file);
  EXPECT_TRUE(read.ok()) << (read ? "" : to_string(read.error()));
  if (!read) return {};
  const auto painting = render_svg(read->paintable, canvas_side, canvas_side);
  EXPECT_TRUE(painting.ok()) << (painting ? "" : to_string(painting.error()));
  if (!painting) return {};
  const Image8 mask = silhouette_mask(marks_of(*read), canvas_side, canvas_side);
  Comparison result;
  for (int y = 0; y < canvas_side; ++y)
    for (int x = 0; x < canvas_side; ++x) {
      if (is_at_rim(mask, x, y)) continue;
      const bool painted = painting->rgba.at(x, y, 3) >= 128;
      result.inside += mask.at(x, y) != 0;
      result.wrong += painted != (mask.at(x, y) != 0);
    }
  return result;
}

void expect_alike(const std::string& content) {
  SCOPED_TRACE(content);
  const Comparison result = compared(drawing(content));
  EXPECT_GT(result.inside, 500);
  EXPECT_EQ(result.wrong, 0);
}

/// A picture of 200 x 100 px whose left half is opaque and red, the rest transparent.
const std::string half_picture =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAMgAAABkAQMAAAD5SO1IAAAABlBMVEX/AAAAAABBoxIDAAAAAnRSTlP/"
    "AOW3MEoAAAAjSURBVHja7ckxAQAACAOgNbB/Wn3XQXhJymyJMcYYY4x5PAfHurFprvSj9QAAAABJRU5E"
    "rkJggg==";

/// The same without a type, and with the type of another file.
std::string half_picture_as(const std::string& type) {
  return "data:" + type + half_picture.substr(half_picture.find(";base64,"));
}

/// Content of a group or element; `@` stands for what is said of the element.
const std::vector<std::string> contents = {
    "<rect x='120' y='90' width='130' height='80' @/>",
    "<g @><circle cx='150' cy='160' r='60'/><path d='M200 100h90q20 90-60 120z'/></g>",
    "<defs><g id='u'><rect x='70' y='60' width='130' height='90'/></g></defs><use href='#u' x='30' "
    "y='40' @/>",
    "<svg x='10' y='20' width='390' height='390' viewBox='0 0 400 400'>"
    "<ellipse cx='170' cy='160' rx='90' ry='60' @/></svg>",
    "<image x='90' y='110' width='200' height='100' href='" + half_picture + "' @/>",
    "<polygon points='120,100 280,130 220,250 110,230' stroke='#123' stroke-width='14' @/>",
};

TEST(PaintedAlike, PicturesWhoseTypeIsNotStatedOrWrong) {
  for (const char* type : {"", "image/jpg", "image/jpeg", "application/octet-stream"})
    expect_alike("<image x='90' y='110' width='200' height='100' href='" + half_picture_as(type) +
                 "'/>");
}

/// Transforms as declarations of CSS.
const std::vector<std::string> transforms = {
    "",
    "transform:translate(20px,5%) rotate(15deg)",
    "transform:rotate(0.3rad) scaleX(1.2);transform-origin:150px 40%",
    "transform:rotate(30grad);transform-box:fill-box;transform-origin:center",
    "transform:scale(1.3,80%) skewX(10deg);transform-box:fill-box",
    "transform:rotate(0.05turn);transform-origin:right bottom;transform-box:view-box",
    "translate:12px -4px;rotate:20deg;scale:0.9;transform-origin:160px 160px",
    "transform:matrix(.9,.2,-.1,1,10,5)",
};

/// Clips and masks `k`, and how elements name them.
const std::vector<std::pair<std::string, std::string>> cuts = {
    {"", ""},
    {"<clipPath id='k'><circle cx='170' cy='160' r='70'/></clipPath>", "clip-path='url(#k)'"},
    {"<clipPath id='k' clipPathUnits='objectBoundingBox'>"
     "<path d='M.1 .2L.9 .1 1 .8 .3 1z'/></clipPath>",
     "clip-path='url(#k)'"},
    {"<mask id='k'><rect width='400' height='170' fill='#fff'/></mask>", "mask='url(#k)'"},
    {"<mask id='k' style='mask-type:alpha'><rect width='400' height='170'/></mask>",
     "mask='url(#k)'"},
    {"<style>#k{mask-type:alpha}</style><mask id='k' maskContentUnits='objectBoundingBox'>"
     "<circle cx='.5' cy='.5' r='.45'/></mask>",
     "mask='url(#k)'"},
    {"<mask id='k' x='.25' y='0' width='.5' height='80%'>"
     "<rect width='400' height='400' fill='#ddd'/></mask>",
     "mask='url(#k)'"},
    {"<mask id='k' maskUnits='userSpaceOnUse' x='120' y='10%' width='100' height='300'>"
     "<rect width='400' height='400' fill='#fff'/></mask>",
     "mask='url(#k)'"},
};

/// The ways in which declarations reach an element: by its style or by a sheet.
std::string said(const std::string& css, bool by_sheet, std::string& head) {
  if (css.empty()) return "";
  if (!by_sheet) return "style='" + css + "'";
  head += "<style>.t{" + css + "}</style>";
  return "class='t'";
}

TEST(PaintedAlike, TransformsAndCutsOfGeneratedDrawings) {
  size_t number = 0;
  for (const std::string& content : contents)
    for (const std::string& transform : transforms)
      for (const auto& [cut, name] : cuts) {
        if (++number % 2 == 0 && !transform.empty()) continue;
        std::string head = "<defs>" + cut + "</defs>";
        const std::string saying = said(transform, number % 3 == 0, head) + " " + name;
        std::string file = content;
        file.replace(file.find('@'), 1, saying);
        expect_alike(head + file);
      }
}

TEST(PaintedAlike, CustomPropertiesAreInheritedAndFallBack) {
  const std::string box = " d='M100 100h150v120h-150z'/>";
  expect_alike("<style>:root{--c:#d99a52}.b{fill:var(--c)}</style><path class='b'" + box);
  expect_alike("<g fill='none'><path style='fill:var(--none,#a8662d)'" + box + "</g>");
  expect_alike("<g fill='none' style='--A: #a00; --b: var(--A)'><path fill='var(--b)'" + box +
               "</g>");
  expect_alike("<path transform='translate(9)' style='--d:20px;transform:translate(var(--d),1em)'" +
               box);
  expect_alike("<defs><symbol id='s'><path fill='var(--c,none)'" + box +
               "</symbol></defs><use href='#s' style='--c:#0a0'/><use href='#s' x='30'/>");
}

TEST(PaintedAlike, SelectorsOfSheets) {
  const std::string two =
      "<g fill='none'><rect class='a' x='20' y='20' width='90' height='90'/>"
      "<rect class='b' x='200' y='200' width='90' height='90'/></g>";
  for (const char* selector :
       {".a+.b", "rect~rect", "rect:nth-child(2)", "rect:nth-child(odd)", "rect:not(.a,#z)",
        "rect:last-of-type", ":root rect", "g>rect:nth-last-child(n+2)", "svg g [class=b]"})
    expect_alike("<style>" + std::string(selector) + "{fill:#c80}</style>" + two);
  expect_alike("<style>@media print{rect{fill:none}}@media screen{.a{fill:#c80}}</style>" + two);
  expect_alike("<style>.a{fill:#c80;fill:color(display-p3 1 0 0);x:50px;width:120px}</style>" +
               two);
}

TEST(PaintedAlike, WhatTheRootTurns) {
  const std::string content = "<rect x='120' y='90' width='130' height='80'/>";
  for (const char* root : {"transform='scale(1,-1)'", "style='transform:rotate(30deg)'"}) {
    const Comparison result = compared(
        svg_file(content, "width='400' height='400' viewBox='10 0 420 410' " + std::string(root)));
    EXPECT_GT(result.inside, 500) << root;
    EXPECT_EQ(result.wrong, 0) << root;
  }
}

TEST(PaintedAlike, PicturesAsFills) {
  const std::string image = "<image id='i' width='200' height='100' href='" + half_picture + "'/>";
  expect_alike(
      "<defs><pattern id='p' patternContentUnits='objectBoundingBox' width='1' height='1'>"
      "<use href='#i' transform='scale(.005 .01)'/></pattern>" +
      image + "</defs><rect x='50' y='60' width='200' height='160' fill='url(#p)'/>" +
      "<circle cx='300' cy='300' r='50'/>");
  expect_alike(
      "<defs><pattern id='p' width='100%' height='100%'><use href='#i' transform='scale(.9)'/>"
      "</pattern>" +
      image + "</defs><circle cx='200' cy='150' r='90' fill='url(#p)'/>" +
      "<circle cx='300' cy='300' r='50'/>");
  for (const char* ratio : {"xMidYMid", "none", "xMinYMax slice", "xMaxYMid meet"})
    expect_alike("<image x='40' y='30' width='150' height='120' preserveAspectRatio='" +
                 std::string(ratio) + "' href='" + half_picture + "'/>" +
                 "<circle cx='300' cy='300' r='50'/>");
}

TEST(PaintedAlike, EncodingsAndEntities) {
  const std::string plain = drawing("<rect x='120' y='90' width='130' height='80' id='\xc3\xa9'/>");
  const auto utf16 = [](const std::string& text, bool little_endian, bool mark) {
    std::string bytes = mark ? (little_endian ? "\xff\xfe" : "\xfe\xff") : "";
    for (const char c : text) {
      const char high = '\0';
      bytes += little_endian ? std::string{c, high} : std::string{high, c};
    }
    return bytes;
  };
  const std::string ascii = drawing("<rect x='120' y='90' width='130' height='80'/>");
  for (const bool little_endian : {true, false})
    for (const bool mark : {true, false})
      EXPECT_EQ(compared(utf16(ascii, little_endian, mark)).wrong, 0);
  const std::string latin1 = "<?xml version='1.0' encoding='ISO-8859-1'?>" +
                             drawing("<rect x='120' y='90' width='130' height='80' id='\xe9'/>");
  EXPECT_EQ(import_of(latin1).scene.parts[0].id, import_of(plain).scene.parts[0].id);
  EXPECT_EQ(compared(latin1).wrong, 0);
  const std::string type =
      "<!DOCTYPE svg [<!ENTITY st0 'fill:none;'><!ENTITY st1 'fill:&#35;a40;'>"
      "<!ENTITY box \"<rect x='120' y='90' width='130' height='80' style='&st1;'/>\">]>";
  const Comparison entities =
      compared(type + drawing("<circle r='90' style=\"&st0;\"/>&box;<!-- &box; -->"));
  EXPECT_GT(entities.inside, 500);
  EXPECT_EQ(entities.wrong, 0);
}

}  // namespace
}  // namespace relievo
