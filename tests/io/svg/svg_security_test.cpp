#include <gtest/gtest.h>

#include <cstdint>

#include "io/svg/render_svg.h"
#include "io/svg/svg_test_support.h"
#include "understanding/marks/make_parts.h"

namespace relievo {
namespace {

const char* const square = "<rect width='100' height='100'/>";

ErrorCode code_of(const std::string& file, const SvgOptions& options = {}) {
  const auto import = read_parts(file, options);
  EXPECT_FALSE(import.ok());
  return import ? ErrorCode::internal : import.error().code;
}

/// Alpha of one pixel of the drawing at 100 x 100 px.
int alpha_at(const std::string& file, int x, int y) {
  const auto drawing = painted_svg(file, 100, 100);
  EXPECT_TRUE(drawing.ok()) << (drawing ? "" : to_string(drawing.error()));
  return drawing ? drawing->rgba.at(x, y, 3) : -1;
}

TEST(SvgSecurity, WhatIsNotSvgIsRefused) {
  for (const char* file :
       {"", "x", "<svg", "<svg></g>", "<html/>", "<?xml version='1.0'?>", "\x1f\x8b\x08"}) {
    EXPECT_EQ(code_of(file), ErrorCode::bad_input) << file;
  }
  EXPECT_EQ(code_of(svg_file("")), ErrorCode::bad_input);
  EXPECT_EQ(code_of(svg_file(square, "width='5000' height='1'")), ErrorCode::bad_input);
}

/// A document type with entities a0 to a29, each four times as long as the one before.
std::string bomb(const std::string& first) {
  std::string text = "<!DOCTYPE svg [<!ENTITY a0 '" + first + "'>";
  for (int i = 1; i < 30; ++i) {
    const std::string inner = "&a" + std::to_string(i - 1) + ";";
    text += "<!ENTITY a" + std::to_string(i) + " '" + inner + inner + inner + inner + "'>";
  }
  return text + "]>";
}

TEST(SvgSecurity, EntitiesThatGrowAreRefused) {
  for (const char* first : {"lol", ""})
    EXPECT_EQ(code_of(bomb(first) + svg_file("<title>&a29;</title>" + std::string(square))),
              ErrorCode::limit);
  EXPECT_EQ(code_of("<!DOCTYPE svg [<!ENTITY a '&b;'><!ENTITY b '&a;'>]>" + svg_file("&a;")),
            ErrorCode::bad_input);
}

TEST(SvgSecurity, ExternalEntitiesAreNeverRead) {
  const std::string file =
      "<!DOCTYPE svg [<!ENTITY file SYSTEM 'file:///etc/passwd'>]>" +
      svg_file("<title>&file;</title><rect id='&file;' width='100' height='100'/>");
  const understanding::LayeredDrawing import = import_of(file);
  ASSERT_EQ(import.scene.parts.size(), 1u);
  EXPECT_EQ(import.scene.parts[0].id, "&file;");
  ASSERT_EQ(import.warnings.size(), 1u);
  EXPECT_NE(import.warnings[0].find("&file;"), std::string::npos);
}

TEST(SvgSecurity, StylesThatGrowAreRefused) {
  std::string css = "rect{--a0:xxxxxxxx;";
  for (int i = 1; i < 40; ++i) {
    const std::string inner = "var(--a" + std::to_string(i - 1) + ")";
    css += "--a" + std::to_string(i) + ":" + inner + inner + ";";
  }
  EXPECT_EQ(code_of(svg_file("<style>" + css + "fill:var(--a39)}</style>" + square)),
            ErrorCode::limit);
  std::string symbols = "<g id='s0'><rect width='9' height='9' fill='var(--c)'/></g>";
  for (int i = 1; i < 40; ++i) {
    const std::string use = "<use href='#s" + std::to_string(i - 1) + "'/>";
    symbols += "<g id='s" + std::to_string(i) + "'>" + use + use + use + "</g>";
  }
  EXPECT_EQ(code_of(svg_file("<defs>" + symbols + "</defs><use href='#s39'/>")), ErrorCode::limit);
}

TEST(SvgSecurity, NamespacesThatAreEntitiesStillRender) {
  const std::string file =
      "<!DOCTYPE svg [<!ENTITY ns_svg 'http://www.w3.org/2000/svg'>]>"
      "<svg xmlns='&ns_svg;' width='1000' height='1000'>" +
      std::string(square) + "</svg>";
  EXPECT_EQ(import_of(file).scene.parts.size(), 1u);
  EXPECT_EQ(alpha_at(file, 5, 5), 255);
  EXPECT_EQ(alpha_at(file, 50, 50), 0);
}

TEST(SvgSecurity, NothingOutsideTheFileIsRead) {
  const std::string path = std::string(RELIEVO_TEST_SOURCE_DIR) + "/io/svg/square.svg";
  ASSERT_FALSE(file_bytes(path).empty());
  for (const std::string& href : {path, "file://" + path}) {
    const std::string file = svg_file(
        "<image href='" + href + "' width='1000' height='1000'/><use xlink:href='" + href +
        "#square'/><image xlink:href='" + href + "' width='1000' height='1000'/>" + square);
    EXPECT_EQ(import_of(file).scene.parts.size(), 1u);
    EXPECT_EQ(alpha_at(file, 50, 50), 0);
    EXPECT_EQ(alpha_at(file, 5, 5), 255);
  }
}

TEST(SvgSecurity, ScriptsAndForeignContentAreIgnored) {
  const std::string file = svg_file(
      "<script>throw 1</script><foreignObject width='1000' height='1000'><body>x</body>"
      "</foreignObject><rect width='100' height='100' onload='x()'/>");
  EXPECT_EQ(import_of(file).scene.parts.size(), 1u);
  EXPECT_EQ(alpha_at(file, 50, 50), 0);
}

TEST(SvgSecurity, WhatIsNotSvgInsideIsNotPainted) {
  const std::string include =
      "<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' "
      "href='data:text/xml,%3Crect%20xmlns%3D%22http%3A//www.w3.org/2000/svg%22%20width%3D%221000"
      "%22%20height%3D%221000%22/%3E'/>";
  const std::string foreign = "<rect xmlns='urn:other' width='1000' height='1000'/>";
  const std::string prefixed =
      "<s:rect xmlns:s='http://www.w3.org/2000/svg' x='800' width='200' height='200'/>";
  const std::string file = svg_file(square + include + foreign + prefixed);
  EXPECT_EQ(alpha_at(file, 50, 50), 0);
  EXPECT_EQ(alpha_at(file, 5, 5), 255);
  EXPECT_EQ(alpha_at(file, 90, 5), 255);
  const auto drawing = read_svg(file);
  ASSERT_TRUE(drawing.ok());
  EXPECT_EQ(drawing->paintable.text.find("include"), std::string::npos);
  EXPECT_EQ(drawing->paintable.text.find("urn:other"), std::string::npos);
}

/// The renderer ends itself on a convolution whose size does not fit what it is made of.
TEST(SvgSecurity, ARendererThatCrashesIsNoCrashOfOurs) {
  std::string ones;
  for (int i = 0; i < 3600; ++i) ones += "1 ";
  const std::string file =
      svg_file("<filter id='f'><feConvolveMatrix order='60' kernelMatrix='" + ones +
               "'/></filter><rect width='900' height='900' "
               "filter='url(#f)'/>");
  const auto drawing = painted_svg(file, 100, 100);
  EXPECT_TRUE(drawing.ok() || drawing.error().code == ErrorCode::bad_input);
}

TEST(SvgSecurity, EmbeddedPicturesOfUnknownOrHugeSizeAreNotPainted) {
  // A PNG header that claims 100000 x 100000 px.
  const char* const huge =
      "<image width='1000' height='1000' href='data:image/png;base64,"
      "iVBORw0KGgoAAAANSUhEUgABhqAAAYagCAYAAAA='/>";
  EXPECT_EQ(alpha_at(svg_file(std::string(huge) + square), 50, 50), 0);
  const char* const one_pixel =
      "<image width='1000' height='1000' preserveAspectRatio='none' href='data:image/png;base64,"
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5E"
      "rkJggg=='/>";
  EXPECT_GT(alpha_at(svg_file(std::string(one_pixel) + square), 50, 50), 100);
}

TEST(SvgSecurity, UseThatLeadsBackEnds) {
  const understanding::LayeredDrawing import = import_of(svg_file(
      "<g id='a'><use href='#b'/><rect width='90' height='90'/></g><g id='b'><use href='#a'/></g>"
      "<use id='c' href='#c'/>"));
  EXPECT_EQ(import.scene.parts.size(), 1u);
  EXPECT_FALSE(import.warnings.empty());
}

TEST(SvgSecurity, UseThatMultipliesIsALimit) {
  std::string content = "<g id='u0'>" + std::string(square) + "</g>";
  for (int i = 1; i < 40; ++i) {
    const std::string inner = "<use href='#u" + std::to_string(i - 1) + "'/>";
    content += "<g id='u" + std::to_string(i) + "'>" + inner + inner + "</g>";
  }
  EXPECT_EQ(code_of(svg_file(content)), ErrorCode::limit);
}

TEST(SvgSecurity, ClipPathsThatLeadBackEnd) {
  const understanding::LayeredDrawing import = import_of(
      svg_file("<clipPath id='c'><rect width='50' height='50' clip-path='url(#c)'/></clipPath>"
               "<rect width='100' height='100' clip-path='url(#c)'/>"));
  EXPECT_EQ(import.scene.parts.size(), 1u);
}

TEST(SvgSecurity, DeepNestingIsALimit) {
  std::string open;
  std::string close;
  for (int i = 0; i < 100000; ++i) {
    open += "<g>";
    close += "</g>";
  }
  SvgOptions options;
  options.max_elements = 200000;
  EXPECT_EQ(code_of(svg_file(open + square + close), options), ErrorCode::limit);
}

TEST(SvgSecurity, CountsAndSizesAreLimits) {
  std::string many;
  for (int i = 0; i < 50; ++i) many += square;
  SvgOptions options;
  options.max_elements = 40;
  EXPECT_EQ(code_of(svg_file(many), options), ErrorCode::limit);
  options = {};
  options.max_points = 100;
  EXPECT_EQ(code_of(svg_file(many), options), ErrorCode::limit);
  options = {};
  options.max_bytes = 1000;
  EXPECT_EQ(code_of(svg_file(many), options), ErrorCode::limit);
  auto drawing = read_svg(svg_file(many));
  ASSERT_TRUE(drawing.ok());
  const Status status = understanding::make_parts(*drawing, 49);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::limit);
  EXPECT_EQ(painted_svg(svg_file(square), 100000, 5).error().code, ErrorCode::limit);
  EXPECT_EQ(painted_svg(svg_file(square), 0, 5).error().code, ErrorCode::limit);
}

TEST(SvgSecurity, TanglesAreLeftOutAndNamed) {
  std::string scribble = "<path id='scribble' d='M0 0";
  uint32_t state = 1;
  for (int i = 0; i < 20000; ++i) {
    state = state * 1664525u + 1013904223u;
    scribble += "L" + std::to_string(state >> 22) + " " + std::to_string(state >> 12 & 1023);
  }
  const understanding::LayeredDrawing import = import_of(svg_file(scribble + "'/>" + square));
  EXPECT_EQ(import.scene.parts.size(), 1u);
  ASSERT_EQ(import.warnings.size(), 1u);
  EXPECT_NE(import.warnings[0].find("scribble"), std::string::npos);
}

TEST(SvgSecurity, HugeCoordinatesDoNoHarm) {
  const understanding::LayeredDrawing import = import_of(svg_file(
      "<path d='M -874699606 5 C 1e9 1e9 -1e9 1e9 874699606 5 Z'/>"
      "<circle cx='1e30' cy='0' r='1e30'/><path d='M0 0L1e308 1e308' stroke='red' "
      "stroke-width='1e300'/><rect transform='scale(1e200)' width='1e200' height='1e200'/>" +
      std::string("<rect x='700' y='2' width='100' height='1'/>") + square));
  for (const Part& part : import.scene.parts) {
    const Box2 box = bounding_box(part.outline);
    EXPECT_GE(box.min.x, 0);
    EXPECT_LE(box.max.x, 1000);
    EXPECT_LE(box.max.y, 1000);
  }
}

}  // namespace
}  // namespace relievo
