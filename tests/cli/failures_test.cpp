#include "cli/cli_test.h"

namespace relievo {
namespace {

using Failures = CliTest;
const std::vector<std::string> build = {"build", "scene.json", "-o", "out.glb"};

std::vector<std::string> with(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_F(Failures, AReportThatNobodyGetsLeavesNoModel) {
  const Outcome outcome =
      run_into("/dev/full", folder_.path(), {"build", "scene.json", "-o", "out.glb", "--json"});
  EXPECT_EQ(outcome.exit_code, 6) << outcome.err;
  EXPECT_FALSE(exists("out.glb"));
}

TEST_F(Failures, UsageIsTwo) {
  expect_failure({}, 2, "build, batch, check, render, segment or sequence");
  expect_failure({"paint"}, 2, "paint");
  expect_failure({"build", "scene.json"}, 2, "nothing to write");
  expect_failure({"build", "-o", "out.glb"}, 2, "INPUT");
  expect_failure({"build", "scene.json", "-o", "out.3ds"}, 2, ".glb");
  expect_failure({"build", "scene.json", "-o", "out"}, 2, ".glb");
  expect_failure(with(build, {"--normal-map", "map.jpg"}), 2, ".png");
  expect_failure(with(build, {"--report", "report.txt"}), 2, ".json");
  expect_failure(with(build, {"--vertices", "many"}), 2, "vertices");
  expect_failure(with(build, {"--vertices", "-5"}), 2, "vertices");
  expect_failure(with(build, {"--vertices", "1000", "--edge", "2"}), 2, "edge");
  expect_failure(with(build, {"--size", "0"}), 2, "size");
  expect_failure(with(build, {"--rho", "nan"}), 2, "rho");
  expect_failure(with(build, {"--alpha0", "2"}), 2, "alpha0");
  expect_failure(with(build, {"--c", "0"}), 2, "c");
  expect_failure(with(build, {"--lean", "0.5"}), 2, "lean");
  expect_failure(with(build, {"--lean", "0.5", "2.5"}), 2, "lean");
  for (const char* cue :
       {"body", "body:dent:1,2,3,4:5", "body:slope:1,2,3:5", "body:slope:1,2,3,x:5",
        "body:slope:1,2,3,4:5,6", "body:bulge:1,2,3,4:0", ":slope:1,2,3,4:5"})
    expect_failure(with(build, {"--cue", cue}), 2, cue);
  expect_failure(with(build, {"--cue", "nose:slope:1,2,3,4:5"}), 2, "nose");
  expect_failure(with(build, {"--preset", "paper", "--rho", "0.5"}), 2, "rho");
  for (const char* value : {"--c", "--alpha0", "--flat"})
    expect_failure(with(build, {"--preset", "paper", value, "0.5"}), 2, value);
  expect_failure(with(build, {"--preset", "newspaper"}), 2, "preset");
  expect_failure(with(build, {"--method", "magic"}), 2, "method");
  expect_failure(with(build, {"--lambda-bnd", "0"}), 2, "lambda-bnd");
  for (const char* value : {"0", "-1", "1e4", "nan"})
    expect_failure(with(build, {"--lambda-shift", value}), 2, "lambda-shift");
  expect_failure({"render", "scene.json", "-o", "a.png", "--lambda-shift", "0"}, 2, "lambda-shift");
  expect_failure(with(build, {"--visible", "some"}), 2, "visible");
  expect_failure(with(build, {"--keep-hidden", "--visible", "orbit"}), 2, "visible");
  expect_failure(with(build, {"--normal-y", "up"}), 2, "normal-y");
  expect_failure(with(build, {"--timeout", "0"}), 2, "timeout");
  expect_failure(with(build, {"--no-such-option"}), 2, "no-such-option");
  for (const char* option : {"--profile", "--visible"})
    expect_failure({"build", "scene.json", "-o", "out.3mf", option, "relief"}, 2, option);
  expect_failure(with(build, {"--filaments", "17"}), 2, "filaments");
  expect_failure(with(build, {"--profile", "hollow"}), 2, "hollow");
  expect_failure(with(build, {"--base", "round"}), 2, "profile");
  const std::vector<std::string> solid = with(build, {"--profile", "solid"});
  expect_failure(with(solid, {"--base", "square"}), 2, "base");
  expect_failure(with(solid, {"--thickness", "0"}), 2, "thickness");
  expect_failure(with(solid, {"--size", "3", "--thickness", "3"}), 2, "size");
  expect_failure(with(solid, {"--hole", "4"}), 2, "base");
  expect_failure(with(solid, {"--base", "outline", "--hole", "90"}), 2, "hole");
  expect_failure({"render", "scene.json"}, 2, "output");
  expect_failure({"render", "scene.json", "-o", "a.png", "--view", "back"}, 2, "view");
}

TEST_F(Failures, BasesAndBacksBelongToTheirProfiles) {
  const std::vector<std::string> figure = with(build, {"--profile", "figure"});
  expect_failure(with(figure, {"--base", "outline"}), 2, "base");
  expect_failure(with(figure, {"--back", "some"}), 2, "back");
  expect_failure(with(build, {"--profile", "solid", "--back", "parts"}), 2, "--profile figure");
  expect_failure(with(figure, {"--height", "5", "--height-mode", "some"}), 2, "height-mode");
}

TEST_F(Failures, OutputsNeverCollide) {
  expect_failure(with(build, {"-o", "./out.glb"}), 2, "two outputs");
  expect_failure({"build", "scene.json", "-o", "a.obj", "--preview", "a.png"}, 2, "two outputs");
  const std::string before = read("scene.json");
  expect_failure({"build", "scene.json", "--report", "scene.json"}, 2, "never overwritten");
  std::filesystem::create_hard_link(folder_.path() / "scene.json", folder_.path() / "link.json");
  expect_failure({"build", "scene.json", "--report", "link.json"}, 2, "never overwritten");
  EXPECT_EQ(read("scene.json"), before);
}

TEST_F(Failures, BadInputIsThree) {
  write("broken.json", "{");
  expect_failure({"build", "broken.json", "-o", "out.glb"}, 3, "broken.json: line 1");
  write("empty.json", "");
  expect_failure({"build", "empty.json", "-o", "out.glb"}, 3, "is empty");
  write("text.txt", "hello");
  expect_failure({"build", "text.txt", "-o", "out.glb"}, 3, "text, not a drawing");
  write("flat.png", "\x89PNG\r\n\x1a\n");
  expect_failure({"build", "flat.png", "-o", "out.glb"}, 3, "flat.png");
  write("page.svg", "<html></html>");
  expect_failure({"build", "page.svg", "-o", "out.glb"}, 3, "page.svg");
  write("model.glb", "glTF....");
  expect_failure({"build", "model.glb", "-o", "out.glb"}, 3, "relievo render");
  expect_failure({"render", "model.glb", "-o", "out.png"}, 3, "model.glb");
  std::string scene = scene_text;
  scene.replace(scene.find("[180,320]"), 9, "[180,1e7]");
  write("far.json", scene);
  expect_failure({"check", "far.json"}, 3, "far.json: parts[1].outline[0][1]");
}

TEST_F(Failures, ContradictionsAreFour) {
  std::string scene = scene_text;
  scene.replace(scene.rfind('}'), 1, R"(, "relations": [
    { "upper": "leg", "lower": "body", "relation": "below", "range": [[220,180],[220,210]] },
    { "upper": "leg", "lower": "body", "relation": "above", "range": [[220,190],[220,230]] } ] })");
  write("twisted.json", scene);
  expect_failure({"build", "twisted.json", "-o", "out.glb"}, 4, "relations[0]");
  const Outcome check = relievo({"check", "twisted.json"});
  EXPECT_EQ(check.exit_code, 4);
  EXPECT_NE(check.err.find("relations[1]"), std::string::npos) << check.err;
}

TEST_F(Failures, HostileNamesDoNotSteerTheTerminal) {
  std::string scene = scene_text;
  scene.replace(scene.find("\"joins\""), 7, "\"\\u001b[31m\"");
  write("colour.json", scene);
  const Outcome outcome = relievo({"check", "colour.json"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos);
}

TEST_F(Failures, DrawingsStayInTheirFolder) {
  const auto outside = [&](const std::string& drawing) {
    std::string scene = scene_text;
    scene.insert(scene.find("\"parts\""), "\"drawing\": \"" + drawing + "\", ");
    write("drawn.json", scene);
  };
  outside("../secret.png");
  expect_failure({"build", "drawn.json", "-o", "out.glb"}, 3, "drawn.json: drawing");
  outside("missing.png");
  expect_failure({"build", "drawn.json", "-o", "out.glb"}, 6, "missing.png");
  std::filesystem::create_symlink("/etc/hostname", folder_.path() / "link.png");
  outside("link.png");
  expect_failure({"build", "drawn.json", "-o", "out.glb"}, 3, "leads out");
}

TEST_F(Failures, LimitsAreFive) {
  expect_failure(with(build, {"--vertices", "50000", "--max-vertices", "200"}), 5, "");
  expect_failure(with(build, {"--vertices", "3000000", "--timeout", "0.3"}), 5, "--timeout 0.3 s");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "[";
  write("deep.json", deep);
  expect_failure({"check", "deep.json"}, 5, "nested deeper");
}

TEST_F(Failures, FilesAreSix) {
  expect_failure({"build", "missing.svg", "-o", "out.glb"}, 6, "missing.svg");
  expect_failure({"build", "scene.json", "-o", "nowhere/out.glb"}, 6, "folder does not exist");
  expect_failure({"build", "missing.svg", "-o", "nowhere/out.glb"}, 6, "nowhere");
  std::filesystem::create_directory(folder_.path() / "folder.glb");
  expect_failure({"build", "scene.json", "-o", "folder.glb"}, 6, "folder");
}

TEST_F(Failures, KeepEarlierFilesWhenOneCannotBeWritten) {
  write("old.glb", "old");
  std::filesystem::create_directory(folder_.path() / "report.json");
  expect_failure({"build", "scene.json", "-o", "old.glb", "--report", "report.json"}, 6, "report");
  EXPECT_EQ(read("old.glb"), "old");
}

}  // namespace
}  // namespace relievo
