#include <gtest/gtest.h>

#include "io/scene/sample_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

TEST(ReadScene, ReadsEveryKey) {
  const auto scene = read_scene(sample_scene());
  ASSERT_TRUE(scene) << to_string(scene.error());
  EXPECT_EQ(scene->width, 200);
  EXPECT_EQ(scene->height, 100.5);
  EXPECT_EQ(scene->drawing, "art/figure.png");
  ASSERT_EQ(scene->parts.size(), 2U);
  EXPECT_EQ(scene->parts[0].id, "body");
  EXPECT_EQ(scene->parts[0].c, 4);
  EXPECT_EQ(scene->parts[0].d, 1);
  EXPECT_EQ(scene->parts[1].c, 2);
  EXPECT_EQ(scene->parts[1].d, -0.5);
  EXPECT_EQ(scene->parts[0].lean, (Point2{0, 0}));
  EXPECT_EQ(scene->parts[1].lean, (Point2{0.5, -0.25}));
  ASSERT_EQ(scene->joins.size(), 1U);
  EXPECT_EQ(scene->joins[0].upper, 1);
  EXPECT_EQ(scene->joins[0].lower, 0);
  EXPECT_EQ(scene->joins[0].line, (std::vector<Point2>{{20, 70}, {35, 70}}));
  ASSERT_EQ(scene->relations.size(), 4U);
  EXPECT_EQ(scene->relations[0].kind, RelationKind::equal);
  EXPECT_EQ(scene->relations[0].range->second, (Point2{20, 80}));
  EXPECT_EQ(scene->relations[1].kind, RelationKind::above);
  EXPECT_FALSE(scene->relations[1].range);
  EXPECT_EQ(scene->relations[2].kind, RelationKind::free);
  EXPECT_EQ(scene->relations[3].kind, RelationKind::below);
  EXPECT_EQ(scene->relations[3].range->first, (Point2{35, 88}));
  ASSERT_EQ(scene->robin.size(), 1U);
  EXPECT_EQ(scene->robin[0].from, (Point2{35, 70}));
  EXPECT_EQ(scene->robin[0].to, (Point2{35, 90}));
  EXPECT_EQ(scene->robin[0].alpha0, 0.1);
  EXPECT_EQ(scene->robin[0].rho, 0.25);
  ASSERT_EQ(scene->cues.size(), 3U);
  EXPECT_EQ(scene->cues[0].part, 0);
  EXPECT_EQ(scene->cues[0].kind, CueKind::bulge);
  EXPECT_EQ(scene->cues[0].line, (std::vector<Point2>{{15, 15}, {30, 30}, {30, 50}}));
  EXPECT_EQ(scene->cues[0].value, 1.5);
  EXPECT_EQ(scene->cues[1].part, 1);
  EXPECT_EQ(scene->cues[1].kind, CueKind::slope);
  EXPECT_EQ(scene->cues[1].value, -30);
  EXPECT_EQ(scene->cues[2].kind, CueKind::crease);
}

TEST(ReadScene, OrientsRingsByNesting) {
  const auto scene = read_scene(sample_scene());
  ASSERT_TRUE(scene);
  EXPECT_GT(signed_area(scene->parts[0].outline[0]), 0);
  EXPECT_LT(signed_area(scene->parts[0].outline[1]), 0);
  EXPECT_GT(signed_area(scene->parts[1].outline[0]), 0);
}

struct Refusal {
  const char* from;
  const char* to;
  const char* where;
  const char* message;  ///< a part of it
};

std::ostream& operator<<(std::ostream& out, const Refusal& r) {
  return out << r.from << " -> " << r.to;
}

