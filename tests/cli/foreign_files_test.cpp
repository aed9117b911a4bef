/// Files of other programs and what Relievo must make of them: tests/data/foreign_files.tsv.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "api/inputs.h"
#include "cli/cli_test.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

const std::string folder = RELIEVO_SHARED_DATA "/regressions3/";

struct Expectation {
  std::string file;
  std::vector<std::string> terms;  ///< such as "parts 7"

  std::string value(const std::string& key) const {
    for (const std::string& term : terms)
      if (term.rfind(key + " ", 0) == 0) return term.substr(key.size() + 1);
    return "";
  }
  bool has(const std::string& term) const {
    return std::find(terms.begin(), terms.end(), term) != terms.end();
  }
};

void PrintTo(const Expectation& expected, std::ostream* out) { *out << expected.file; }

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
  return fields;
}

std::vector<Expectation> expectations() {
  std::vector<Expectation> all;
  std::ifstream in(RELIEVO_TEST_DATA "/foreign_files.tsv");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> fields = fields_of(line);
    all.push_back({fields[0], {fields.begin() + 1, fields.end()}});
  }
  return all;
}

/// "7" is that number, "7+" at least as many, and "" any.
void expect_count(const std::string& wanted, size_t count, const std::string& what) {
  if (wanted.empty()) return;
  const size_t number = std::stoul(wanted);
  if (wanted.back() == '+')
    EXPECT_GE(count, number) << what;
  else
    EXPECT_EQ(count, number) << what;
}

/// Counts the joins, those from behind included.
size_t connections(const Scene& scene) {
  return scene.joins.size() +
         static_cast<size_t>(std::count_if(
             scene.relations.begin(), scene.relations.end(),
             [](const Relation& relation) { return relation.kind == RelationKind::joined; }));
}

/// Shares of the parts' area without paint, and of the paint in no part, in percent.
struct PaintFit {
  double bare = 0;
  double loose = 0;
};

PaintFit fit_of(const Scene& scene, const Image8& rgba) {
  double inside = 0, bare = 0, painted = 0, loose = 0;
  const int step = std::max(1, std::max(rgba.width, rgba.height) / 500);
  for (int y = step / 2; y < rgba.height; y += step)
    for (int x = step / 2; x < rgba.width; x += step) {
      const Point2 p{(x + 0.5) * scene.width / rgba.width, (y + 0.5) * scene.height / rgba.height};
      const bool is_part = std::any_of(scene.parts.begin(), scene.parts.end(),
                                       [&](const Part& part) { return contains(part.outline, p); });
      const bool is_painted = rgba.channels < 4 || rgba.at(x, y, 3) >= 128;
      inside += is_part;
      bare += is_part && !is_painted;
      painted += is_painted;
      loose += is_painted && !is_part;
    }
  return {100 * bare / std::max(inside, 1.0), 100 * loose / std::max(painted, 1.0)};
}

class ForeignFiles : public CliTest, public ::testing::WithParamInterface<Expectation> {
 protected:
  void expect_scene() const {
    const Expectation& expected = GetParam();
    const auto input = read_input(folder + expected.file);
    ASSERT_TRUE(input) << to_string(input.error());
    const auto loaded = load_scene(*input, true);
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    const Scene& scene = loaded->scene;
    expect_count(expected.value("parts"), scene.parts.size(), "parts");
    expect_count(expected.value("joins"), connections(scene), "joins");
    if (const std::string canvas = expected.value("canvas"); !canvas.empty()) {
      EXPECT_EQ(std::to_string(std::lround(scene.width)) + "x" +
                    std::to_string(std::lround(scene.height)),
                canvas);
    }
    const PaintFit fit = fit_of(scene, loaded->drawing.rgba);
    if (const std::string bare = expected.value("bare"); !bare.empty()) {
      EXPECT_LE(fit.bare, std::stod(bare)) << "% of the parts show no paint";
    }
    if (const std::string covered = expected.value("covered"); !covered.empty()) {
      EXPECT_GE(100 - fit.loose, std::stod(covered)) << "% of the paint is in parts";
    }
  }
};

TEST_P(ForeignFiles, BecomeWhatPeopleExpect) {
  const Expectation& expected = GetParam();
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no files in " << folder;
  if (expected.has("pending")) GTEST_SKIP() << "not read as it should be yet";
  const std::string says = expected.value("says");
  const std::string frames = expected.value("frames");
  const bool is_read = says.empty() || expected.terms.size() > 1;
  const bool is_sheet = expected.file.find("sheets/") == 0;
  const Outcome outcome = is_sheet ? relievo({"sequence", folder + expected.file, "-o", "maps",
                                              "--vertices", "300", "--map-size", "64"})
                                   : relievo({"check", folder + expected.file});
  EXPECT_EQ(outcome.exit_code, is_read ? 0 : 3) << outcome.err;
  if (!says.empty()) {
    EXPECT_TRUE(std::regex_search(outcome.err, std::regex(says))) << outcome.err;
  }
  if (expected.has("quiet")) {
    EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
  }
  if (!is_read) return;
  if (!is_sheet) return expect_scene();
  const auto report = nlohmann::json::parse(read("maps/sequence.json"));
  expect_count(frames, report["frames"].size(), "frames");
}

std::string test_name(const ::testing::TestParamInfo<Expectation>& info) {
  std::string name = info.param.file;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, ForeignFiles, ::testing::ValuesIn(expectations()), test_name);

TEST(ForeignFilesTable, NamesAllFiles) {
  std::ifstream in(folder + "INDEX.tsv");
  if (!in) GTEST_SKIP() << "no files in " << folder;
  std::set<std::string> known;
  for (const Expectation& expected : expectations()) known.insert(expected.file);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) EXPECT_TRUE(known.count(fields_of(line)[0])) << line;
}

}  // namespace
}  // namespace relievo
