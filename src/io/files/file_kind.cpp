#include "io/files/file_kind.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

using std::string_view_literals::operator""sv;

/// The part of a file in which its magic is sought.
enum class Place {
  file,    ///< from the first byte on
  text,    ///< from the first letter on, after a byte order mark and white space
  markup,  ///< likewise, and after comments and the XML declaration; in lower case
};

/// The signs of a kind of file: bytes at a distance from a place, and words that must all occur
/// somewhere in the file.
struct Magic {
  Place place;
  size_t at;
  std::string_view bytes;
  std::vector<std::string_view> words = {};
};

struct KnownKind {
  FileKind kind;
  std::vector<Magic> magics;  ///< of which one must match
};

/// The first that matches counts. Relievo's own files and OpenRaster drawings come first, since the
/// words of other kinds are sought in the whole file.
const std::vector<KnownKind> known_kinds = {
    {{InputKind::zip, "a project", ""}, {{Place::file, 30, "mimetypeapplication/vnd.relievo"}}},
    {{InputKind::zip, "an OpenRaster drawing", ""},
     {{Place::file, 30, "mimetypeimage/openraster"}}},
    {{InputKind::json, "a scene file", ""}, {{Place::text, 0, "{", {"\"relievo-scene\""}}}},
    {{InputKind::foreign, "a PNG picture packed for an iPhone app (CgBI)",
      "unpack it, for example with: pngcrush -revert-iphone-optimizations"},
     {{Place::file, 12, "CgBI", {"\x89PNG"}}}},
    {{InputKind::image, "a PNG picture", ""}, {{Place::file, 0, "\x89PNG"}}},
    {{InputKind::image, "a JPEG picture", ""}, {{Place::file, 0, "\xff\xd8\xff"}}},
    {{InputKind::image, "a GIF picture", ""}, {{Place::file, 0, "GIF8"}}},
    {{InputKind::image, "a WebP picture", "save it as PNG"}, {{Place::file, 8, "WEBP", {"RIFF"}}}},
    {{InputKind::image, "an AVIF picture", "save it as PNG"},
     {{Place::file, 4, "ftypavif"}, {Place::file, 4, "ftypavis"}}},
    {{InputKind::image, "a HEIC photo", "save it as JPEG or PNG"},
     {{Place::file, 4, "ftyphe"}, {Place::file, 4, "ftypmif1"}, {Place::file, 4, "ftypmsf1"}}},
    {{InputKind::foreign, "a video",
      "save one of its frames as PNG, or all of them for relievo sequence"},
     {{Place::file, 4, "ftyp"},
      {Place::file, 0, "\x1a\x45\xdf\xa3"},
      {Place::file, 8, "AVI ", {"RIFF"}}}},
    {{InputKind::foreign, "a JPEG XL picture", "save it as PNG"},
     {{Place::file, 0, "\xff\x0a"}, {Place::file, 4, "JXL \r\n\x87\n"}}},
    {{InputKind::foreign, "a JPEG 2000 picture", "save it as PNG"},
     {{Place::file, 4, "jP  \r\n\x87\n"}}},
    {{InputKind::foreign, "a TIFF picture, or a camera's raw one", "save it as PNG"},
     {{Place::file, 0, "II*\0"sv},
      {Place::file, 0, "MM\0*"sv},
      {Place::file, 0, "II+\0"sv},
      {Place::file, 0, "MM\0+"sv}}},
    {{InputKind::foreign, "a BMP picture", "save it as PNG"},
     {{Place::file, 0, "BM", {"\0\0\0\0"sv}}}},
    {{InputKind::foreign, "an icon (ICO)", "save its largest picture as PNG"},
     {{Place::file, 0, "\0\0\1\0"sv}, {Place::file, 0, "icns"}}},
    {{InputKind::foreign, "an OpenEXR picture", "save it as PNG"}, {{Place::file, 0, "v/1\1"}}},
    {{InputKind::foreign, "a QOI picture", "save it as PNG"}, {{Place::file, 0, "qoif"}}},
    {{InputKind::foreign, "a packed texture (DDS)", "save it as PNG"}, {{Place::file, 0, "DDS "}}},
    {{InputKind::foreign, "a Windows metafile", "save it as SVG"},
     {{Place::file, 0, "\xd7\xcd\xc6\x9a"}, {Place::file, 40, " EMF"}}},
    {{InputKind::foreign, "a PDF document, as Illustrator's files (.ai) are", "export it as SVG"},
     {{Place::text, 0, "%PDF-"}}},
    {{InputKind::foreign, "a PostScript drawing (EPS or AI)", "export it as SVG"},
     {{Place::text, 0, "%!PS"}, {Place::file, 0, "\xc5\xd0\xd3\xc6"}}},
    {{InputKind::foreign, "a CAD drawing (DXF or DWG)", "export it as SVG, with filled areas"},
     {{Place::text, 0, "0", {"SECTION", "ENTITIES"}},
      {Place::text, 0, "999", {"SECTION", "ENTITIES"}},
      {Place::file, 0, "AutoCAD Binary DXF"},
      {Place::file, 0, "AC10", {"\0"sv}}}},
    {{InputKind::foreign, "a drawing of CorelDRAW (CDR)", "export it as SVG"},
     {{Place::file, 8, "CDR", {"RIFF"}}, {Place::file, 0, "PK\3\4", {"content/riffData.cdr"}}}},
    {{InputKind::foreign, "a document of Affinity", "export it as SVG or Photoshop (.psd)"},
     {{Place::file, 0, "\0\xffKA"sv}}},
    {{InputKind::foreign, "a document of Sketch", "export it as SVG"},
     {{Place::file, 0, "PK\3\4", {"document.json", "meta.json", "pages/"}}}},
    {{InputKind::foreign, "a document of Figma", "export it as SVG"},
     {{Place::file, 0, "fig-kiwi"}, {Place::file, 0, "PK\3\4", {"canvas.fig"}}}},
    {{InputKind::foreign, "a picture of GIMP (XCF)",
      "export it as OpenRaster (.ora), which keeps its layers"},
     {{Place::file, 0, "gimp xcf"}}},
    {{InputKind::zip, "a drawing of Krita (.kra)",
      "save it as OpenRaster (.ora) or Photoshop (.psd), which keeps its layers"},
     {{Place::file, 0, "PK\3\4", {"application/x-krita"}}}},
    {{InputKind::zip, "a drawing of Procreate", "share it as PSD, which keeps its layers"},
     {{Place::file, 0, "PK\3\4", {"Document.archive", "QuickLook/"}}}},
    {{InputKind::foreign, "a drawing of Clip Studio Paint (.clip)",
      "export it as Photoshop (.psd), which keeps its layers"},
     {{Place::file, 0, "CSFCHUNK"}}},
    {{InputKind::foreign, "a drawing of SAI",
      "export it as Photoshop (.psd), which keeps its layers"},
     {{Place::file, 0, "SAI-CANVAS"}}},
    {{InputKind::foreign, "a drawing of MediBang or FireAlpaca (.mdp)",
      "export it as Photoshop (.psd), which keeps its layers"},
     {{Place::file, 0, "mdipack"}}},
    {{InputKind::foreign, "a drawing of Paint.NET (.pdn)",
      "save it as PNG, or as OpenRaster (.ora) with a plug-in"},
     {{Place::file, 0, "PDN3"}}},
    {{InputKind::foreign, "a sprite of Aseprite (.ase, .aseprite)",
      "export it as PNG, or as a sprite sheet with its JSON data for relievo sequence"},
     {{Place::file, 4, "\xe0\xa5", {"\xfa\xf1"}}}},
    {{InputKind::foreign, "a model of Live2D",
      "give the Photoshop file (.psd) that it was made from"},
     {{Place::file, 0, "MOC3"}, {Place::file, 0, "CAFF"}}},
    {{InputKind::foreign, "an animation of Rive", "export a frame as SVG"},
     {{Place::file, 0, "RIVE"}}},
    {{InputKind::foreign, "a Lottie animation",
      "export its frames as SVG for relievo build or sequence"},
     {{Place::file, 0, "PK\3\4", {"manifest.json", "animations/"}},
      {Place::text, 0, "{", {"\"layers\"", "\"fr\"", "\"op\""}}}},
    {{InputKind::foreign, "a skeleton of Spine",
      "give the layers that it moves, as Photoshop (.psd) or as a folder of PNG files"},
     {{Place::text, 0, "{", {"\"skeleton\"", "\"bones\""}}}},
    {{InputKind::foreign, "a drawing of Excalidraw", "export it as SVG"},
     {{Place::text, 0, "{", {"\"excalidraw\""}}}},
    {{InputKind::foreign, "a drawing of tldraw", "export it as SVG"},
     {{Place::text, 0, "{", {"\"tldrawFileFormatVersion\""}}}},
    {{InputKind::sprites, "a list of sprites", "use it with: relievo sequence"},
     {{Place::text, 0, "{", {"\"frames\"", "\"frame\""}},
      {Place::text, 0, "{", {"\"frames\"", "\"meta\""}},
      {Place::text, 0, "{", {"\"frames\"", "\"textures\""}}}},
    {{InputKind::foreign, "a vector drawable of Android", "export it as SVG"},
     {{Place::markup, 0, "<vector", {"schemas.android.com"}}}},
    {{InputKind::glb, "a finished model",
      "open the drawing that it was made from, or use it with: relievo render"},
     {{Place::file, 0, "glTF"}}},
    {{InputKind::foreign, "a finished model", "open the drawing that it was made from"},
     {{Place::text, 0, "{", {"\"asset\"", "\"meshes\"", "\"accessors\""}},
      {Place::file, 0, "PK\3\4", {"3D/3dmodel.model"}},
      {Place::text, 0, "solid ", {"facet normal"}},
      {Place::text, 0, "ply", {"end_header"}}}},
    {{InputKind::foreign, "a document of an office program", "export its drawing as SVG or PNG"},
     {{Place::file, 0, "PK\3\4", {"[Content_Types].xml"}},
      {Place::file, 0, "PK\3\4", {"application/vnd.oasis.opendocument"}},
      {Place::file, 0, "\xd0\xcf\x11\xe0"}}},
    {{InputKind::text, "a web page, not a picture", "download it again"},
     {{Place::markup, 0, "<!doctype html"},
      {Place::markup, 0, "<html"},
      {Place::markup, 0, "<head"},
      {Place::markup, 0, "<body"},
      {Place::markup, 0, "<script"},
      {Place::markup, 0, "<meta"}}},
    {{InputKind::text, "a server's error, not a picture", "download it again"},
     {{Place::markup, 0, "<error"}}},
    {{InputKind::text, "a pointer of Git LFS, not the picture", "fetch it with: git lfs pull"},
     {{Place::text, 0, "version https://git-lfs.github.com/spec/"}}},
    {{InputKind::foreign, "compressed, as .svgz files are",
      "unpack it first, for example with gunzip"},
     {{Place::file, 0, "\x1f\x8b"}}},
    {{InputKind::foreign, "an archive", "unpack it first"},
     {{Place::file, 0, "7z\xbc\xaf"}, {Place::file, 0, "Rar!\x1a"}}},
    {{InputKind::foreign, "a Blender file", "give the drawing; Blender has an add-on for it"},
     {{Place::file, 0, "BLENDER"}}},
    {{InputKind::psd, "a Photoshop document", ""}, {{Place::file, 0, "8BPS"}}},
    {{InputKind::zip, "an archive", ""}, {{Place::file, 0, "PK\3\4"}}},
    {{InputKind::svg, "an SVG drawing", ""},
     {{Place::file, 0, "\xff\xfe<\0"sv},
      {Place::file, 0, "\xfe\xff\0<"sv},
      {Place::file, 0, "\0<"sv},
      {Place::text, 0, "<"}}},
    {{InputKind::json, "a JSON file", ""}, {{Place::text, 0, "{"}, {Place::text, 0, "["}}},
};