class RefusedScene : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedScene, NamesTheKey) {
  const std::string text = with(sample_scene(), GetParam().from, GetParam().to);
  ASSERT_FALSE(text.empty());
  const auto scene = read_scene(text);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::bad_input);
  EXPECT_EQ(scene.error().where, GetParam().where);
  const Culprit culprit = scene.error().culprit;
  EXPECT_EQ(scene.error().where.find(to_string(culprit)), 0U);
  const bool in_list = scene.error().where.find('[') != std::string::npos;
  const bool parsed = std::string(GetParam().message) != "given twice";
  EXPECT_EQ(culprit.list != CulpritList::none, in_list && parsed);
  EXPECT_NE(scene.error().message.find(GetParam().message), std::string::npos)
      << scene.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    Keys, RefusedScene,
    testing::Values(
        Refusal{"relievo-scene", "other", "format", "not a scene"},
        Refusal{"\"version\": 1", "\"version\": 2", "version", "version 1 only"},
        Refusal{"\"version\": 1", "\"version\": 1.5", "version", "version 1 only"},
        Refusal{"\"version\": 1,", "", "version", "version 1 only"},
        Refusal{"\"drawing\":", "\"picture\":", "picture", "not a known key"},
        Refusal{"\"drawing\":", "\"\":", "\"\"", "not a known key"},
        Refusal{"\"canvas\":", "\"version\":", "version", "given twice"},
        Refusal{"\"c\": 2,", "\"c\": 2, \"c\": 2,", "parts[1].c", "given twice"},
        Refusal{"\"height\": 100.5", "\"height\": 100.5, \"depth\": 3", "canvas.depth",
                "not a known key"},
        Refusal{", \"height\": 100.5", "", "canvas.height", "missing"},
        Refusal{"200", "0", "canvas.width", "at least 0.001"},
        Refusal{"200", "1e-300", "canvas.width", "at least 0.001"},
        Refusal{"200", "2e6", "canvas.width", "at most 1000000"},
        Refusal{"200", "\"200\"", "canvas.width", "must be a number"},
        Refusal{"art/figure.png", "", "drawing", "empty"},
        Refusal{"art/figure.png", "/etc/passwd", "drawing", "relative path"},
        Refusal{"art/figure.png", "../figure.png", "drawing", "relative path"},
        Refusal{"art/figure.png", "art/../../figure.png", "drawing", "relative path"},
        Refusal{"art/figure.png", "..\\\\figure.png", "drawing", "relative path"},
        Refusal{"art/figure.png", "C:figure.png", "drawing", "relative path"},
        Refusal{"art/figure.png", "art//figure.png", "drawing", "relative path"},
        Refusal{"art/figure.png", "a\\u0000b", "drawing", "relative path"},
        Refusal{"\"art/figure.png\"", "7", "drawing", "text in quotes"},
        Refusal{"\"id\": \"body\", ", "", "parts[0].id", "missing"},
        Refusal{"\"id\": \"leg\"", "\"id\": \"body\"", "parts[1].id", "taken by parts[0]"},
        Refusal{"\"id\": \"leg\"", "\"id\": \"\"", "parts[1].id", "1 to 200 bytes"},
        Refusal{"\"id\": \"leg\"", "\"id\": \"l\\u001b[0m\"", "parts[1].id", "control"},
        Refusal{"\"id\": \"leg\"", "\"id\": null", "parts[1].id", "text in quotes"},
        Refusal{"[0.5, -0.25]", "0.5", "parts[1].lean", "[x, y]"},
        Refusal{"[0.5, -0.25]", "[0.5, -3]", "parts[1].lean", "-2 to 2"},
        Refusal{"[20,99]", "[20,\"99\"]", "parts[1].outline[0][1][1]", "must be a number"},
        Refusal{"[20,99]", "[20]", "parts[1].outline[0][1]", "point [x, y]"},
        Refusal{"[20,99]", "[20,99,0]", "parts[1].outline[0][1]", "point [x, y]"},
        Refusal{"[20,99]", "[20,1000001]", "parts[1].outline[0][1]", "1000000"},
        Refusal{"[20,99]", "[-1e300,99]", "parts[1].outline[0][1]", "1000000"},
        Refusal{"[[20,70],[20,99],[35,99],[35,70]]", "[[20,70],[20,99]]", "parts[1].outline[0]",
                "no area"},
        Refusal{"[[20,70],[20,99],[35,99],[35,70]]", "[[1,1],[1,1],[1,1]]", "parts[1].outline[0]",
                "no area"},
        Refusal{"[[20,70],[20,99],[35,99],[35,70]]", "[[1,1],[2,2],[7,7],[3,3]]",
                "parts[1].outline[0]", "no area"},
        Refusal{"[[20,70],[20,99],[35,99],[35,70]]", "[]", "parts[1].outline[0]", "no area"},
        Refusal{"[ [[20,70],[20,99],[35,99],[35,70]] ]", "[]", "parts[1].outline", "no ring"},
        Refusal{"[ [[20,70],[20,99],[35,99],[35,70]] ]", "{}", "parts[1].outline", "list of"},
        Refusal{"\"c\": 2", "\"c\": 0", "parts[1].c", "0.001"},
        Refusal{"\"c\": 2", "\"c\": -2", "parts[1].c", "0.001"},
        Refusal{"\"d\": -0.5", "\"d\": 0", "parts[1].d", "0.001"},
        Refusal{"\"d\": -0.5", "\"d\": 1e9", "parts[1].d", "1000"},
        Refusal{"\"upper\": \"leg\"", "\"upper\": \"arm\"", "joins[0].upper", "\"arm\""},
        Refusal{"\"upper\": \"leg\"", "\"upper\": \"body\"", "joins[0]", "same part"},
        Refusal{"\"lower\": \"body\", \"from\"", "\"lower\": \"toe\", \"from\"", "robin[0].lower",
                "\"toe\""},
        Refusal{"\"upper\": \"leg\", \"lower\": \"body\", \"from\"",
                "\"upper\": \"body\", \"lower\": \"leg\", \"from\"", "robin[0]", "lies behind"},
        Refusal{"[[20,70],[35,70]] }", "[[20,70]] }", "joins[0].line", "no length"},
        Refusal{"[[20,70],[35,70]] }", "[] }", "joins[0].line", "no length"},
        Refusal{"[[20,70],[35,70]] }", "[[20,70],[2e6,70]] }", "joins[0].line[1]", "1000000"},
        Refusal{"\"equal\"", "\"beside\"", "relations[0].relation", "\"above\""},
        Refusal{"\"free\"", "\"below\"", "relations[2].range", "needs"},
        Refusal{"[[20,72],[20,80]]", "[[20,72]]", "relations[0].range", "two points"},
        Refusal{"[[20,72],[20,80]]", "[[20,72],[20,72]]", "relations[0].range", "where it ends"},
        Refusal{"[[20,72],[20,80]]", "[[20,2e6],[20,72]]", "relations[0].range[0]", "1000000"},
        Refusal{"\"to\": [35,90]", "\"to\": [35,70]", "robin[0]", "where it ends"},
        Refusal{"\"to\": [35,90]", "\"to\": [35,1e7]", "robin[0].to", "1000000"},
        Refusal{"\"alpha0\": 0.1", "\"alpha0\": 1", "robin[0].alpha0", "below 1"},
        Refusal{"\"alpha0\": 0.1", "\"alpha0\": -0.1", "robin[0].alpha0", "below 1"},
        Refusal{"\"rho\": 0.25", "\"rho\": 0", "robin[0].rho", "above 0"},
        Refusal{"\"rho\": 0.25", "\"rho\": true", "robin[0].rho", "must be a number"},
        Refusal{"\"robin\": [", "\"robin\": [ 5, ", "robin[0]", "must be an object"},
        Refusal{"\"part\": \"body\"", "\"part\": \"arm\"", "cues[0].part", "\"arm\""},
        Refusal{"\"part\": \"body\", ", "", "cues[0].part", "missing"},
        Refusal{"\"bulge\"", "\"bump\"", "cues[0].kind", "\"crease\""},
        Refusal{"\"kind\": \"bulge\"", "\"kind\": \"bulge\", \"to\": 1", "cues[0].to",
                "not a known key"},
        Refusal{"[[25,75],[25,95]]", "[[25,75]]", "cues[1].line", "no length"},
        Refusal{"[[25,75],[25,95]]", "[[25,75],[25,2e6]]", "cues[1].line[1]", "1000000"},
        Refusal{"\"value\": 1.5", "\"value\": 0", "cues[0].value", "0.05 to 10"},
        Refusal{"\"value\": 1.5", "\"value\": 11", "cues[0].value", "0.05 to 10"},
        Refusal{"\"value\": -30", "\"value\": -76", "cues[1].value", "-75 to 75"},
        Refusal{"\"value\": 45", "\"value\": \"steep\"", "cues[2].value", "must be a number"},
        Refusal{"\"cues\": [", "\"cues\": [ 5, ", "cues[0]", "must be an object"}));

