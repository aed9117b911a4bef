#include "io/files/file_kind.h"

#include <gtest/gtest.h>

#include <string>

namespace relievo {
namespace {

using namespace std::string_literals;

struct Example {
  std::string bytes;
  std::string name;    ///< a part of the kind's name
  std::string remedy;  ///< a part of what to do
};

std::string refusal(const std::string& bytes) { return refused_file(bytes_of(bytes)).message; }

TEST(FileKind, FilesOfOtherProgramsAreNamedWithARemedy) {
  const std::string cgbi = "\x89PNG\r\n\x1a\n\0\0\0\4CgBI"s;
  const std::string zip = "PK\3\4"s + std::string(26, '\0');
  for (const Example& one : std::vector<Example>{
           {"\0\0\0\x18"
            "ftypheic\0\0\0\0"s,
            "HEIC", "JPEG or PNG"},
           {"\0\0\0\x1c"
            "ftypavif"s,
            "AVIF", "PNG"},
           {"\0\0\0\x20"
            "ftypisom"s,
            "video", "PNG"},
           {"II*\0\x08"s, "TIFF", "PNG"},
           {"MM\0*"s, "TIFF", "PNG"},
           {"BM\x36\0\0\0\0\0\0\0"s, "BMP", "PNG"},
           {"\0\0\0\x0cJXL \r\n\x87\n"s, "JPEG XL", "PNG"},
           {"%PDF-1.7\n", "PDF", "SVG"},
           {"%!PS-Adobe-3.0 EPSF-3.0", "PostScript", "SVG"},
           {"\xc5\xd0\xd3\xc6", "EPS", "SVG"},
           {"  0\r\nSECTION\r\n  2\r\nHEADER\r\n  0\r\nSECTION\r\n  2\r\nENTITIES", "DXF", "SVG"},
           {"gimp xcf v011\0"s, "GIMP", "OpenRaster"},
           {zip + "mimetypeapplication/x-krita", "Krita", "OpenRaster"},
           {zip + "Document.archive" + zip + "QuickLook/Thumbnail.png", "Procreate", "PSD"},
           {"CSFCHUNK\0\0"s, "Clip Studio", "Photoshop"},
           {"\x40\0\0\0\xe0\xa5\x01\0"s + std::string(124, '\0') + "\xfa\xf1", "Aseprite", "PNG"},
           {cgbi, "CgBI", "pngcrush"},
           {"<!doctype html><p>Not Found</p>", "web page", "download"},
           {"\xef\xbb\xbf \n<HTML>", "web page", "download"},
           {"<?xml version='1.0'?><!-- x --><!DOCTYPE HTML PUBLIC>", "web page", "download"},
           {"<?xml version='1.0'?>\n<Error><Code>AccessDenied</Code></Error>", "error", "download"},
           {"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "LFS", "git lfs"},
           {R"({"v":"5.5","fr":30,"ip":0,"op":60,"w":9,"h":9,"layers":[]})", "Lottie", "SVG"},
           {R"({"skeleton":{"hash":""},"bones":[]})", "Spine", "Photoshop"},
           {R"({ "type": "excalidraw", "elements": [] })", "Excalidraw", "SVG"},
           {R"({"frames": {"a": {"frame": {"x": 0}}}, "meta": {}})", "sprites", "sequence"},
           {"\x1f\x8b\x08", "compressed", "gunzip"},
           {"glTF\2\0\0\0"s, "model", "render"},
           {"404: Not Found\n", "text", "download"}}) {
    const std::string message = refusal(one.bytes);
    EXPECT_NE(message.find(one.name), std::string::npos) << message;
    EXPECT_NE(message.find(one.remedy), std::string::npos) << message;
    EXPECT_EQ(message.substr(0, 3), "is ") << message;
  }
}

TEST(FileKind, WhatIsReadIsFoundByItsContent) {
  const auto kind = [](const std::string& bytes) { return sniff(bytes_of(bytes)); };
  EXPECT_EQ(kind("\x89PNG\r\n\x1a\n"), InputKind::image);
  EXPECT_EQ(kind("\xff\xd8\xff\xe0"), InputKind::image);
  EXPECT_EQ(kind("GIF89a"), InputKind::image);
  EXPECT_EQ(kind("RIFF\x10\0\0\0WEBPVP8 "s), InputKind::image);
  EXPECT_EQ(kind("\0\0\0\x1c"
                 "ftypavif"s),
            InputKind::image);
  EXPECT_EQ(kind("PK\3\4"), InputKind::zip);
  EXPECT_EQ(kind("8BPS"), InputKind::psd);
  EXPECT_EQ(kind("<?xml version='1.0'?><svg/>"), InputKind::svg);
  EXPECT_EQ(kind("<!DOCTYPE svg PUBLIC ''><svg/>"), InputKind::svg);
  EXPECT_EQ(kind("\xff\xfe<\0s\0"s), InputKind::svg);
  EXPECT_EQ(kind("\0<\0s"s), InputKind::svg);
  EXPECT_EQ(kind("\xef\xbb\xbf {\"format\": \"relievo-scene\"}"), InputKind::json);
  EXPECT_EQ(kind(""), InputKind::unknown);
  EXPECT_EQ(kind("\x01\x02\x03"), InputKind::unknown);
  EXPECT_EQ(kind("BMW and other cars"), InputKind::text);
}

TEST(FileKind, EveryBeginningIsSomeKind) {
  const std::string text = "RIFF\x10\0\0\0WEBPVP8 PK\3\4 ftyp {\"frames\""s;
  for (size_t from = 0; from < text.size(); ++from)
    for (size_t size = 0; size + from <= text.size(); ++size)
      EXPECT_FALSE(refusal(text.substr(from, size)).empty());
}

TEST(FileKind, PartsMayHaveTheNamesOfOtherProgramsWords) {
  const std::string scene =
      R"({"format": "relievo-scene", "parts": [{"id": "excalidraw"}, {"id": "bones"}]})";
  EXPECT_EQ(sniff(bytes_of(scene)), InputKind::json);
  const std::string project = "PK\3\4"s + std::string(26, '\0') + "mimetypeapplication/vnd.relievo";
  EXPECT_TRUE(file_kind(bytes_of(project + "canvas.fig")).remedy.empty());
}

}  // namespace
}  // namespace relievo
