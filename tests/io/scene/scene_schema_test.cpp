#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "io/scene/sample_scene.h"
#include "io/scene/scene_json.h"

namespace relievo {
namespace {

class SceneSchema : public testing::Test {
 protected:
  void SetUp() override {
    std::ifstream in(RELIEVO_SCENE_SCHEMA);
    const auto json = nlohmann::json::parse(in);
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(json), schema_);
  }

  bool accepts(const std::string& text) const {
    const auto json = nlohmann::json::parse(text);
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(json), nullptr);
  }

  valijson::Schema schema_;
};

TEST_F(SceneSchema, AcceptsWhatIsWritten) {
  EXPECT_TRUE(accepts(sample_scene()));
  const auto scene = read_scene(sample_scene());
  ASSERT_TRUE(scene);
  EXPECT_TRUE(accepts(*write_scene(*scene)));
}

TEST_F(SceneSchema, AgreesWithTheReader) {
  const std::pair<const char*, const char*> changes[] = {
      {"\"version\": 1", "\"version\": 2"},
      {"relievo-scene", "other"},
      {"\"drawing\":", "\"picture\":"},
      {"\"height\": 100.5", "\"height\": -1"},
      {"\"height\": 100.5", "\"height\": 1000000"},
      {"\"height\": 100.5", "\"height\": 1000001"},
      {"art/figure.png", "../figure.png"},
      {"art/figure.png", "/figure.png"},
      {"art/figure.png", "art/.."},
      {"art/figure.png", "art\\\\figure.png"},
      {"art/figure.png", "C:/figure.png"},
      {"art/figure.png", "..figure.png"},
      {"art/figure.png", ".hidden/...png"},
      {"\"id\": \"body\", ", ""},
      {"\"c\": 2, ", ""},
      {"\"c\": 2", "\"c\": 0"},
      {"\"c\": 2", "\"c\": \"2\""},
      {"\"d\": -0.5", "\"d\": 0"},
      {"\"d\": -0.5", "\"d\": 0.5"},
      {"\"d\": -0.5", "\"d\": -1001"},
      {"[20,99]", "[20]"},
      {"[20,99]", "[20,99,1]"},
      {"[20,99]", "[20,-2e6]"},
      {"[20,99]", "[20,-1e6]"},
      {"[[20,70],[20,99],[35,99],[35,70]]", "[[20,70],[20,99]]"},
      {"[[20,70],[35,70]] }", "[[20,70]] }"},
      {"\"equal\"", "\"under\""},
      {"[[20,72],[20,80]]", "[[20,72],[20,80],[1,1]]"},
      {"\"alpha0\": 0.1", "\"alpha0\": 0"},
      {"\"alpha0\": 0.1", "\"alpha0\": 1"},
      {"\"rho\": 0.25", "\"rho\": 0"},
      {", \"rho\": 0.25", ""},
      {"\"robin\": [", "\"robin\": [ null, "},
      {"\"cues\": [", "\"cues\": [ null, "},
      {"\"bulge\"", "\"bump\""},
      {"\"value\": 1.5", "\"value\": 45"},
      {"\"value\": 1.5", "\"value\": 0.05"},
      {"\"value\": -30", "\"value\": -76"},
      {"\"value\": 45", "\"value\": 75"},
      {", \"value\": 45", ""},
      {"[[22,80],[33,80.5]]", "[[22,80]]"},
  };
  for (const auto& [from, to] : changes) {
    const std::string text = with(sample_scene(), from, to);
    ASSERT_FALSE(text.empty()) << from;
    EXPECT_EQ(accepts(text), read_scene(text).ok()) << from << " -> " << to;
  }
}

TEST_F(SceneSchema, AcceptsTheExamples) {
  const std::filesystem::path folder = RELIEVO_EXAMPLES;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no examples";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    EXPECT_TRUE(accepts(text)) << entry.path();
    EXPECT_TRUE(read_scene(text)) << entry.path();
  }
}

}  // namespace
}  // namespace relievo
