#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <vector>

#include "house/include_rules.h"
#include "house/source_files.h"

namespace relievo::house {
namespace {

namespace fs = std::filesystem;

/// Targets of the #include "..." lines of a file.
std::vector<std::string> includes(const std::string& text) {
  const std::string start = "#include \"";
  std::vector<std::string> targets;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(start, 0) == 0)
      targets.push_back(line.substr(start.size(), line.rfind('"') - start.size()));
  return targets;
}

TEST(IncludeGraph, IsTheDataFlow) {
  const auto files = source_files();
  ASSERT_GT(files.size(), 20U);
  for (const SourceFile& file : files)
    for (const std::string& target : includes(file.text))
      EXPECT_EQ(include_violation(file.path, target), "") << file.path << " includes " << target;
}

TEST(IncludeGraph, NamesFilesByTheirFullPath) {
  const fs::path root = RELIEVO_SOURCE_DIR;
  // The build makes it from network.bin.
  const std::string made = "understanding/perception/network_bytes.inc";
  for (const SourceFile& file : source_files())
    for (const std::string& target : includes(file.text))
      EXPECT_TRUE(target == made || fs::exists(root / "src" / target) ||
                  fs::exists(root / "include" / target) || fs::exists(root / target) ||
                  fs::exists(root / "tests" / target))
          << file.path << " includes " << target;
}

TEST(HouseRules, HoldForEveryFile) {
  for (const SourceFile& file : source_files())
    EXPECT_EQ(text_violations(file.path, file.text), "") << file.path;
}

struct Edge {
  const char* from;
  const char* to;
};

TEST(IncludeRules, AllowTheDataFlow) {
  const Edge edges[] = {
      {"kernel/solvers/active_set.cpp", "kernel/base/workers.h"},
      {"kernel/solvers/active_set.cpp", "kernel/solvers/active_set.h"},
      {"kernel/meshing/triangulate.cpp", "kernel/geometry/polygon.h"},
      {"relief/inflation/inflate.cpp", "relief/layers/layered_mesh.h"},
      {"relief/inflation/inflate.cpp", "kernel/cholesky/sparse_cholesky.h"},
      {"relief/surface/assemble_model.cpp", "relief/layers/layered_mesh.h"},
      {"relief/nonlinear/nonlinear_map.h", "relief/ordering/depth_system.h"},
      {"relief/session/build_relief.h", "relief/ordering/order_depth.h"},
      {"io/mesh/glb_encode.cpp", "relief/surface/visible_sheet.h"},
      {"relievo/session.h", "relievo/scene.h"},
      {"kernel/geometry/polygon.h", "relievo/point.h"},
      {"api/session.cpp", "relief/session/relief_session.h"},
      {"apps/cli/main.cpp", "relievo/session.h"},
      {"bindings/python/session.cpp", "relievo/session.h"},
      {"io/mesh/glb_encode.cpp", "io/files/byte_writer.h"},
      {"render/render_model.cpp", "relief/finish/model_texture.h"},
      {"solid/make_solid.cpp", "relief/surface/visible_sheet.h"},
      {"apps/cli/main.cpp", "relief/session/build_relief.h"},
      {"understanding/scene/propose_scene.cpp", "understanding/joins/propose_joins.h"},
      {"understanding/areas/find_basins.cpp", "understanding/paper/lay_on_white.h"},
      {"relief/layers/layer_parts.cpp", "relievo/scene.h"},
      {"scene/validate.cpp", "kernel/geometry/polygon.h"},
      {"io/svg/read_svg.cpp", "understanding/marks/layered_drawing.h"},
      {"io/svg/annotated_parts.cpp", "scene/part_ids.h"},
      {"apps/cli/main.cpp", "io/scene/scene_json.h"},
      {"research/rivals/entem.cpp", "render/ray_scene.h"},
      {"research/rivals/solution.cpp", "relief/ordering/order_depth.h"},
      {"research/compare/compare_command.cpp", "research/rivals/rival.h"},
      {"research/compare/compare_command.cpp", "apps/cli/outputs.h"},
      {"research/fidelity/fidelity.cpp", "relief/inflation/inflate.h"},
      {"research/tests/graft_test.cpp", "research/rivals/graft.h"},
      {"tests/io/scene_test.cpp", "io/scene/json_reader.h"},
  };
  for (const Edge& edge : edges)
    EXPECT_EQ(include_violation(edge.from, edge.to), "") << edge.from << " -> " << edge.to;
}

TEST(IncludeRules, CatchViolations) {
  const Edge edges[] = {
      {"kernel/base/workers.h", "kernel/geometry/polygon.h"},
      {"relievo/session.h", "relief/session/relief_session.h"},
      {"io/mesh/glb_encode.cpp", "api/inputs.h"},
      {"api/session.cpp", "relief/ordering/depth_forest.h"},
      {"kernel/geometry/polygon.cpp", "kernel/image/image.h"},
      {"kernel/solvers/active_set.cpp", "kernel/geometry/polygon.h"},
      {"kernel/solvers/active_set.cpp", "kernel/operators/laplacian.h"},
      {"kernel/operators/laplacian.cpp", "kernel/solvers/active_set.h"},
      {"kernel/novelty/new.cpp", "kernel/base/workers.h"},
      {"kernel/geometry/polygon.cpp", "understanding/labels/segmentation.h"},
      {"kernel/geometry/polygon.cpp", "polygon.h"},
      {"relief/layers/layer_parts.cpp", "relief/inflation/inflation.h"},
      {"relief/ordering/order_depth.cpp", "relief/inflation/inflate.h"},
      {"relief/ordering/order_depth.cpp", "relief/nonlinear/solve_nonlinear.h"},
      {"relief/nonlinear/nonlinear_map.h", "relief/layers/boundaries.h"},
      {"relief/surface/assemble_model.cpp", "relief/nonlinear/solve_nonlinear.h"},
      {"relief/ordering/order_depth.cpp", "relief/session/build_relief.h"},
      {"scene/validate.cpp", "io/scene/scene_json.h"},
      {"understanding/lines/line_map.cpp", "understanding/paper/lay_on_white.h"},
      {"understanding/scene/propose_scene.cpp", "relief/layers/layered_mesh.h"},
      {"relief/layers/layer_parts.cpp", "understanding/labels/segmentation.h"},
      {"kernel/cholesky/supernodes.cpp", "kernel/solvers/active_set.h"},
      {"scene/validate.cpp", "understanding/labels/segmentation.h"},
      {"understanding/novelty/new.cpp", "understanding/labels/segmentation.h"},
      {"relief/novelty/new.cpp", "understanding/labels/segmentation.h"},
      {"relief/session/build_relief.cpp", "relief/ordering/depth_forest.h"},
      {"relief/session/build_relief.cpp", "io/files/read_file.h"},
      {"io/svg/read_svg.cpp", "understanding/marks/make_parts.h"},
      {"io/scribbles/scribbles_json.cpp", "understanding/labels/stroke_pixels.h"},
      {"io/mesh/glb_encode.cpp", "relief/session/build_relief.h"},
      {"io/mesh/glb_encode.cpp", "relief/surface/assemble_model.h"},
      {"io/mesh/glb_encode.cpp", "render/render.h"},
      {"render/render_model.cpp", "io/image/png.h"},
      {"solid/make_solid.cpp", "relief/surface/assemble_model.h"},
      {"io/mesh/glb_encode.cpp", "solid/make_solid.h"},
      {"render/render_model.cpp", "relief/layers/layered_mesh.h"},
      {"apps/cli/main.cpp", "relief/ordering/depth_forest.h"},
      {"apps/cli/main.cpp", "tests/support/sample_models.h"},
      {"api/session.cpp", "research/rivals/rival.h"},
      {"bindings/wasm/engine.cpp", "research/rivals/rival.h"},
      {"apps/cli/main.cpp", "research/rivals/rival.h"},
      {"tests/support/seams.h", "research/rivals/rival.h"},
      {"bindings/python/model.cpp", "io/scene/scene_json.h"},
      {"relief/session/build_relief.cpp", "research/rivals/rival.h"},
      {"research/rivals/entem.cpp", "io/files/read_file.h"},
      {"research/rivals/entem.cpp", "apps/cli/outputs.h"},
      {"research/rivals/entem.cpp", "relief/layers/connect_sheets.h"},
      {"research/compare/compare_command.cpp", "relief/layers/connect_sheets.h"},
      {"tests/cli/cli_test.cpp", "apps/cli/arguments.h"},
      {"io/files/read_file.cpp", "apps/cli/arguments.h"},
  };
  for (const Edge& edge : edges)
    EXPECT_NE(include_violation(edge.from, edge.to), "") << edge.from << " -> " << edge.to;
}

TEST(HouseRules, CatchViolations) {
  const std::string fine = "#pragma once\n";
  EXPECT_EQ(text_violations("kernel/base/a.h", fine), "");
  EXPECT_NE(text_violations("kernel/base/a.h", "#include <vector>\n"), "");
  EXPECT_NE(text_violations("kernel/base/a.h", fine + "using namespace std;\n"), "");
  EXPECT_NE(text_violations("kernel/base/a.cpp", "#include <iostream>\n"), "");
  EXPECT_NE(text_violations("relief/layers/a.cpp", "#include <format>\n"), "");
  EXPECT_NE(text_violations("relief/layers/a.cpp", "auto x = std::bit_cast<int>(1.0F);\n"), "");
  EXPECT_NE(text_violations("io/scene/a.cpp", "std::normal_distribution<double> d;\n"), "");
  EXPECT_NE(text_violations("io/scene/a.cpp", std::string("// TO") + "DO: later\n"), "");
  EXPECT_NE(text_violations("io/scene/a.cpp", std::string(401, '\n')), "");
  EXPECT_EQ(text_violations("io/scene/a.cpp", std::string(400, '\n')), "");
  EXPECT_EQ(text_violations("io/scene/a.cpp", "#include <fstream>\n"), "");
}

}  // namespace
}  // namespace relievo::house
