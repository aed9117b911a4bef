#include <gtest/gtest.h>

#include <limits>

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"

namespace relievo {
namespace {

Ring square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

Scene two_squares() {
  Scene scene;
  scene.width = 100;
  scene.height = 100;
  scene.parts = {{"lower", {square(10, 10, 50)}}, {"upper", {square(40, 40, 50)}}};
  scene.joins = {{1, 0, {{40, 40}, {40, 60}}}};
  scene.relations = {{1, 0, RelationKind::free, {}}};
  scene.robin = {{1, 0, {40, 60}, {50, 60}, {}, {}}};
  return scene;
}

template <class Change>
std::string culprit(Change change) {
  Scene scene = two_squares();
  change(scene);
  const Status status = validate(scene);
  if (status) return "accepted";
  const Error& error = status.error();
  EXPECT_EQ(error.code, ErrorCode::bad_input);
  // Programs get the same item as people.
  EXPECT_EQ(error.where.find(to_string(error.culprit)), 0U) << error.where;
  EXPECT_EQ(error.culprit.list != CulpritList::none, error.where.find('[') != std::string::npos);
  return error.where;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Validate, AcceptsASoundScene) { EXPECT_TRUE(validate(two_squares())); }

TEST(Validate, AcceptsABowTie) {
  EXPECT_EQ(culprit([](Scene& s) {
              s.parts[0].outline = {{{0, 0}, {9, 9}, {9, 0}, {0, 9}}};
            }),
            "accepted");
}

TEST(Validate, RefusesWhatIsNotFinite) {
  EXPECT_EQ(culprit([](Scene& s) { s.width = nan; }), "canvas.width");
  EXPECT_EQ(culprit([](Scene& s) { s.height = infinity; }), "canvas.height");
  EXPECT_EQ(culprit([](Scene& s) { s.parts[1].outline[0][3].y = nan; }), "parts[1].outline[0][3]");
  EXPECT_EQ(culprit([](Scene& s) { s.parts[1].c = nan; }), "parts[1].c");
  EXPECT_EQ(culprit([](Scene& s) { s.parts[1].d = infinity; }), "parts[1].d");
  EXPECT_EQ(culprit([](Scene& s) { s.parts[1].lean.x = nan; }), "parts[1].lean");
  EXPECT_EQ(culprit([](Scene& s) { s.joins[0].line[1].x = nan; }), "joins[0].line[1]");
  EXPECT_EQ(culprit([](Scene& s) { s.robin[0].from.x = nan; }), "robin[0].from");
  EXPECT_EQ(culprit([](Scene& s) { s.robin[0].alpha0 = nan; }), "robin[0].alpha0");
  EXPECT_EQ(culprit([](Scene& s) { s.robin[0].rho = nan; }), "robin[0].rho");
}

TEST(Validate, WantsARangeOfBelow) {
  EXPECT_EQ(culprit([](Scene& s) { s.relations[0].kind = RelationKind::below; }),
            "relations[0].range");
  EXPECT_EQ(culprit([](Scene& s) {
              s.relations[0] = {1, 0, RelationKind::below, std::pair{Point2{40, 40}, Point2{9, 9}}};
            }),
            "accepted");
}

TEST(Validate, RefusesUnsoundCues) {
  const auto cue = [](int part, CueKind kind, std::vector<Point2> line, double value) {
    return culprit([&](Scene& s) { s.cues = {{part, kind, std::move(line), value}}; });
  };
  const std::vector<Point2> line = {{20, 20}, {30, 30}};
  EXPECT_EQ(cue(0, CueKind::bulge, line, 10), "accepted");
  EXPECT_EQ(cue(1, CueKind::crease, line, -75), "accepted");
  EXPECT_EQ(cue(-1, CueKind::bulge, line, 2), "cues[0].part");
  EXPECT_EQ(cue(2, CueKind::bulge, line, 2), "cues[0].part");
  EXPECT_EQ(cue(0, CueKind::bulge, {{20, 20}, {20, 20}}, 2), "cues[0].line");
  EXPECT_EQ(cue(0, CueKind::slope, {}, 2), "cues[0].line");
  EXPECT_EQ(cue(0, CueKind::slope, {{0, 0}, {nan, 0}}, 2), "cues[0].line[1]");
  EXPECT_EQ(cue(0, CueKind::slope, std::vector<Point2>(1001, Point2{1, 1}), 2), "cues[0].line");
  EXPECT_EQ(cue(0, CueKind::bulge, line, 0.04), "cues[0].value");
  EXPECT_EQ(cue(0, CueKind::bulge, line, nan), "cues[0].value");
  EXPECT_EQ(cue(0, CueKind::slope, line, 75.5), "cues[0].value");
  EXPECT_EQ(cue(0, CueKind::crease, line, infinity), "cues[0].value");
  EXPECT_EQ(culprit([](Scene& s) {
              s.cues.assign(257, {0, CueKind::slope, {{1, 1}, {2, 2}}, 3});
            }),
            "cues");
}

TEST(Validate, RefusesLeansThatAreTooSteep) {
  EXPECT_EQ(culprit([](Scene& s) { s.parts[0].lean = {2, -2}; }), "accepted");
  EXPECT_EQ(culprit([](Scene& s) { s.parts[0].lean = {2.01, 0}; }), "parts[0].lean");
  EXPECT_EQ(culprit([](Scene& s) { s.parts[0].lean = {0, -2.01}; }), "parts[0].lean");
}

TEST(Validate, RefusesIndicesWithoutPart) {
  EXPECT_EQ(culprit([](Scene& s) { s.parts.clear(); }), "parts");
  EXPECT_EQ(culprit([](Scene& s) { s.joins[0].upper = 2; }), "joins[0].upper");
  EXPECT_EQ(culprit([](Scene& s) { s.joins[0].lower = -1; }), "joins[0].lower");
  EXPECT_EQ(culprit([](Scene& s) { s.relations[0].upper = 9; }), "relations[0].upper");
  EXPECT_EQ(culprit([](Scene& s) { s.robin[0].lower = 9; }), "robin[0].lower");
}

TEST(Validate, WantsTheUpperPartInFront) {
  EXPECT_EQ(culprit([](Scene& s) { std::swap(s.joins[0].upper, s.joins[0].lower); }), "joins[0]");
  EXPECT_EQ(culprit([](Scene& s) { s.relations[0].upper = 0; }), "relations[0]");
}

}  // namespace
}  // namespace relievo
