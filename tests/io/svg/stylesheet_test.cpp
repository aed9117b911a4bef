#include "io/svg/stylesheet.h"

#include <gtest/gtest.h>

#include "io/svg/svg_test_support.h"

namespace relievo {
namespace {

/// The fill of the only shape, as red-green-blue in hexadecimal, or "none".
std::string fill_in(const std::string& content) {
  const SvgDrawing drawing = drawing_of(svg_file(content));
  EXPECT_EQ(drawing.shapes.size(), 1u) << content;
  if (drawing.shapes.size() != 1 || !drawing.shapes[0].fill) return "none";
  const Color& c = *drawing.shapes[0].fill;
  char text[8];
  std::snprintf(text, sizeof text, "%02x%02x%02x", static_cast<int>(c.r * 255 + 0.5),
                static_cast<int>(c.g * 255 + 0.5), static_cast<int>(c.b * 255 + 0.5));
  return text;
}

std::string styled(const std::string& css, const std::string& attributes = "") {
  return "<style>" + css + "</style><g class='outer' id='o'><rect width='9' height='9' " +
         attributes + "/></g>";
}

TEST(Stylesheet, SelectorsByTypeClassIdAndLists) {
  EXPECT_EQ(fill_in(styled("rect{fill:#f00}")), "ff0000");
  EXPECT_EQ(fill_in(styled(".a{fill:#f00}", "class='b a'")), "ff0000");
  EXPECT_EQ(fill_in(styled("#x{fill:#f00}", "id='x'")), "ff0000");
  EXPECT_EQ(fill_in(styled("circle, .q , rect.a{fill:#f00}", "class='a'")), "ff0000");
  EXPECT_EQ(fill_in(styled("*{fill:#f00}")), "ff0000");
  EXPECT_EQ(fill_in(styled("rect[class~='b']{fill:#f00}", "class='a b'")), "ff0000");
  EXPECT_EQ(fill_in(styled(".a{fill:#f00}", "class='ab'")), "000000");
  EXPECT_EQ(fill_in(styled("circle{fill:#f00}")), "000000");
}

TEST(Stylesheet, AncestorsAndChildren) {
  EXPECT_EQ(fill_in(styled(".outer rect{fill:#f00}")), "ff0000");
  EXPECT_EQ(fill_in(styled("g>rect{fill:#f00}")), "ff0000");
  EXPECT_EQ(fill_in(styled("svg>rect{fill:#f00}")), "000000");
  EXPECT_EQ(fill_in(styled("svg rect{fill:#f00}")), "ff0000");
  EXPECT_EQ(fill_in(styled("rect:first-child{fill:#f00}")), "ff0000");
}

TEST(Stylesheet, SpecificityThenOrderThenStyleThenImportance) {
  EXPECT_EQ(fill_in(styled(".a{fill:#f00} rect{fill:#0f0}", "class='a' fill='#00f'")), "ff0000");
  EXPECT_EQ(fill_in(styled("#x{fill:#f00} .a.a{fill:#0f0}", "class='a' id='x'")), "ff0000");
  EXPECT_EQ(fill_in(styled("rect{fill:#f00} rect{fill:#0f0}")), "00ff00");
  EXPECT_EQ(fill_in(styled("#x{fill:#f00}", "id='x' style='fill:#0f0'")), "00ff00");
  EXPECT_EQ(fill_in(styled("rect{fill:#f00 !important}", "style='fill:#0f0'")), "ff0000");
  EXPECT_EQ(fill_in(styled("g{fill:#f00}", "fill='#0f0'")), "00ff00");
}

TEST(Stylesheet, InheritanceAndCurrentColor) {
  EXPECT_EQ(fill_in("<g fill='#f00'><rect width='9' height='9'/></g>"), "ff0000");
  EXPECT_EQ(fill_in("<g fill='#f00'><rect width='9' height='9' fill='inherit'/></g>"), "ff0000");
  EXPECT_EQ(fill_in("<g color='#f00'><rect width='9' height='9' fill='currentColor'/></g>"),
            "ff0000");
  EXPECT_EQ(fill_in("<rect width='9' height='9' fill='none'/>"), "none");
  EXPECT_EQ(fill_in("<rect width='9' height='9' fill='bogus'/>"), "000000");
}

TEST(Stylesheet, WhatIsNotUnderstoodDoesNoHarm) {
  const std::string noise =
      "/* rect{fill:#0f0} */ @import url(http://localhost/x.css); @media print{rect{fill:#0f0}}"
      "rect:hover{fill:#0f0} a+rect{fill:#0f0} {fill:#0f0} ><{fill:#0f0} rect[{fill:#0f0}";
  EXPECT_EQ(fill_in(styled("<![CDATA[" + noise + " rect{fill:#f00;;:;x}]]>")), "ff0000");
  EXPECT_EQ(fill_in(styled("<![CDATA[rect{fill:#f00} rect{fill:#0f0]]>")), "ff0000");
  EXPECT_EQ(fill_in(styled("}}}{{{")), "000000");
}

TEST(Stylesheet, GradientsGiveTheirMeanColorThroughChainsOfReferences) {
  const std::string defs =
      "<linearGradient id='a'><stop offset='0' stop-color='#f00'/>"
      "<stop offset='100%' style='stop-color:#00f'/></linearGradient>"
      "<radialGradient id='b' xlink:href='#a'/><linearGradient id='loop' href='#loop'/>";
  EXPECT_EQ(fill_in(defs + "<rect width='9' height='9' fill='url(#b)'/>"), "800080");
  EXPECT_EQ(fill_in(defs + "<rect width='9' height='9' fill='url(#loop)'/>"), "none");
  EXPECT_EQ(fill_in(defs + "<rect width='9' height='9' fill='url(#gone) #0f0'/>"), "00ff00");
}

}  // namespace
}  // namespace relievo
