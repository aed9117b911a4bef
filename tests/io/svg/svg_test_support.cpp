#include "io/svg/svg_test_support.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "io/svg/render_svg.h"
#include "understanding/marks/make_parts.h"

#if defined(__SANITIZE_ADDRESS__)
// Fontconfig keeps its tables until the process ends when a drawing has text.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
#endif

namespace relievo {

std::string svg_file(const std::string& content, const std::string& attributes) {
  const std::string size = attributes.empty() ? R"(width="1000" height="1000")" : attributes;
  return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" )"
         R"(xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" )" +
         size + ">" + content + "</svg>";
}

SvgDrawing drawing_of(const std::string& file) {
  const auto document = parse_svg_document(file, {});
  EXPECT_TRUE(document.ok());
  if (!document) return {};
  auto drawing = read_drawing(**document, {});
  EXPECT_TRUE(drawing.ok());
  if (!drawing) return {};
  // They belong to the document, which is gone.
  for (SvgShape& shape : drawing->shapes) shape.element = {};
  for (SvgGroup& group : drawing->groups) group.element = {};
  return std::move(*drawing);
}

Result<understanding::LayeredDrawing> read_parts(const std::string& file,
                                                 const SvgOptions& options) {
  auto drawing = read_svg(file, options);
  if (!drawing) return drawing;
  if (Status status = understanding::make_parts(*drawing); !status) return status.error();
  return drawing;
}

understanding::LayeredDrawing import_of(const std::string& file) {
  auto import = read_parts(file);
  EXPECT_TRUE(import.ok()) << (import ? "" : to_string(import.error()));
  return import ? std::move(*import) : understanding::LayeredDrawing();
}

Result<Drawing> painted_svg(const std::string& file, int width, int height) {
  const auto drawing = read_svg(file);
  if (!drawing) return drawing.error();
  return render_svg(drawing->paintable, width, height);
}

Region fill_of_only_shape(const std::string& content) {
  const SvgDrawing drawing = drawing_of(svg_file(content));
  EXPECT_EQ(drawing.shapes.size(), 1u);
  return drawing.shapes.size() == 1 ? fill_of(drawing.shapes[0], drawing) : Region();
}

std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               const std::string& extension) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace relievo
