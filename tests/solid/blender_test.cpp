#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "io/mesh/glb_encode.h"
#include "io/mesh/obj_encode.h"
#include "io/support/temporary_folder.h"
#include "samples/drawing_relief.h"
#include "solid/program_output.h"
#include "solid/solid_case.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using namespace testing;
using Json = nlohmann::json;

void write(const fs::path& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

/// The box around all objects of a file.
Box3 whole(const Json& objects) {
  Box3 box{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  for (const Json& object : objects) {
    const auto low = object[0].get<std::array<double, 3>>();
    const auto high = object[1].get<std::array<double, 3>>();
    box.min = {std::min(box.min.x, low[0]), std::min(box.min.y, low[1]),
               std::min(box.min.z, low[2])};
    box.max = {std::max(box.max.x, high[0]), std::max(box.max.y, high[1]),
               std::max(box.max.z, high[2])};
  }
  return box;
}

TEST(Blender, ImportsModelsAtOneSizeAndTheRightWayUp) {
  if (output_of("blender --version").starts_with("failed:"))
    GTEST_SKIP() << "blender is not installed";
  const DrawnRelief drawn = relief_of(std::string(RELIEVO_EXAMPLES) + "/wolf.svg", {});
  const auto solid = make_solid(sheet_of(drawn.scene, drawn.relief), drawn.drawing, {});
  ASSERT_TRUE(solid.ok());
  const TemporaryFolder folder;
  write(folder.path() / "m.glb", *encode_glb(solid->model, &solid->drawing, {.size_mm = 100}));
  const auto obj = encode_obj(solid->model, &solid->drawing, {.size_mm = 100}, "m");
  write(folder.path() / "m.obj", obj->obj);
  write(folder.path() / "m.mtl", obj->mtl);
  write(folder.path() / "m.png", obj->png);
  std::ofstream(folder.path() / "m.stl", std::ios::binary) << stl_of(solid->model);
  std::string command =
      "blender --background --factory-startup --python '" RELIEVO_TOOLS "/blender_extents.py' --";
  for (const char* name : {"m.glb", "m.obj", "m.stl"})
    command += " '" + (folder.path() / name).string() + "'";
  const std::string said = output_of(command);
  std::vector<Json> files;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("BOXES ")) files.push_back(Json::parse(line.substr(6)));
  ASSERT_EQ(files.size(), 3U) << said;

  // Blender's Z is up. A GLB is in metres; the other formats have no unit, and theirs is mm.
  const Point3 sides = extent(solid->model).max;
  for (const size_t k : {0, 1}) {
    const double mm = k == 0 ? 1000 : 1;
    const Box3 box = whole(files[k]);
    EXPECT_NEAR(mm * (box.max.x - box.min.x), sides.x, 1e-3);
    EXPECT_NEAR(mm * (box.max.z - box.min.z), sides.y, 1e-3);
    EXPECT_NEAR(mm * (box.max.y - box.min.y), sides.z, 1e-3);
    EXPECT_GT(files[k]["near-ear"][0][2], files[k]["near-front-leg"][1][2]);
    // What is seen in front lies towards -Y, where Blender's front view looks from.
    EXPECT_LT(files[k]["head"][0][1], files[k]["tail"][0][1]);
  }
  // On a printer's plate, back down.
  const Box3 lying = whole(files[2]);
  EXPECT_NEAR(norm(lying.max - sides), 0, 1e-3);
  EXPECT_NEAR(norm(lying.min), 0, 1e-6);
}

}  // namespace
}  // namespace relievo
