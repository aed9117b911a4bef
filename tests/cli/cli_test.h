#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "cli/process.h"
#include "io/support/temporary_folder.h"

namespace relievo {

/// A body and a leg that is joined to it.
inline const char* const scene_text = R"({
  "format": "relievo-scene", "version": 1, "canvas": { "width": 400, "height": 400 },
  "parts": [
    { "id": "body", "outline": [[[100,100],[300,100],[300,220],[100,220]]] },
    { "id": "leg", "outline": [[[180,160],[180,320],[220,320],[220,160]]], "c": 2 } ],
  "joins": [ { "upper": "leg", "lower": "body", "line": [[180,160],[220,160]] } ] })";

inline const char* const svg_text =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400">
  <g id="body" data-relievo="part"><rect x="100" y="100" width="200" height="120" fill="#a65"/></g>
  <g id="head" data-relievo="part"><circle cx="200" cy="90" r="60" fill="#c87"/></g>
</svg>)";

/// A folder with scene.json and drawing.svg, in which the program runs.
class CliTest : public ::testing::Test {
 protected:
  void SetUp() override {
    write("scene.json", scene_text);
    write("drawing.svg", svg_text);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) const { return content(folder_.path() / name); }
  bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_.path() / name);
  }

  Outcome relievo(const std::vector<std::string>& arguments, const std::string& input = "") const {
    return run(folder_.path(), arguments, input);
  }

  /// The program fails with `code`, says `message` on standard error alone, and leaves no file.
  void expect_failure(const std::vector<std::string>& arguments, int code,
                      const std::string& message, const std::string& input = "") const {
    const auto before = folder_.names();
    const Outcome outcome = relievo(arguments, input);
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_EQ(folder_.names(), before);
  }

  TemporaryFolder folder_;
};

}  // namespace relievo