/// Number of bytes that must be letters for a file to count as text.
constexpr size_t looked_at = 512;

/// Length of the longest name of a first tag that is known, bytes.
constexpr size_t longest_tag = 32;

constexpr std::string_view white = " \t\r\n";

std::string_view text_in(std::string_view file) {
  if (file.substr(0, 3) == "\xef\xbb\xbf") file.remove_prefix(3);
  file.remove_prefix(std::min(file.size(), file.find_first_not_of(white)));
  return file;
}

bool is_text(std::string_view file) {
  const std::string_view head = file.substr(0, looked_at);
  return std::all_of(head.begin(), head.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isprint(byte) != 0 || white.find(c) != std::string_view::npos;
  });
}

}  // namespace

FileKind file_kind(ByteView bytes) {
  const std::string_view file{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  const std::string_view text = text_in(file);
  const std::string markup = lower_case(after_prolog(text).substr(0, longest_tag));
  const auto matches = [&](const Magic& magic) {
    const std::string_view from = magic.place == Place::file   ? file
                                  : magic.place == Place::text ? text
                                                               : std::string_view(markup);
    if (from.size() < magic.at || from.substr(magic.at, magic.bytes.size()) != magic.bytes)
      return false;
    return std::all_of(magic.words.begin(), magic.words.end(), [&](std::string_view word) {
      return file.find(word) != std::string_view::npos;
    });
  };
  for (const KnownKind& known : known_kinds)
    if (std::any_of(known.magics.begin(), known.magics.end(), matches)) return known.kind;
  if (!text.empty() && is_text(file))
    return {InputKind::text, "text, not a drawing", "download it again if it should be a picture"};
  return {InputKind::unknown,
          "neither a picture (PNG, JPEG, GIF, WebP, AVIF, HEIC) nor an SVG, OpenRaster or "
          "Photoshop drawing nor a scene or project file",
          "export it as SVG, PSD or PNG"};
}

InputKind sniff(ByteView bytes) { return file_kind(bytes).kind; }

Error refused_file(ByteView bytes) {
  const FileKind kind = file_kind(bytes);
  const std::string_view remedy = kind.remedy.empty() ? "a picture is needed here" : kind.remedy;
  return {ErrorCode::bad_input, "is " + std::string(kind.name) + "; " + std::string(remedy), ""};
}

}  // namespace relievo