TEST(ReadScene, JoinsOfLimbsBehindFollowTheOutlineInFront) {
  const auto relation_of = [](const std::string& line) {
    const auto scene = read_scene(
        R"({ "format": "relievo-scene", "version": 1, "canvas": { "width": 100, "height": 100 },
             "parts": [ { "id": "leg", "outline": [[[40,40],[60,40],[60,90],[40,90]]] },
                        { "id": "body", "outline": [[[10,10],[10,60],[90,60],[90,10]]] } ],
             "joins": [ { "upper": "leg", "lower": "body", "line": )" +
        line + " } ] }");
    EXPECT_TRUE(scene.ok());
    EXPECT_TRUE(scene->joins.empty());
    EXPECT_EQ(scene->relations.size(), 1U);
    return scene->relations.at(0);
  };
  for (const char* line : {"[[38,60],[62,60]]", "[[62,60],[38,60]]"}) {
    const Relation relation = relation_of(line);
    EXPECT_EQ(relation.upper, 1);
    EXPECT_EQ(relation.lower, 0);
    EXPECT_EQ(relation.kind, RelationKind::joined);
    EXPECT_EQ(relation.range->first, (Point2{62, 60})) << "clockwise on the page";
    EXPECT_EQ(relation.range->second, (Point2{38, 60}));
  }
}

TEST(ReadScene, LocatesMalformedJson) {
  const auto scene = read_scene("{\n  \"format\": nope\n}");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::bad_input);
  EXPECT_EQ(scene.error().where.substr(0, 6), "line 2");
  EXPECT_EQ(scene.error().message.substr(0, 15), "malformed JSON:");
}

