#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "cli/cli_test.h"

namespace relievo {
namespace {

using Json = nlohmann::json;

/// A folder with drawings of animals: one that cannot be read among them.
class Batch : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    std::filesystem::create_directories(folder_.path() / "in/more");
    write("in/cat.svg", svg_text);
    write("in/more/dog.svg", svg_text);
    write("in/broken.svg", "<svg");
    write("in/notes.txt", "no drawing");
  }

  Outcome batch(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"batch", "-o", "out", "--vertices", "300"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return relievo(arguments);
  }

  std::vector<Json> journal(const std::string& name = "out/journal.jsonl") const {
    std::vector<Json> lines;
    std::istringstream text(read(name));
    for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
    return lines;
  }

  /// Whether a file is the one that `relievo build` makes of a drawing.
  bool is_built(const std::string& file, const std::string& input,
                const std::vector<std::string>& more = {}) const {
    const std::string again = "again/" + std::filesystem::path(file).filename().string();
    std::filesystem::create_directory(folder_.path() / "again");
    std::vector<std::string> arguments = {"build", input, "-o", again, "--vertices", "300"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(relievo(arguments).exit_code, 0);
    return read(file) == read(again);
  }
};

TEST_F(Batch, BuildsWhatCanBeBuiltAndTellsWhatFailed) {
  const Outcome outcome = batch({"in"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("broken: in/broken.svg"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("3 drawings"), std::string::npos) << outcome.out;
  EXPECT_TRUE(is_built("out/cat.glb", "in/cat.svg"));
  EXPECT_TRUE(is_built("out/more/dog.glb", "in/more/dog.svg"));
  const auto lines = journal();
  ASSERT_EQ(lines.size(), 3U);
  for (const Json& line : lines) {
    const bool broken = line["name"] == "broken";
    EXPECT_EQ(line["code"], broken ? 3 : 0);
    EXPECT_EQ(line["message"].get<std::string>().empty(), !broken);
    EXPECT_EQ(line["files"].size(), broken ? 0U : 1U);
    EXPECT_EQ(line["digest"].get<std::string>().size(), 64U);
    EXPECT_GT(line["peak_mb"].get<double>(), 0);
  }
}

TEST_F(Batch, DoesNothingTwice) {
  batch({"in"});
  const std::string before = read("out/journal.jsonl");
  EXPECT_EQ(batch({"in"}).exit_code, 3);
  EXPECT_EQ(read("out/journal.jsonl"), before);
  EXPECT_EQ(batch({"in", "--retry"}).exit_code, 3);
  ASSERT_EQ(journal().size(), 4U);
  EXPECT_EQ(journal().back()["name"], "broken");
}

TEST_F(Batch, DoesAgainWhatIsMissingOrHasChanged) {
  batch({"in"});
  write("in/broken.svg", svg_text);
  EXPECT_EQ(batch({"in"}).exit_code, 0);
  ASSERT_EQ(journal().size(), 4U);
  std::filesystem::remove(folder_.path() / "out/cat.glb");
  EXPECT_EQ(batch({"in"}).exit_code, 0);
  ASSERT_EQ(journal().size(), 5U);
  EXPECT_EQ(journal().back()["name"], "cat");
  EXPECT_EQ(batch({"in", "--c", "3"}).exit_code, 0);
  EXPECT_EQ(journal().size(), 8U);
  EXPECT_TRUE(is_built("out/cat.glb", "in/cat.svg", {"--c", "3"}));
}

TEST_F(Batch, SharesAreTheWholeAndMerge) {
  for (const char* shard : {"1/2", "2/2"}) batch({"in", "--shard", shard});
  const size_t first = journal("out/journal-1-of-2.jsonl").size();
  EXPECT_EQ(first, 2U);
  EXPECT_EQ(journal("out/journal-2-of-2.jsonl").size(), 1U);
  EXPECT_TRUE(is_built("out/more/dog.glb", "in/more/dog.svg"));
  const Outcome merged = relievo({"batch", "--merge", "-o", "out", "--sheet"});
  EXPECT_EQ(merged.exit_code, 3) << merged.err;
  EXPECT_EQ(journal().size(), 3U);
  EXPECT_FALSE(exists("out/journal-1-of-2.jsonl"));
  EXPECT_NE(read("out/index.html").find("broken"), std::string::npos);
  batch({"in"});
  EXPECT_EQ(journal().size(), 3U);
}

TEST_F(Batch, ATableSaysWhatIsSpecial) {
  write("in/table.tsv",
        "input\tname\tc\tno-glue\tlean\n# comment\ncat.svg\tpets/tom\t3\tyes\t0 0.2\n"
        "more/dog.svg\t\t\t\t\n");
  EXPECT_EQ(batch({"in/table.tsv"}).exit_code, 0);
  EXPECT_TRUE(
      is_built("out/pets/tom.glb", "in/cat.svg", {"--c", "3", "--no-glue", "--lean", "0", "0.2"}));
  EXPECT_TRUE(is_built("out/dog.glb", "in/more/dog.svg"));
}

TEST_F(Batch, ATablesMistakesAreNamedBeforeAnythingIsBuilt) {
  const auto expect = [&](const std::string& table, int code, const std::string& message) {
    write("bad.tsv", table);
    expect_failure({"batch", "bad.tsv", "-o", "out"}, code, message);
  };
  expect("file\nin/cat.svg\n", 3, "bad.tsv:1: the first line must name the columns");
  expect("input\tc\nin/cat.svg\t3\t4\n", 3, "bad.tsv:2: has more cells");
  expect("input\tc\nin/cat.svg\t1\n\t2\n", 3, "bad.tsv:3: has no input");
  expect("input\tname\nin/cat.svg\t../x\n", 3, "bad.tsv:2: \"../x\" cannot be a name");
  expect("input\tdepth-of-field\nin/cat.svg\t3\n", 2, "bad.tsv:2: ");
  expect("input\tc\nin/cat.svg\tmuch\n", 2, "bad.tsv:2: ");
  expect("input\tname\nin/cat.svg\ta\nin/more/dog.svg\ta\n", 2, "would have the same outputs as");
}

TEST_F(Batch, TellsWhatItPassedOver) {
  write("in/fox.xcf", "gimp xcf v011");
  write("in/more/hen.xcf", "gimp xcf v011");
  write("in/picture", svg_text);
  write("in/fox.clip", "CSFCHUNK");
  const Outcome outcome = batch({"in/", "--quiet"});
  EXPECT_EQ(outcome.err.find("passed over"), std::string::npos) << outcome.err;
  const Outcome loud = batch({"in"});
  EXPECT_NE(loud.err.find("passed over in/fox.xcf, in/more/hen.xcf: a picture of GIMP (XCF); "
                          "export it as OpenRaster"),
            std::string::npos)
      << loud.err;
  EXPECT_NE(loud.err.find("passed over in/fox.clip: a drawing of Clip Studio"), std::string::npos)
      << loud.err;
  EXPECT_NE(loud.err.find("passed over in/picture: an SVG drawing; give it the usual ending"),
            std::string::npos)
      << loud.err;
  EXPECT_NE(loud.err.find("passed over in/notes.txt: no drawings"), std::string::npos) << loud.err;
  std::filesystem::create_directories(folder_.path() / "other");
  write("other/fox.clip", "CSFCHUNK");
  expect_failure({"batch", "other", "-o", "out"}, 3, "other/fox.clip: a drawing of Clip Studio");
}

TEST_F(Batch, DrawingsOfOneNameGetTheirExtensions) {
  std::filesystem::copy(folder_.path() / "scene.json", folder_.path() / "in/cat.json");
  EXPECT_EQ(
      relievo({"batch", "in/cat.svg", "in/cat.json", "-o", "out", "--vertices", "300"}).exit_code,
      0);
  EXPECT_TRUE(is_built("out/cat-svg.glb", "in/cat.svg"));
  EXPECT_TRUE(is_built("out/cat-json.glb", "in/cat.json"));
}

TEST_F(Batch, MakesMapsPicturesAndAContactSheet) {
  const Outcome outcome = batch({"in/cat.svg", "--make", "stl,normal,depth,part,overlay,report",
                                 "--map-size", "64", "--sheet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"cat.stl", "cat-normal.png", "cat-depth.png", "cat-part.png",
                           "cat-overlay.png", "cat-report.json", "sheet/cat.png", "index.html"})
    EXPECT_TRUE(exists(std::string("out/") + name)) << name;
  EXPECT_FALSE(exists("out/cat.glb"));
  EXPECT_NE(read("out/index.html").find("src=\"sheet/cat.png\""), std::string::npos);
}

TEST_F(Batch, GoesOnAfterItWasKilled) {
  for (int k = 0; k < 30; ++k) write("in/n" + std::to_string(k) + ".svg", svg_text);
  std::filesystem::remove(folder_.path() / "in/broken.svg");
  const std::vector<std::string> arguments = {"batch", "in", "-o", "out", "--vertices", "300"};
  for (int kills = 0; kills < 3; ++kills) {
    Process process(folder_.path(), arguments);
    const std::string before = exists("out/journal.jsonl") ? read("out/journal.jsonl") : "";
    while (!exists("out/journal.jsonl") || read("out/journal.jsonl").size() <= before.size())
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    process.send(SIGKILL);
    process.wait();
    // A line that was being written.
    write("out/journal.jsonl", read("out/journal.jsonl") + "{\"name\":\"n");
  }
  EXPECT_EQ(relievo(arguments).exit_code, 0);
  std::vector<std::string> names;
  for (const Json& line : journal()) names.push_back(line["name"]);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names.size(), 32U);
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_TRUE(is_built("out/n29.glb", "in/n29.svg"));
}

TEST_F(Batch, StopsWhenAskedToAndLeavesNoFailures) {
  for (int k = 0; k < 30; ++k) write("in/n" + std::to_string(k) + ".svg", svg_text);
  Process process(folder_.path(), {"batch", "in", "-o", "out", "--vertices", "20000"});
  while (!exists("out/journal.jsonl")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  process.send(SIGINT);
  EXPECT_EQ(process.wait().exit_code, 130);
  for (const Json& line : journal())
    EXPECT_TRUE(line["code"] == 0 || line["name"] == "broken") << line;
}

TEST_F(Batch, OneAtATimeWritesAJournal) {
  for (int k = 0; k < 30; ++k) write("in/n" + std::to_string(k) + ".svg", svg_text);
  Process process(folder_.path(), {"batch", "in", "-o", "out", "--vertices", "20000"});
  while (!exists("out/journal.jsonl")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const Outcome second = batch({"in"});
  EXPECT_EQ(second.exit_code, 6);
  EXPECT_NE(second.err.find("another batch is writing it"), std::string::npos) << second.err;
  process.send(SIGTERM);
  process.wait();
}

TEST_F(Batch, AJournalThatIsNoneIsRefused) {
  std::filesystem::create_directories(folder_.path() / "out");
  write("out/journal.jsonl", "{\"name\":1}\n");
  const Outcome outcome = batch({"in"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("out/journal.jsonl:1: is not a journal entry"), std::string::npos)
      << outcome.err;
}

TEST_F(Batch, RefusesWhatMakesNoSense) {
  expect_failure({"batch", "-o", "out"}, 2, "no drawings");
  expect_failure({"batch", "in", "--merge", "-o", "out"}, 2, "--merge takes no drawings");
  expect_failure({"batch", "in", "--shard", "3/2", "-o", "out"}, 2, "--shard 3/2");
  expect_failure({"batch", "in", "--make", "3mf", "--visible", "all", "-o", "out"}, 2, "--visible");
  expect_failure({"batch", "--merge", "-o", "nowhere"}, 6, "contains no journals");
}

}  // namespace
}  // namespace relievo
