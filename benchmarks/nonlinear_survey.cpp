#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "relief/session/build_relief.h"
#include "support/random_scene.h"

// Solves random scenes by the non-linear method and prints a row for each and the distribution of
// the steps. Usage: nonlinear_survey VERTICES FIRST_SEED LAST_SEED LAMBDA_BND...

namespace relievo {
namespace {

struct Tally {
  std::vector<int> steps;  ///< of the scenes that converged
  int failed = 0;
};

/// Returns whether a surface joins parts with d > 0 and d < 0.
bool has_mixed_joins(const Scene& scene) {
  return std::any_of(scene.joins.begin(), scene.joins.end(), [&](const Join& join) {
    return scene.parts[join.upper].d * scene.parts[join.lower].d < 0;
  });
}

void survey(uint64_t seed, int vertices, double lambda_bnd, Tally (&tallies)[2]) {
  const Scene scene = testing::random_scene(seed);
  relief::ReliefOptions options;
  options.method = Method::nonlinear;
  options.layers.vertex_budget = vertices;
  options.nonlinear.lambda_bnd = lambda_bnd;
  const Result<relief::Relief> relief = relief::build_relief(scene, options);
  const bool mixed = has_mixed_joins(scene);
  if (!relief) {
    ++tallies[mixed].failed;
    std::printf("%d,%g,%d,error: %s\n", static_cast<int>(seed), lambda_bnd, mixed,
                to_string(relief.error()).c_str());
    return;
  }
  const relief::NonlinearReport& report = relief->nonlinear;
  const int steps = static_cast<int>(report.steps.size());
  const bool solved = report.status == SolveStatus::solved;
  double milliseconds = 0;
  for (const relief::NonlinearStep& step : report.steps) milliseconds += step.milliseconds;
  if (solved) tallies[mixed].steps.push_back(steps);
  tallies[mixed].failed += solved ? 0 : 1;
  std::printf("%d,%g,%d,%s,%d,%.1e,%.1e,%.0f\n", static_cast<int>(seed), lambda_bnd, mixed,
              solved ? "solved" : "not solved", steps, report.residual,
              relief->ordering.max_violation, milliseconds);
  std::fflush(stdout);
}

void print(const char* what, Tally& tally) {
  std::sort(tally.steps.begin(), tally.steps.end());
  const auto quantile = [&](double share) {
    const double last = static_cast<double>(tally.steps.size()) - 1;
    return tally.steps.empty() ? 0 : tally.steps[static_cast<size_t>(share * last + 0.5)];
  };
  std::printf("%s: %zu converged, %d not; steps: median %d, 90 %% %d, most %d\n", what,
              tally.steps.size(), tally.failed, quantile(0.5), quantile(0.9), quantile(1));
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "usage: nonlinear_survey VERTICES FIRST_SEED LAST_SEED LAMBDA_BND...\n");
    return 2;
  }
  std::printf("seed,lambda_bnd,mixed,status,steps,residual,violation,ms\n");
  for (int k = 4; k < argc; ++k) {
    relievo::Tally tallies[2];
    for (int seed = std::atoi(argv[2]); seed <= std::atoi(argv[3]); ++seed)
      relievo::survey(static_cast<uint64_t>(seed), std::atoi(argv[1]), std::atof(argv[k]), tallies);
    std::printf("lambda_bnd %s\n", argv[k]);
    relievo::print("  of one sign", tallies[0]);
    relievo::print("  joining d > 0 and d < 0", tallies[1]);
  }
  return 0;
}
