#include "solid/check_print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "solid/make_solid.h"
#include "solid/solid_case.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

using namespace testing;

constexpr double nozzle = 0.4;

/// Adds a flat bar in the plane of the drawing, between two corners, px, to the last part if that
/// has the given id, or else as a part.
void add_bar(Model& model, const std::string& id, Point2 low, Point2 high) {
  const int first = static_cast<int>(model.positions.size());
  for (const Point2 p : {low, Point2{high.x, low.y}, high, Point2{low.x, high.y}}) {
    model.positions.push_back({p.x, p.y, 0});
    model.normals.push_back({0, 0, 1});
    model.uvs.push_back({p.x / model.width, 1 - p.y / model.height});
  }
  if (model.parts.empty() || model.parts.back().id != id) {
    model.parts.emplace_back().id = id;
    model.parts.back().first_triangle = static_cast<int>(model.triangles.size());
  }
  model.parts.back().triangle_count += 2;
  model.triangles.push_back({first, first + 1, first + 2});
  model.triangles.push_back({first, first + 2, first + 3});
}

std::vector<PrintFinding> findings_of(const Model& model, const SolidOptions& options) {
  const auto solid = make_solid({model, {}, {}}, {}, options);
  EXPECT_TRUE(solid.ok());
  return solid.ok() ? check_print(solid->model, solid->facts.loose, nozzle)
                    : std::vector<PrintFinding>{};
}

const PrintFinding* find(const std::vector<PrintFinding>& findings, PrintTrouble trouble) {
  const auto at = std::find_if(findings.begin(), findings.end(),
                               [trouble](const PrintFinding& f) { return f.trouble == trouble; });
  return at == findings.end() ? nullptr : &*at;
}

TEST(CheckPrint, FindsNothingOnABall) { EXPECT_TRUE(findings_of(hemisphere(40, 64), {}).empty()); }

TEST(CheckPrint, MeasuresThinWalls) {
  // 100 px become 100 mm.
  for (const double width : {0.3, 0.6}) {
    Model model = empty_model(100, 100);
    add_bar(model, "whisker", {0, 10}, {100, 10 + width});
    const auto findings = findings_of(model, {});
    const PrintFinding* thin = find(findings, PrintTrouble::thin);
    EXPECT_EQ(thin != nullptr, width < nozzle);
    if (thin == nullptr) continue;
    EXPECT_EQ(thin->part, "whisker");
    EXPECT_NEAR(thin->measure, width, 0.02);
    // Three nozzles make it no neck either, at a width of 1.2 mm.
    EXPECT_EQ(thin->enough, 500);
    EXPECT_NE(describe(*thin).find("--size 500"), std::string::npos);
  }
}

TEST(CheckPrint, KnowsLimbsThatBreakOff) {
  for (const double width : {1.0, 1.5}) {
    Model model = empty_model(100, 100);
    add_bar(model, "tail", {0, 10}, {100, 10 + width});
    const auto findings = findings_of(model, {});
    EXPECT_EQ(find(findings, PrintTrouble::thin), nullptr);
    const PrintFinding* neck = find(findings, PrintTrouble::neck);
    EXPECT_EQ(neck != nullptr, width < 3 * nozzle);
    if (neck != nullptr) {
      EXPECT_NEAR(neck->measure, width, 0.05);
    }
    SolidOptions held;
    held.base = BaseShape::plate;
    EXPECT_EQ(find(findings_of(model, held), PrintTrouble::neck), nullptr);
  }
}

/// A hilt with a blade from 3 px to `tip` px wide.
Model sword(double tip) {
  Model model = empty_model(100, 100);
  for (const Point2 rows : {Point2{0, 20}, Point2{20, 23}, Point2{23, 40}})
    add_bar(model, "hilt", {0, rows.x}, {30, rows.y});
  constexpr int bars = 35;
  const auto width = [tip](double s) { return (1 - s) * 3 + s * tip; };
  for (int i = 0; i < bars; ++i) {
    add_bar(model, "blade", {30 + 2.0 * i, 20}, {32 + 2.0 * i, 20 + width(1.0 * i / bars)});
    model.positions[model.positions.size() - 2].y = 20 + width((i + 1.0) / bars);
  }
  return model;
}

TEST(CheckPrint, AdvisesASizeThatIsEnough) {
  const Model model = sword(0.6);
  SolidOptions options;
  options.size = 50;
  const auto findings = findings_of(model, options);
  ASSERT_FALSE(findings.empty());
  double enough = options.size;
  for (const PrintFinding& finding : findings) {
    EXPECT_GT(finding.enough, options.size);
    enough = std::max(enough, finding.enough);
  }
  options.thickness *= enough / options.size;
  options.size = enough;
  for (const PrintFinding& finding : findings_of(model, options))
    ADD_FAILURE() << describe(finding);
}

TEST(CheckPrint, AdvisesNoSizeForWhatTapersToNothing) {
  const auto findings = findings_of(sword(0.001), {});
  const PrintFinding* thin = find(findings, PrintTrouble::thin);
  ASSERT_NE(thin, nullptr);
  EXPECT_EQ(thin->enough, 0);
  EXPECT_EQ(describe(*thin).find("--size"), std::string::npos) << describe(*thin);
}

/// A square with a smaller one beside it, of bars whose corners meet, and a bridge between them.
Model dumbbell(double bridge) {
  Model model = empty_model(100, 100);
  const double low = 20;
  const double high = low + bridge;
  for (const Point2 rows : {Point2{0, low}, Point2{low, high}, Point2{high, 40}})
    add_bar(model, "body", {0, rows.x}, {40, rows.y});
  add_bar(model, "bridge", {40, low}, {42, high});
  for (const Point2 rows : {Point2{10, low}, Point2{low, high}, Point2{high, 30}})
    add_bar(model, "head", {42, rows.x}, {60, rows.y});
  return model;
}

TEST(CheckPrint, KnowsWhatHangsByANeck) {
  SolidOptions options;
  options.size = 60;
  for (const double bridge : {0.7, 1.1, 1.5}) {
    const auto findings = findings_of(dumbbell(bridge), options);
    const PrintFinding* neck = find(findings, PrintTrouble::neck);
    EXPECT_EQ(neck != nullptr, bridge < 3 * nozzle);
    if (neck == nullptr) continue;
    EXPECT_EQ(neck->part, "head");
    EXPECT_NEAR(neck->measure, bridge, nozzle);
    EXPECT_GE(neck->measure, bridge);
  }
}

TEST(CheckPrint, KnowsWhatHangsOver) {
  relief::VisibleSheet sheet{hemisphere(40, 64), {}, {}};
  for (const Point3 p : sheet.model.positions) sheet.back.push_back({-p.z, 0});
  SolidOptions options;
  options.size = 80;
  options.back = BackSide::mirror;
  const auto solid = make_solid(sheet, {}, options);
  ASSERT_TRUE(solid.ok());
  const auto findings = check_print(solid->model, {}, nozzle);
  const PrintFinding* over = find(findings, PrintTrouble::overhang);
  ASSERT_NE(over, nullptr);
  // The cap of a sphere below 45 degrees.
  const double cap = 2 * M_PI * 40 * 40 * (1 - std::sqrt(0.5));
  EXPECT_NEAR(over->measure, cap, 0.05 * cap);
}

}  // namespace
}  // namespace relievo
