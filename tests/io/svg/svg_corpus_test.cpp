#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <optional>

#include "io/svg/coverage.h"
#include "io/svg/render_svg.h"
#include "io/svg/svg_test_support.h"

namespace relievo {
namespace {

const std::filesystem::path corpus =
    std::filesystem::path(RELIEVO_SHARED_DATA) / "adversarial" / "svg" / "resvg";

std::optional<Drawing> read_golden(const std::filesystem::path& path) {
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, path.c_str())) return std::nullopt;
  png.format = PNG_FORMAT_RGBA;
  Drawing drawing{Image8(static_cast<int>(png.width), static_cast<int>(png.height), 4)};
  if (!png_image_finish_read(&png, nullptr, drawing.rgba.pixels.data(), 0, nullptr)) {
    return std::nullopt;
  }
  return drawing;
}

/// All that the drawing paints with at least half alpha, as one part.
Scene painted(const SvgDrawing& drawing) {
  std::vector<Region> regions;
  for (const SvgShape& shape : drawing.shapes) {
    if (shape.fill && shape.fill->a >= 0.499) regions.push_back(fill_of(shape, drawing));
    if (shape.stroke && shape.stroke->a >= 0.499) regions.push_back(stroke_of(shape, drawing));
  }
  Scene scene;
  scene.width = drawing.width;
  scene.height = drawing.height;
  scene.parts.push_back({"all", unite(regions)});
  return scene;
}

/// Fraction of pixels on which the mask and the alpha of the picture agree.
double pixel_agreement(const Scene& scene, const Image8& rgba) {
  const Image8 mask = silhouette_mask(scene, rgba.width, rgba.height);
  int64_t equal = 0;
  for (int y = 0; y < rgba.height; ++y) {
    for (int x = 0; x < rgba.width; ++x) {
      equal += (mask.at(x, y) != 0) == (rgba.at(x, y, 3) >= 127) ? 1 : 0;
    }
  }
  return static_cast<double>(equal) / static_cast<double>(mask.pixels.size());
}

TEST(SvgCorpus, EveryFileIsReadOrRefusedWithAReason) {
  const auto files = files_below(corpus, ".svg");
  if (files.empty()) GTEST_SKIP() << "no corpus in " << corpus;
  int read = 0;
  for (const auto& path : files) {
    const std::string file = file_bytes(path);
    const auto import = read_parts(file);
    const auto drawing = painted_svg(file, 200, 200);
    read += import ? 1 : 0;
    if (!import) {
      EXPECT_FALSE(import.error().message.empty()) << path;
      continue;
    }
    for (const Part& part : import->scene.parts) EXPECT_GT(area(part.outline), 0) << path;
    if (drawing) continue;
    EXPECT_FALSE(drawing.error().message.empty()) << path;
  }
  EXPECT_GE(read, 550);
}

/// Text, pictures, masks, markers and patterns have no geometry here.
bool is_plain(const std::filesystem::path& path) {
  const std::string folder = path.parent_path().filename();
  if (folder == "structure_image" || folder.substr(0, 7) == "masking") return false;
  if (folder == "painting_paint-order") return false;
  const std::string file = file_bytes(path);
  return file.find("<text") == std::string::npos && file.find("<pattern") == std::string::npos &&
         file.find("<image") == std::string::npos && file.find("<!ENTITY") == std::string::npos;
}

TEST(SvgCorpus, PlainGeometryAgreesWithTheReferencePictures) {
  const auto files = files_below(corpus, ".svg");
  if (files.empty()) GTEST_SKIP() << "no corpus in " << corpus;
  int compared = 0;
  int agreeing = 0;
  for (const auto& path : files) {
    auto golden = read_golden(std::filesystem::path(path).replace_extension(".png"));
    const auto document = parse_svg_document(file_bytes(path), {});
    if (!golden || !document || !is_plain(path)) continue;
    const auto drawing = read_drawing(**document, {});
    ASSERT_TRUE(drawing.ok()) << path;
    ++compared;
    if (pixel_agreement(painted(*drawing), golden->rgba) > 0.99) ++agreeing;
  }
  RecordProperty("compared", compared);
  RecordProperty("agreeing", agreeing);
  EXPECT_GT(compared, 250);
  EXPECT_GT(agreeing, 0.94 * compared) << agreeing << " of " << compared;
}

}  // namespace
}  // namespace relievo
