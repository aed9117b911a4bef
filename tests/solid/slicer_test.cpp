#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/mesh/threemf_encode.h"
#include "io/support/temporary_folder.h"
#include "samples/drawing_relief.h"
#include "solid/program_output.h"
#include "solid/solid_case.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using namespace testing;

double number_after(const std::string& text, const std::string& name) {
  const size_t at = text.find(name);
  return at == std::string::npos ? -1 : std::atof(text.c_str() + at + name.size());
}

/// Layers, and those among them without an extrusion.
struct Layers {
  int all = 0;
  int empty = 0;
};

Layers layers_of(const std::string& gcode) {
  Layers layers;
  bool extruded = true;
  std::ifstream in(gcode);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(";LAYER_CHANGE")) {
      layers.empty += extruded ? 0 : 1;
      ++layers.all;
      extruded = false;
    }
    if (line.starts_with("G1 X") && line.find(" E") != std::string::npos) extruded = true;
  }
  return layers;
}

void expect_sliceable(const fs::path& file, double volume) {
  SCOPED_TRACE(file.filename());
  const std::string facts = output_of("prusa-slicer --info '" + file.string() + "'");
  EXPECT_NE(facts.find("manifold = yes"), std::string::npos) << facts;
  EXPECT_EQ(facts.find("repaired"), std::string::npos) << facts;
  EXPECT_NEAR(number_after(facts, "volume = "), volume, 0.005 * volume) << facts;
  const fs::path gcode = fs::path(file).replace_extension(".gcode");
  const std::string said =
      output_of("prusa-slicer --export-gcode -o '" + gcode.string() + "' '" + file.string() + "'");
  EXPECT_NE(said.substr(0, 7), "failed:") << said;
  const Layers layers = layers_of(gcode.string());
  EXPECT_GT(layers.all, 20);
  EXPECT_EQ(layers.empty, 0);
}

TEST(Slicer, SlicesSolidsAndFiguresOfAllDrawings) {
  if (output_of("prusa-slicer --help").starts_with("failed:"))
    GTEST_SKIP() << "prusa-slicer is not installed";
  std::vector<std::string> paths = drawings_in(RELIEVO_EXAMPLES);
  for (const std::string& path : drawings_in(RELIEVO_SHARED_DATA "/layered")) paths.push_back(path);
  for (const std::string& path : paths) {
    SCOPED_TRACE(path);
    const DrawnRelief drawn = relief_of(path, {});
    const relief::VisibleSheet sheet = sheet_of(drawn.scene, drawn.relief);
    for (const BackSide back : {BackSide::flat, BackSide::mirror}) {
      SolidOptions options;
      options.back = back;
      const auto solid = make_solid(sheet, drawn.drawing, options);
      ASSERT_TRUE(solid.ok()) << to_string(solid.error());
      const TemporaryFolder folder;
      const fs::path stl = folder.path() / "solid.stl";
      std::ofstream(stl, std::ios::binary) << stl_of(solid->model);
      expect_sliceable(stl, solid->facts.volume);
      const auto painted = encode_3mf(solid->model, &solid->drawing);
      ASSERT_TRUE(painted.ok());
      const fs::path package = folder.path() / "solid.3mf";
      std::ofstream(package, std::ios::binary)
          .write(reinterpret_cast<const char*>(painted->data()),
                 static_cast<std::streamsize>(painted->size()));
      expect_sliceable(package, solid->facts.volume);
    }
  }
}

}  // namespace
}  // namespace relievo