TEST(ReadScene, RefusesNumbersOutsideDoubles) {
  const auto scene = read_scene(with(sample_scene(), "[20,99]", "[20,1e999]"));
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message.substr(0, 15), "malformed JSON:");
}

TEST(ReadScene, RefusesDeepNestingWithoutRecursion) {
  for (const char* open : {"[", "{\"a\":"}) {
    std::string text;
    for (int i = 0; i < 1000000; ++i) text += open;
    const auto scene = read_scene(text);
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::limit);
    EXPECT_NE(scene.error().message.find("nested deeper"), std::string::npos);
  }
}

TEST(ReadScene, KeepsToItsLimits) {
  JsonLimits bytes;
  bytes.max_bytes = 100;
  JsonLimits parts;
  parts.max_parts = 1;
  JsonLimits points;
  points.max_points = 9;
  for (const JsonLimits& limits : {bytes, parts, points}) {
    const auto scene = read_scene(sample_scene(), limits);
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::limit);
  }
  bytes.max_bytes = sample_scene().size();
  parts.max_parts = 2;
  points.max_points = 25;
  for (const JsonLimits& limits : {bytes, parts, points})
    EXPECT_TRUE(read_scene(sample_scene(), limits));
}

TEST(ReadScene, RefusesEveryTruncation) {
  const std::string text = sample_scene();
  for (size_t length = 0; length < text.size(); ++length)
    EXPECT_FALSE(read_scene(std::string_view(text).substr(0, length))) << length;
}

}  // namespace
}  // namespace relievo
