#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "io/image/decode_image.h"
#include "io/mesh/glb_decode.h"

namespace relievo {
namespace {

using Build = CliTest;
using Json = nlohmann::json;

const std::vector<std::string> small = {"--vertices", "3000"};

std::vector<std::string> with_small(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), small.begin(), small.end());
  return arguments;
}

TEST_F(Build, ThreadsChangeNoByte) {
  const std::vector<std::string> names = {"m.glb", "m.stl", "normal.png", "depth.png", "parts.png"};
  std::vector<std::string> expected;
  for (const char* threads : {"1", "2", "2", "3"}) {
    const Outcome outcome =
        relievo(with_small({"build", "drawing.svg", "-o", "m.glb", "-o", "m.stl", "--normal-map",
                            "normal.png", "--depth-map", "depth.png", "--part-map", "parts.png",
                            "--map-size", "300", "--threads", threads}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    std::vector<std::string> files;
    for (const std::string& name : names) files.push_back(read(name));
    if (expected.empty()) expected = files;
    for (size_t i = 0; i < names.size(); ++i) EXPECT_TRUE(files[i] == expected[i]) << names[i];
  }
}

TEST_F(Build, WritesEveryKindOfFileAndNothingElse) {
  const Outcome outcome = relievo(with_small({"build",
                                              "drawing.svg",
                                              "-o",
                                              "m.glb",
                                              "-o",
                                              "m.obj",
                                              "-o",
                                              "m.ply",
                                              "-o",
                                              "m.stl",
                                              "--normal-map",
                                              "normal.png",
                                              "--depth-map",
                                              "depth.png",
                                              "--part-map",
                                              "parts.png",
                                              "--preview",
                                              "preview.png",
                                              "--report",
                                              "report.json",
                                              "--map-size",
                                              "300",
                                              "--preview-size",
                                              "90"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(folder_.names(),
            (std::vector<std::string>{"depth.png", "drawing.svg", "m.glb", "m.mtl", "m.obj",
                                      "m.ply", "m.png", "m.stl", "normal.png", "parts.png",
                                      "preview.png", "report.json", "scene.json"}));
  for (const char* name : {"m.glb", "m.obj", "m.mtl", "m.png", "m.ply", "m.stl", "normal.png",
                           "depth.png", "parts.png", "preview.png", "report.json"})
    EXPECT_NE(outcome.out.find(std::string(name) + "\n"), std::string::npos) << name;
  for (const char* name : {"normal.png", "depth.png", "parts.png"}) {
    const auto map = decode_image(to_bytes(read(name)));
    ASSERT_TRUE(map) << name;
    EXPECT_EQ(std::max(map->width, map->height), 300);
  }
  const auto preview = decode_image(to_bytes(read("preview.png")));
  ASSERT_TRUE(preview);
  EXPECT_EQ(std::max(preview->width, preview->height), 90);
  const auto drawn = decode_glb(to_bytes(read("m.glb")));
  ASSERT_TRUE(drawn) << to_string(drawn.error());
  EXPECT_GT(drawn->model.triangles.size(), 3000U);
  EXPECT_FALSE(drawn->drawing.rgba.empty());
  ASSERT_EQ(drawn->model.parts.size(), 2U);
  EXPECT_EQ(drawn->model.parts[1].id, "head");
}

/// What was guessed must not stand in the way of a coarse model.
TEST_F(Build, LeavesOutGuessedJoinsThatDoNotFitTheMesh) {
  const std::filesystem::path drawing =
      std::string(RELIEVO_SHARED_DATA) + "/truth/knight_sit_floor_pose_yaw80/drawing.png";
  if (!std::filesystem::exists(drawing)) GTEST_SKIP() << "there are no shared drawings";
  ASSERT_EQ(relievo({"segment", drawing.string(), "-o", "p.relievo"}).exit_code, 0);
  for (const std::string& input : {drawing.string(), std::string("p.relievo")}) {
    const Outcome outcome = relievo({"build", input, "-o", "m.glb", "--vertices", "600"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("is left out"), std::string::npos) << outcome.err;
  }
}

TEST_F(Build, SameInputGivesSameBytes) {
  const auto files = {"m.glb", "m.obj", "m.ply", "m.stl", "n.png", "d.png", "p.png", "v.png"};
  std::vector<std::string> first;
  for (int repetition = 0; repetition < 2; ++repetition) {
    const Outcome outcome = relievo(
        with_small({"build",          "scene.json", "-o",          "m.glb",      "-o",
                    "m.obj",          "-o",         "m.ply",       "-o",         "m.stl",
                    "--normal-map",   "n.png",      "--depth-map", "d.png",      "--part-map",
                    "p.png",          "--preview",  "v.png",       "--map-size", "256",
                    "--preview-size", "80"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    std::vector<std::string> contents;
    for (const char* file : files) contents.push_back(read(file));
    if (repetition == 0) first = contents;
    EXPECT_TRUE(contents == first);
  }
}

TEST_F(Build, ReportsWhatItDid) {
  const Outcome outcome = relievo(with_small({"build", "scene.json", "--json", "-o", "m.glb"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["input"], "scene.json");
  EXPECT_EQ(report["method"], "approximate");
  EXPECT_TRUE(report["version"].is_string());
  EXPECT_GT(report["vertices"], 2000);
  EXPECT_LT(report["vertices"], 4500);
  ASSERT_EQ(report["parts"].size(), 2U);
  EXPECT_EQ(report["parts"][0]["id"], "body");
  EXPECT_EQ(report["parts"][0]["c"], 4);
  EXPECT_EQ(report["parts"][1]["c"], 2);
  EXPECT_EQ(report["parts"][1]["d"], 1);
  EXPECT_EQ(report["faces"],
            report["parts"][0]["faces"].get<int>() + report["parts"][1]["faces"].get<int>());
  EXPECT_GT(report["constraints"]["equalities"], 0);
  const Outcome loose = relievo(with_small({"build", "scene.json", "--json", "--no-glue"}));
  EXPECT_GT(Json::parse(loose.out)["constraints"]["inequalities"], 0);
  EXPECT_TRUE(report["constraints"]["active"].is_number_integer());
  EXPECT_EQ(report["solver"]["status"], "solved");
  EXPECT_GT(report["solver"]["iterations"], 0);
  for (const char* residual : {"stationarity", "primal", "dual", "complementarity"})
    EXPECT_LE(report["solver"][residual].get<double>(), 1e-10) << residual;
  EXPECT_TRUE(report["solver"]["energy"].is_number());
  EXPECT_LE(report["max_violation"].get<double>(), 1e-9);
  EXPECT_TRUE(report["overlap_violation"]["samples"].is_number_integer());
  EXPECT_TRUE(report["overlap_violation"]["worst"].is_number());
  double sum = 0;
  for (const char* stage :
       {"read", "mesh", "assemble", "analyse", "inflate", "order", "nonlinear", "export"}) {
    EXPECT_GE(report["timings_ms"][stage].get<double>(), 0) << stage;
    sum += report["timings_ms"][stage].get<double>();
  }
  for (const char* stage : {"mesh", "assemble", "analyse", "inflate", "order"})
    EXPECT_GT(report["timings_ms"][stage].get<double>(), 0) << stage;
  EXPECT_LE(sum, 1.05 * report["timings_ms"]["total"].get<double>() + 1);
  EXPECT_TRUE(report["warnings"].is_array());
}

TEST_F(Build, NonlinearMethodRecordsItsSteps) {
  const Outcome outcome =
      relievo(with_small({"build", "scene.json", "--json", "--method", "nonlinear", "--lambda-bnd",
                          "100", "--lambda-shift", "2"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["method"], "nonlinear");
  EXPECT_GT(report["timings_ms"]["nonlinear"], 0);
  EXPECT_EQ(report["timings_ms"]["order"], 0);
  const Json& nonlinear = report["nonlinear"];
  EXPECT_EQ(nonlinear["status"], "solved");
  EXPECT_EQ(nonlinear["lambda_bnd"], 100);
  EXPECT_EQ(nonlinear["lambda_shift"], 2);
  EXPECT_EQ(nonlinear["iterations"], nonlinear["steps"].size());
  EXPECT_GE(nonlinear["steps"].size(), 3U);
  EXPECT_NEAR(nonlinear["energy"]["total"].get<double>(),
              nonlinear["steps"].back()["energy"]["total"].get<double>(), 1e-6);
}

TEST_F(Build, ReportInAFileIsTheSameAsOnStandardOutput) {
  const Outcome outcome =
      relievo(with_small({"build", "scene.json", "--json", "--report", "report.json"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read("report.json"), outcome.out);
}

TEST_F(Build, QuietSaysNothing) {
  const Outcome outcome = relievo(with_small({"build", "scene.json", "-o", "m.glb", "--quiet"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(exists("m.glb"));
}

TEST_F(Build, ShowsNoProgressWithoutATerminal) {
  const Outcome outcome = relievo(with_small({"build", "scene.json", "-o", "m.glb"}));
  EXPECT_EQ(outcome.out, "m.glb\n");
  EXPECT_EQ(outcome.err.find('\r'), std::string::npos);
}

TEST_F(Build, ReadsStandardInput) {
  for (const char* text : {scene_text, svg_text}) {
    const Outcome outcome = relievo(with_small({"build", "-", "--json"}), text);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["input"], "-");
  }
}

TEST_F(Build, SimplifiesModelsAndWritesLevels) {
  const auto triangles = [&](const std::string& name) {
    const std::string bytes = read(name);
    const auto glb = decode_glb(Bytes(bytes.begin(), bytes.end()));
    EXPECT_TRUE(glb.ok()) << name;
    return glb.ok() ? glb->model.triangles.size() : 0;
  };
  const std::vector<std::string> build = {"build", "scene.json", "-o", "m.glb", "-o", "m.obj"};
  const auto with = [&build](std::vector<std::string> more) {
    more.insert(more.begin(), build.begin(), build.end());
    return more;
  };
  const Outcome outcome = relievo(with({"--triangles", "8000", "--lods", "3", "--json"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["model"]["faces"], triangles("m.glb"));
  size_t most = 8000;
  for (const char* name : {"m.glb", "m-lod1.glb", "m-lod2.glb"}) {
    EXPECT_LE(triangles(name), most) << name;
    EXPECT_GT(triangles(name), most * 8 / 10) << name;
    most /= 2;
  }
  for (const char* name : {"m.obj", "m-lod1.obj", "m-lod2.obj", "m-lod2.mtl"})
    EXPECT_TRUE(exists(name)) << name;
  // What is asked for and cannot be done is said.
  const Outcome few = relievo(with({"--triangles", "4"}));
  EXPECT_NE(few.err.find("the model keeps"), std::string::npos) << few.err;
  ASSERT_EQ(relievo(with({"--one-mesh", "-q"})).exit_code, 0);
  const std::string bytes = read("m.glb");
  EXPECT_EQ(decode_glb(Bytes(bytes.begin(), bytes.end()))->model.parts.size(), 1U);
  expect_failure({"build", "scene.json", "-o", "s.stl", "--triangles", "99"}, 2, "--vertices");
}

TEST_F(Build, LevelsOfDetailHaveSmallerTextures) {
  write("drawing.svg", svg_text);
  const auto side = [&](const std::string& name) {
    const std::string bytes = read(name);
    const auto glb = decode_glb(Bytes(bytes.begin(), bytes.end()));
    EXPECT_TRUE(glb.ok()) << name;
    return glb.ok() ? std::max(glb->drawing.rgba.width, glb->drawing.rgba.height) : 0;
  };
  ASSERT_EQ(relievo(with_small({"build", "drawing.svg", "-o", "m.glb", "--lods", "2"})).exit_code,
            0);
  const int own = side("m.glb");
  EXPECT_EQ(side("m-lod1.glb"), own / 2);
  ASSERT_EQ(relievo(with_small({"build", "drawing.svg", "-o", "m.glb", "--lods", "2",
                                "--texture-size", "128"}))
                .exit_code,
            0);
  EXPECT_LE(side("m.glb"), 128);
  EXPECT_GT(side("m.glb"), 64);
  EXPECT_LE(side("m-lod1.glb"), 64);
}

TEST_F(Build, SizesMayHaveUnits) {
  const auto glb = [&](const char* size) {
    EXPECT_EQ(
        relievo(with_small({"build", "scene.json", "-q", "-o", "m.glb", "--size", size})).exit_code,
        0);
    return read("m.glb");
  };
  const std::string metres = glb("1800");
  for (const char* size : {"1.8m", "180cm", "1800mm"}) EXPECT_TRUE(glb(size) == metres) << size;
  EXPECT_TRUE(glb("1in") == glb("25.4"));
  for (const char* size : {"1.8 km", "m", "0", "nan", "2000m"})
    expect_failure({"build", "scene.json", "-o", "m.glb", "--size", size}, 2, "--size");
}

TEST_F(Build, OptionsReachTheirStages) {
  const auto glb = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments = {"build", "scene.json", "-o", "m.glb", "-q"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(relievo(arguments).exit_code, 0);
    return read("m.glb");
  };
  const std::string plain = glb({"--vertices", "3000"});
  EXPECT_EQ(glb({"--vertices", "3000", "--method", "approximate", "--profile", "relief",
                 "--visible", "orbit", "--preset", "default", "--size", "100"}),
            plain);
  EXPECT_EQ(glb({"--vertices", "3000", "--keep-hidden"}),
            glb({"--vertices", "3000", "--visible", "all"}));
  for (const std::vector<std::string>& change : std::vector<std::vector<std::string>>{
           {"--vertices", "6000"},
           {"--edge", "9"},
           {"--vertices", "3000", "--c", "1"},
           {"--vertices", "3000", "--lean", "-0.2", "0"},
           {"--vertices", "3000", "--cue", "body:slope:110,120,290,200:20"},
           {"--vertices", "3000", "--size", "50"},
           {"--vertices", "3000", "--rho", "0.5"},
           {"--vertices", "3000", "--alpha0", "0.8"},
           {"--vertices", "3000", "--preset", "paper"},
           {"--vertices", "3000", "--no-glue"},
           {"--vertices", "3000", "--visible", "relief"}})
    EXPECT_FALSE(glb(change) == plain) << change.back();
}

TEST_F(Build, ShowsWholePartsAndPrintsASolid) {
  ASSERT_EQ(relievo(with_small({"build", "scene.json", "-o", "m.glb", "-o", "m.stl"})).exit_code,
            0);
  const std::string glb = read("m.glb");
  const std::string stl = read("m.stl");
  const auto alone = [&](const std::string& name, const char* option, const char* value) {
    EXPECT_EQ(relievo(with_small({"build", "scene.json", "-o", name, option, value})).exit_code, 0);
    return read(name);
  };
  EXPECT_TRUE(glb == alone("m.glb", "--visible", "orbit"));
  EXPECT_TRUE(stl == alone("a.stl", "--profile", "solid"));
  const std::string sheet = alone("b.stl", "--profile", "relief");
  EXPECT_FALSE(stl == sheet);
  EXPECT_TRUE(sheet == alone("c.stl", "--visible", "orbit"));
}

TEST_F(Build, PaperPresetIsThePapersValuesForAllParts) {
  const auto depth = [&](const std::string& scene, const std::string& preset) {
    write("other.json", scene);
    std::vector<std::string> arguments = with_small(
        {"build", "other.json", "--preset", preset, "--depth-map", "d.png", "--map-size", "200"});
    if (preset == "default")
      arguments = with_small({"build", "other.json", "--ramps", "robin", "--alpha0", "0.1",
                              "--limbs", "back", "--depth-map", "d.png", "--map-size", "200"});
    const Outcome outcome = relievo(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read("d.png");
  };
  std::string own = scene_text;
  ASSERT_NE(own.find("\"c\": 2"), std::string::npos);
  std::string papers = own;
  own.replace(own.find("\"c\": 2"), 6, R"("c": 2, "d": 1.5, "flat": 0.7, "lean": [0.2, 0.1])");
  papers.replace(papers.find("\"c\": 2"), 6, "\"c\": 4");
  EXPECT_EQ(depth(own, "paper"), depth(papers, "default"));
  EXPECT_NE(depth(own, "default"), depth(papers, "default"));
  own.replace(own.find("\"d\": 1.5"), 8, "\"d\": -2");
  papers.replace(papers.find("\"c\": 4"), 6, R"("c": 4, "d": -1)");
  EXPECT_EQ(depth(own, "paper"), depth(papers, "default"));
}

TEST_F(Build, NormalsPointDownOnRequest) {
  const auto green = [&](const char* sign) {
    EXPECT_EQ(relievo(with_small({"build", "scene.json", "--normal-map", "n.png", "--normal-y",
                                  sign, "--map-size", "100", "-q"}))
                  .exit_code,
              0);
    const auto map = decode_image(to_bytes(read("n.png")));
    EXPECT_TRUE(map);
    return map->at(50, 28, 1);
  };
  EXPECT_GT(green("+"), 140);
  EXPECT_LT(green("-"), 116);
}

TEST_F(Build, TextureComesFromTheDrawingOfTheScene) {
  std::string scene = scene_text;
  scene.insert(scene.find("\"parts\""), "\"drawing\": \"drawing.svg\", ");
  write("drawn.json", scene);
  ASSERT_EQ(relievo(with_small({"build", "drawn.json", "-o", "m.glb"})).exit_code, 0);
  const auto drawn = decode_glb(to_bytes(read("m.glb")));
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn->drawing.rgba.width, 2048);
  expect_failure({"build", "drawn.json", "--preview", "drawing.svg.png", "--report", "drawn.json"},
                 2, "never overwritten");
}

TEST_F(Build, ShowsTheFieldsAndTheConvergenceOfTheNonlinearMethod) {
  const Outcome outcome = relievo(
      with_small({"build", "scene.json", "--method", "nonlinear", "--convergence", "strip.png",
                  "--field", "shift", "--depth-map", "shift.png", "--map-size", "100"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto strip = decode_image(to_bytes(read("strip.png")));
  ASSERT_TRUE(strip);
  EXPECT_EQ(strip->width % 480, 0);
  EXPECT_GE(strip->width, 3 * 480);
  EXPECT_EQ(strip->height, 480);
  ASSERT_EQ(relievo(with_small({"build", "scene.json", "--method", "nonlinear", "--depth-map",
                                "relief.png", "--map-size", "100"}))
                .exit_code,
            0);
  EXPECT_NE(read("shift.png"), read("relief.png"));
  expect_failure({"build", "scene.json", "--convergence", "strip2.png"}, 2, "nonlinear");
}

}  // namespace
}  // namespace relievo
