#include "cli/cli_test.h"
#include "relievo/export.h"
#include "relievo/read.h"
#include "relievo/session.h"

namespace relievo {
namespace {

/// Compares files of the library with those of the program. The drawing is a circle with a broad
/// black stroke and nothing hidden: its rims are narrowed in the finished model.
class Library : public CliTest {
 protected:
  void SetUp() override {
    auto drawn = read_drawing(std::filesystem::path(RELIEVO_TEST_DATA) / "inked_circle.svg");
    ASSERT_TRUE(drawn.ok());
    drawn_ = std::move(*drawn);
    BuildOptions options;
    options.vertices = 4000;
    ASSERT_TRUE(session_.build(drawn_.scene, options).ok());
  }

  std::string file_of(const Model& model, const Drawing& drawing, const std::string& name,
                      const ExportOptions& options = {}) const {
    const auto files = export_model(model, drawing, name, options);
    EXPECT_TRUE(files.ok());
    return files.ok() ? std::string(files->front().bytes.begin(), files->front().bytes.end()) : "";
  }

  std::string built(const std::string& name, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"build", RELIEVO_TEST_DATA "/inked_circle.svg", "-q",
                                     "--vertices", "4000", "-o", name});
    EXPECT_EQ(relievo(options).exit_code, 0);
    return read(name);
  }

  DrawnScene drawn_;
  Session session_;
};

TEST_F(Library, FinishesModelsAsTheProgramDoes) {
  for (const std::string name : {"a.glb", "a.ply", "a.obj", "a.usdz", "a.html"}) {
    const auto model = session_.model();
    ASSERT_TRUE(model.ok());
    EXPECT_TRUE(file_of(*model, drawn_.drawing, name) == built(name)) << name;
  }
  for (const char* visible : {"orbit", "relief", "all"}) {
    const auto visibility = visible == std::string("orbit")    ? Visibility::orbit
                            : visible == std::string("relief") ? Visibility::relief
                                                               : Visibility::all;
    const auto model = session_.model({visibility});
    ASSERT_TRUE(model.ok());
    EXPECT_TRUE(file_of(*model, drawn_.drawing, "b.glb") == built("b.glb", {"--visible", visible}))
        << visible;
  }
}

TEST_F(Library, DrawsLinesOfUnfinishedModelsOnly) {
  auto model = session_.model();
  ASSERT_TRUE(model.ok());
  const std::string unlit = "KHR_materials_unlit";
  EXPECT_NE(file_of(*model, drawn_.drawing, "a.glb").find(unlit), std::string::npos);
  EXPECT_EQ(file_of(*model, {}, "a.glb").find(unlit), std::string::npos);
  model->unfinished = false;
  EXPECT_EQ(file_of(*model, drawn_.drawing, "a.glb").find(unlit), std::string::npos);
}

TEST_F(Library, MakesSolidsAsTheProgramDoes) {
  const auto solid = session_.solid({}, drawn_.drawing);
  ASSERT_TRUE(solid.ok());
  for (const std::string name : {"a.stl", "a.3mf"})
    EXPECT_TRUE(file_of(solid->model, solid->drawing, name) == built(name)) << name;
}

}  // namespace
}  // namespace relievo
