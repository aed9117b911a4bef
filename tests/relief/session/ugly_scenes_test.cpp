#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "kernel/base/stopwatch.h"
#include "relief/session/build_relief.h"
#include "relief/surface/assemble_model.h"
#include "support/mesh_checks.h"
#include "support/model_defect.h"
#include "support/ugly_scene.h"

namespace relievo::relief {
namespace {

using namespace testing;

constexpr double max_residual = 1e-10;

/// The range of scenes to test. RELIEVO_UGLY_SCENES=FROM-TO selects another and prints a table of
/// the outcomes.
struct Seeds {
  uint64_t first = 1;
  uint64_t last = 150;
  bool table = false;
};

Seeds asked_seeds() {
  Seeds seeds;
  const char* text = std::getenv("RELIEVO_UGLY_SCENES");
  if (text == nullptr) return seeds;
  char* rest = nullptr;
  seeds.first = std::strtoull(text, &rest, 10);
  seeds.last = *rest == '-' ? std::strtoull(rest + 1, nullptr, 10) : seeds.first;
  seeds.table = true;
  return seeds;
}

ReliefOptions options_of(uint64_t seed) {
  ReliefOptions options;
  options.layers.vertex_budget = std::array{300, 700, 2000, 1100, 2000}[seed % 5];
  if (seed % 7 == 0) options.method = Method::nonlinear;
  return options;
}

double worst_residual(const BoundQpReport& report) {
  return std::max({report.stationarity, report.primal, report.dual, report.complementarity});
}

/// Scenes that once failed: a root shorter than an edge, faces left out beside a cut, a lattice
/// beside a speck.
constexpr std::array<uint64_t, 6> found_defects = {41474, 56105, 58849, 77152, 79830, 82743};

/// Returns the outcome of a scene: the kind of its error, "solved", or a defect.
std::string outcome(const Scene& scene, const ReliefOptions& options) {
  if (!validate(scene)) return "not valid";
  const auto relief = build_relief(scene, options);
  if (!relief) {
    const Error& error = relief.error();
    if (error.code == ErrorCode::internal) return "DEFECT " + error.message;
    if (error.message.empty()) return "DEFECT an error without a reason";
    return "refused: " + error.message.substr(0, error.message.find_first_of("\"("));
  }
  if (const std::string wrong = inconsistency(relief->layers, false); !wrong.empty())
    return "DEFECT " + wrong;
  const Manifoldness m = check_manifold(relief->layers);
  if (m.repeated_edges > 0 || m.bow_ties > 0) return "DEFECT the mesh is not manifold";
  const BoundQpReport& report = relief->ordering.report;
  if (report.status == SolveStatus::solved && !(worst_residual(report) <= max_residual))
    return "DEFECT residual " + std::to_string(std::log10(worst_residual(report)));
  const auto model = assemble_model({relief->layers, relief->inflation, relief->ordering, scene},
                                    {Visibility::orbit});
  if (!model) return "DEFECT " + model.error().message;
  if (const std::string wrong = model_defect(*model); !wrong.empty()) return "DEFECT " + wrong;
  return report.status == SolveStatus::solved ? "solved" : "iteration limit";
}

TEST(UglyScenes, EndInASoundModelOrANamedReason) {
  const Seeds seeds = asked_seeds();
  std::map<std::string, int> table;
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    if (seeds.table) std::fprintf(stderr, "\rseed %llu ", static_cast<unsigned long long>(seed));
    const Stopwatch watch;
    const std::string result = outcome(ugly_scene(seed), options_of(seed));
    ++table[result];
    EXPECT_NE(result.substr(0, 6), "DEFECT") << "seed " << seed << ": " << result;
    if (seeds.table && watch.milliseconds() > 3000)
      std::printf("seed %llu takes %.0f ms\n", static_cast<unsigned long long>(seed),
                  watch.milliseconds());
  }
  if (seeds.table)
    for (const auto& [result, count] : table) std::printf("%8d  %s\n", count, result.c_str());
  EXPECT_GT(table["solved"], 0);
}

TEST(UglyScenes, ThatHaveFoundDefectsFindNoneAnyMore) {
  for (const uint64_t seed : found_defects)
    EXPECT_EQ(outcome(ugly_scene(seed), options_of(seed)), "solved") << seed;
}

}  // namespace
}  // namespace relievo::relief
