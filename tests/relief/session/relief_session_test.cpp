#include "relief/session/relief_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "kernel/base/workers.h"
#include "support/random_scene.h"

namespace relievo::relief {
namespace {

using namespace testing;

ReliefOptions options_for(int vertices) {
  ReliefOptions options;
  options.layers.vertex_budget = vertices;
  return options;
}

/// An edit in the editor.
void edit(Random& random, Scene& scene, ReliefOptions& options) {
  const int count = static_cast<int>(scene.parts.size());
  Part& part = scene.parts[random.integer(0, count - 1)];
  const int upper = random.integer(1, count - 1);
  const int lower = random.integer(0, upper - 1);
  switch (random.integer(0, 10)) {
    case 0:
      part.c *= random.uniform(0.5, 2);
      return;
    case 1:
      part.d *= random.uniform(0.7, 1.3);
      return;
    case 2:
      options.inflation.alpha0 = random.uniform(0.05, 0.9);
      return;
    case 3:
      options.inflation.rho = random.uniform(0.1, 0.5);
      return;
    case 4:
      scene.relations.push_back(
          {upper, lower, static_cast<RelationKind>(random.integer(0, 2)), std::nullopt});
      return;
    case 5:
      if (!scene.relations.empty()) scene.relations.pop_back();
      return;
    case 6:
      part.flat = random.uniform(0, 1);
      return;
    case 7:
      part.lean = {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
      return;
    case 8:
      if (!scene.joins.empty()) scene.joins.pop_back();
      return;
    case 9: {
      const Ring& ring = scene.parts[upper].outline[0];
      const std::pair range{ring[0], ring[ring.size() / 2]};
      scene.relations.push_back({upper, lower, RelationKind::below, range});
      return;
    }
    default:
      for (Ring& ring : part.outline)
        for (Point2& p : ring) p = p + Point2{1.5, -0.75};
  }
}

void expect_same_contacts(const std::vector<DepthContact>& a, const std::vector<DepthContact>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].position, b[i].position);
    EXPECT_EQ(a[i].closed, b[i].closed) << i;
  }
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

TEST(ReliefSession, IsAsIfBuiltFromScratchAfterEveryEdit) {
  for (const uint64_t seed : {1, 2, 5, 9, 12}) {
    Random random(seed + 100);
    Scene scene = random_scene(seed);
    ReliefOptions options = options_for(4000);
    ReliefSession warm;
    ASSERT_TRUE(warm.update(scene, options));
    for (int step = 0; step < 8; ++step) {
      edit(random, scene, options);
      ReliefSession cold(ReliefSession::Use::one);
      const Status expected = cold.update(scene, options);
      const Status status = warm.update(scene, options);
      ASSERT_EQ(status.ok(), expected.ok()) << seed << " " << step;
      if (!status) continue;
      EXPECT_EQ(warm.relief().layers.faces, cold.relief().layers.faces);
      expect_same_contacts(warm.contacts(), cold.contacts());
      EXPECT_LE(largest_difference(warm.relief().ordering.h, cold.relief().ordering.h), 1e-9)
          << seed << " " << step;
      EXPECT_EQ(warm.relief().inflation.u, cold.relief().inflation.u);
      EXPECT_LE(warm.relief().ordering.report.stationarity, 1e-12);
    }
  }
}

std::multiset<std::string> stages(const ReliefSession& session) {
  std::multiset<std::string> names;
  for (const StageTime& time : session.relief().times) names.insert(time.stage);
  return names;
}

TEST(ReliefSession, ComputesOnlyWhatDependsOnTheEdit) {
  Scene scene = body_and_leg();
  scene.parts.push_back(part("ball", circle({120, 120}, 30)));
  ReliefOptions options = options_for(4000);
  ReliefSession session;
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session).count("mesh"), 2u);

  ASSERT_TRUE(session.update(scene, options));
  EXPECT_TRUE(stages(session).empty());

  scene.parts[2].c *= 1.1;
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session), (std::multiset<std::string>{"inflate", "order", "hide"}));
  EXPECT_LE(session.relief().ordering.report.factorisations, 2);

  scene.parts[0].lean = {0.2, -0.1};
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session), (std::multiset<std::string>{"order", "hide"}));
  EXPECT_LE(session.relief().ordering.report.factorisations, 4);

  scene.cues.push_back({0, CueKind::slope, {{120, 160}, {170, 160}}, 20});
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session), (std::multiset<std::string>{"order", "hide"}));

  scene.cues.push_back({0, CueKind::bulge, {{120, 180}, {170, 180}}, 1.5});
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session), (std::multiset<std::string>{"inflate", "order", "hide"}));

  scene.cues.push_back({2, CueKind::crease, {{100, 120}, {140, 120}}, 30});
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session).count("mesh"), 2u);

  scene.cues[2].value = 40;
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session), (std::multiset<std::string>{"order", "hide"}));
  const Result<Relief> fresh = build_relief(scene, options);
  EXPECT_LE(largest_difference(session.relief().ordering.h, fresh->ordering.h), 1e-9);

  scene.relations.push_back({2, 0, RelationKind::above, std::nullopt});
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session).count("mesh"), 1u);
  EXPECT_EQ(stages(session).count("inflate"), 0u);
  EXPECT_EQ(stages(session).count("order"), 1u);

  scene.parts[2].id = "renamed";
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(stages(session).count("mesh"), 2u);
}

