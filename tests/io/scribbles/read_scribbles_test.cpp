
#include <gtest/gtest.h>

#include "io/scribbles/scribbles_json.h"
#include "io/scribbles/write_scribbles.h"
#include "io/support/damage.h"
#include "io/support/temporary_folder.h"

namespace relievo {
namespace {

understanding::Scribbles sample() {
  return {{"head", "body \"1\""},
          {{understanding::ScribbleKind::hard, 0, {{1.5, 2}, {3, 0.1}}, 4},
           {understanding::ScribbleKind::soft, 1, {{7, 8}}, 2.5},
           {understanding::ScribbleKind::outside, 0, {{0, 0}}, 1},
           {understanding::ScribbleKind::hole, 0, {{9, 9}, {10, 9}}, 3}}};
}

TEST(Scribbles, WhatIsWrittenReadsBack) {
  const Result<understanding::Scribbles> s = read_scribbles(write_scribbles(sample()));
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  const understanding::Scribbles expected = sample();
  EXPECT_EQ(s->parts, expected.parts);
  ASSERT_EQ(s->strokes.size(), expected.strokes.size());
  for (size_t k = 0; k < expected.strokes.size(); ++k) {
    EXPECT_EQ(s->strokes[k].kind, expected.strokes[k].kind);
    EXPECT_EQ(s->strokes[k].part, expected.strokes[k].part);
    EXPECT_EQ(s->strokes[k].points, expected.strokes[k].points);
    EXPECT_EQ(s->strokes[k].width, expected.strokes[k].width);
  }
  EXPECT_EQ(write_scribbles(*s), write_scribbles(expected));
}

TEST(Scribbles, FilesAreCompleteUnlessTheySayOtherwise) {
  const auto with = [](const std::string& word) {
    std::string text = write_scribbles(sample());
    return read_scribbles(text.insert(text.find("\"parts\""), "\"complete\": " + word + ", "));
  };
  EXPECT_TRUE(read_scribbles(write_scribbles(sample()))->complete);
  EXPECT_TRUE(with("true")->complete);
  EXPECT_FALSE(with("false")->complete);
  ASSERT_FALSE(with("0").ok());
  EXPECT_EQ(with("0").error().where, "complete");
}

TEST(Scribbles, TheNumberOfPartsIsAWholeNumberOrNotSaid) {
  const auto with = [](const std::string& word) {
    std::string text = write_scribbles(sample());
    return read_scribbles(text.insert(text.find("\"parts\""), "\"count\": " + word + ", "));
  };
  EXPECT_EQ(read_scribbles(write_scribbles(sample()))->count, 0);
  EXPECT_EQ(with("1")->count, 1);
  EXPECT_EQ(with("1000")->count, 1000);
  for (const char* word : {"0", "1001", "-3", "2.5", "\"many\"", "18446744073709551615"}) {
    ASSERT_FALSE(with(word).ok()) << word;
    EXPECT_EQ(with(word).error().where, "count") << word;
  }
}

TEST(Scribbles, MistakesAreNamedWithTheirPlace) {
  const std::string good = write_scribbles(sample());
  const auto refuse = [&](const std::string& from, const std::string& to, const char* where) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    const Result<understanding::Scribbles> s = read_scribbles(text);
    ASSERT_FALSE(s.ok()) << to;
    EXPECT_EQ(s.error().code, ErrorCode::bad_input);
    EXPECT_EQ(s.error().where, where) << s.error().message;
  };
  refuse("relievo-scribbles", "relievo-scene", "format");
  refuse("\"version\": 1", "\"version\": 2", "version");
  refuse("\"hard\"", "\"loud\"", "strokes[0].kind");
  refuse("\"part\":\"head\"", "\"part\":\"tail\"", "strokes[0].part");
  refuse("\"width\":2.5", "\"width\":0", "strokes[1].width");
  refuse("[7.0,8.0]", "[7.0]", "strokes[1].points[0]");
  refuse("[7.0,8.0]", "[7.0,8e6]", "strokes[1].points[0]");
  refuse("\"width\":2.5", "\"width\":2e6", "strokes[1].width");
  refuse("[[0.0,0.0]]", "[]", "strokes[2].points");
  refuse("\"kind\":\"hole\"", "\"kind\":\"hole\",\"part\":\"head\"", "strokes[3].part");
  refuse("\"kind\":\"outside\"", "\"kind\":\"outside\",\"colour\":1", "strokes[2].colour");
  refuse("[\"head\"", "[\"body \\\"1\\\"\"", "parts[1]");
}

TEST(Scribbles, LimitsAreTheCallers) {
  const std::string text = write_scribbles(sample());
  JsonLimits strokes;
  strokes.max_strokes = 3;
  JsonLimits points;
  points.max_points = 5;
  JsonLimits bytes;
  bytes.max_bytes = 20;
  for (const JsonLimits& limits : {strokes, points, bytes})
    EXPECT_EQ(read_scribbles(text, limits).error().code, ErrorCode::limit);
}

TEST(Scribbles, EveryTruncationIsRefused) {
  const std::string text = write_scribbles(sample());
  for (size_t size = 0; size + 2 < text.size(); ++size)
    EXPECT_FALSE(read_scribbles(std::string_view(text).substr(0, size)).ok()) << size;
}

/// Seeds with more and more strokes of all kinds.
TEST(Scribbles, DamageOfTenSeedsNeverCrashes) {
  understanding::Scribbles scribbles = sample();
  for (int seed = 0; seed < 10; ++seed) {
    const Bytes good = to_bytes(write_scribbles(scribbles));
    ASSERT_TRUE(read_scribbles(to_text(good)).ok());
    survive_damage(good, 300, [](ByteView bytes) {
      return read_scribbles({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
    understanding::Scribble stroke = scribbles.strokes[static_cast<size_t>(seed % 4)];
    stroke.points.push_back({1e-3 * seed, 1e5 / (1 + seed)});
    scribbles.strokes.push_back(stroke);
    scribbles.parts.push_back("part \xc3\xa9 " + std::to_string(seed));
  }
}

}  // namespace
}  // namespace relievo