TEST(ReliefSession, GoesOnAfterItWasCancelled) {
  const Scene scene = random_scene(5);
  const ReliefOptions options = options_for(3000);
  const Result<Relief> expected = build_relief(scene, options);
  ASSERT_TRUE(expected);
  for (int calls = 0; calls < 6; ++calls) {
    std::atomic<bool> cancel = false;
    int left = calls;
    RunContext context{&cancel};
    context.progress = [&](const char*, double) {
      if (left-- == 0) cancel = true;
    };
    ReliefSession session;
    const Status status = session.update(scene, options, context);
    if (!status) {
      EXPECT_EQ(status.error().code, ErrorCode::interrupted);
    }
    ASSERT_TRUE(session.update(scene, options));
    EXPECT_EQ(session.relief().ordering.h, expected->ordering.h);
  }
}

TEST(ReliefSession, RefusesWhatTheStagesRefuse) {
  Scene scene = body_and_leg();
  const ReliefOptions options = options_for(2000);
  ReliefSession session;
  ASSERT_TRUE(session.update(scene, options));
  Scene broken = scene;
  broken.joins[0].line = {{0, 0}, {1, 0}};
  EXPECT_FALSE(session.update(broken, options));
  ASSERT_TRUE(session.update(scene, options));
  const Result<Relief> expected = build_relief(scene, options);
  EXPECT_EQ(session.relief().ordering.h, expected->ordering.h);
}

TEST(ReliefSession, SwitchesBetweenTheMethods) {
  const Scene scene = body_and_leg();
  ReliefOptions options = options_for(1500);
  ReliefSession session;
  ASSERT_TRUE(session.update(scene, options));
  const std::vector<double> approximate = session.relief().ordering.h;
  options.method = Method::nonlinear;
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_GT(session.relief().nonlinear.steps.size(), 0u);
  EXPECT_NE(session.relief().ordering.h, approximate);
  options.method = Method::approximate;
  ASSERT_TRUE(session.update(scene, options));
  EXPECT_EQ(session.relief().ordering.h, approximate);
}

/// Restores the number of workers.
class Workers {
 public:
  explicit Workers(int count) { set_worker_count(count); }
  ~Workers() { set_worker_count(0); }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
};

TEST(ReliefSession, TheNonlinearMethodBeginsWhereItEnded) {
  Scene scene = body_and_leg();
  ReliefOptions options = options_for(4000);
  options.method = Method::nonlinear;
  options.nonlinear.tolerance = 3e-5;  // by default, energies agree only to 1e-6
  ReliefSession session;
  ASSERT_TRUE(session.update(scene, options).ok());
  const size_t first = session.relief().nonlinear.steps.size();
  scene.parts[1].c *= 1.02;
  ASSERT_TRUE(session.update(scene, options).ok());
  const NonlinearReport& warm = session.relief().nonlinear;
  EXPECT_EQ(warm.status, SolveStatus::solved);
  EXPECT_LT(warm.steps.size(), first);
  EXPECT_LT(warm.steps[0].residual, 0.1);
  const Result<Relief> cold = build_relief(scene, options);
  ASSERT_TRUE(cold.ok());
  EXPECT_NEAR(warm.energy.total(), cold->nonlinear.energy.total(), 1e-7 * warm.energy.total());
  for (size_t n = 0; n < cold->ordering.h.size(); ++n)
    EXPECT_NEAR(session.relief().ordering.h[n], cold->ordering.h[n], 1e-2);
}

TEST(ReliefSession, TheNonlinearMethodBeginsFromACoarserMesh) {
  ReliefOptions options = options_for(16000);
  options.method = Method::nonlinear;
  options.layers.attach = false;  // as in the paper
  const Scene scene = body_and_leg();
  const Result<Relief> guessed = build_relief(scene, options);
  ReliefSession plain(ReliefSession::Use::guess);
  ASSERT_TRUE(guessed.ok() && plain.update(scene, options).ok());
  const NonlinearReport& unguessed = plain.relief().nonlinear;
  EXPECT_LT(guessed->nonlinear.steps.size(), unguessed.steps.size());
  EXPECT_NEAR(guessed->nonlinear.energy.total(), unguessed.energy.total(),
              1e-7 * unguessed.energy.total());
}

TEST(Determinism, ThreadsChangeNoBit) {
  const Scene scene = random_scene(11);
  const ReliefOptions options = options_for(12000);
  const auto build = [&](int workers) {
    const Workers set(workers);
    return build_relief(scene, options);
  };
  const Result<Relief> one = build(1);
  ASSERT_TRUE(one);
  for (const int workers : {2, 3, 8}) {
    const Result<Relief> many = build(workers);
    ASSERT_TRUE(many);
    EXPECT_EQ(one->ordering.h, many->ordering.h);
    EXPECT_EQ(one->inflation.u, many->inflation.u);
    EXPECT_EQ(one->ordering.grad_g, many->ordering.grad_g);
  }
}

TEST(Determinism, TwentyRunsGiveTheSameBits) {
  const Scene scene = random_scene(8);
  const ReliefOptions options = options_for(5000);
  const Workers set(2);
  const Result<Relief> first = build_relief(scene, options);
  ASSERT_TRUE(first);
  for (int run = 1; run < 20; ++run)
    EXPECT_EQ(build_relief(scene, options)->ordering.h, first->ordering.h) << run;
}

}  // namespace
}  // namespace relievo::relief
