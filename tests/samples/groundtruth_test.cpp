#include "samples/groundtruth.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "relief/maps/relief_maps.h"
#include "relief/session/build_relief.h"
#include "understanding/scene/propose_scene.h"

namespace relievo {
namespace {

using namespace testing;

/// Where one of two overlapping parts is in front in this share of the overlap, the order is clear.
constexpr double clear_majority = 0.75;
/// Of what is hidden further the drawing tells little.
constexpr double well_seen = 1.0 / 3;

double overlap_ratio(const Mask& shape, const Image8& truth) {
  double both = 0;
  double either = 0;
  for (int y = 0; y < truth.height; ++y)
    for (int x = 0; x < truth.width; ++x) {
      const bool here = shape.has(x, y);
      const bool there = truth.at(x, y) != 0;
      both += here && there ? 1 : 0;
      either += here || there ? 1 : 0;
    }
  return both / either;
}

/// The three characters without patches on their bodies.
bool is_plain(const TrueCharacter& character) {
  return character.name.find("simple") != std::string::npos;
}

/// Turned by 35 degrees to the left, so that the right side of the body is nearer.
bool is_turned(const TrueCharacter& character) {
  return character.name.find("yaw35") != std::string::npos;
}

/// Parts that hang on the body at one end only: the drawing does not say how far they point
/// towards the viewer or away.
bool is_limb(const std::string& name) {
  for (const char* word : {"arm", "hand", "leg", "bone", "hip", "foot", "horn", "tail", "beak"})
    if (name.find(word) != std::string::npos) return true;
  return false;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Heights of the relief and the true ones at the same pixels.
struct DepthSamples {
  std::vector<Point2> at;  ///< px
  std::vector<double> relief;
  std::vector<double> truth;
};

/// The best truth ~ scale * relief + offset, and a slope from left to right where `tilt` is set.
struct DepthFit {
  Eigen::Vector3d coefficients;  ///< scale, offset, slope
  double correlation = 0;        ///< of the truth with what is fitted
};

DepthFit fit_depth(const DepthSamples& samples, bool tilt) {
  const auto n = static_cast<Eigen::Index>(samples.at.size());
  Eigen::MatrixXd A(n, tilt ? 3 : 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    A(i, 0) = samples.relief[i];
    A(i, 1) = 1;
    if (tilt) A(i, 2) = samples.at[i].x;
  }
  const Eigen::Map<const Eigen::VectorXd> truth(samples.truth.data(), n);
  const Eigen::VectorXd solution = A.colPivHouseholderQr().solve(truth);
  const double rest = (truth - A * solution).squaredNorm();
  const double all = (truth.array() - truth.mean()).matrix().squaredNorm();
  DepthFit fit{Eigen::Vector3d::Zero(), std::sqrt(1 - rest / all)};
  fit.coefficients.head(solution.size()) = solution;
  return fit;
}

/// How much too high the relief is, px of the relief.
std::vector<double> height_errors(const DepthSamples& samples, const DepthFit& fit) {
  std::vector<double> error;
  for (size_t i = 0; i < samples.at.size(); ++i)
    error.push_back(
        (fit.coefficients[0] * samples.relief[i] + fit.coefficients[1] - samples.truth[i]) /
        fit.coefficients[0]);
  return error;
}

/// Share of the variance of the body's true depth that these errors leave unexplained.
double unexplained_share(const std::vector<double>& error, const DepthFit& fit,
                         const DepthSamples& body) {
  const double middle = mean(body.truth);
  double all = 0;
  for (const double value : body.truth) all += (value - middle) * (value - middle);
  double sum = 0;
  for (const double value : error) sum += value * value;
  return fit.coefficients[0] * fit.coefficients[0] * sum / all;
}

class GroundTruth : public ::testing::Test {
 protected:
  void SetUp() override {
    characters_ = true_characters();
    if (characters_.empty()) GTEST_SKIP() << "the characters with known depth are not here";
  }

  static understanding::Proposal propose(const TrueCharacter& character) {
    auto proposal = understanding::propose_scene(character.labels);
    EXPECT_TRUE(proposal.ok()) << (proposal.ok() ? "" : to_string(proposal.error()));
    return proposal.ok() ? std::move(*proposal) : understanding::Proposal();
  }

  static ReliefMaps relief_maps(const TrueCharacter& character, const Scene& scene) {
    relief::ReliefOptions options;
    options.layers.vertex_budget = 20000;
    const auto relief = relief::build_relief(scene, options);
    EXPECT_TRUE(relief.ok()) << (relief.ok() ? "" : to_string(relief.error()));
    if (!relief.ok()) return {};
    auto maps =
        relief::rasterize_relief({relief->layers, relief->inflation, relief->ordering, scene},
                                 character.labels.width, character.labels.height);
    EXPECT_TRUE(maps.ok());
    return maps.ok() ? std::move(*maps) : ReliefMaps();
  }

  std::vector<TrueCharacter> characters_;
};

TEST_F(GroundTruth, PartsAreCompletedToTheirTrueShapes) {
  std::vector<double> all;
  std::vector<double> plain;
  std::vector<double> seen_well;
  for (const TrueCharacter& character : characters_) {
    const understanding::Proposal proposal = propose(character);
    std::printf("%s\n", character.name.c_str());
    for (const TruePart& part : character.parts) {
      const int index = proposal.regions.part_of(static_cast<uint16_t>(part.label));
      const double seen = overlap_ratio(proposal.regions.visible[index], part.mask);
      const double ratio = overlap_ratio(proposal.completion[index].shape, part.mask);
      std::printf("  %2d %-26s seen %.2f, completed %.2f\n", part.label, part.name.c_str(), seen,
                  ratio);
      all.push_back(ratio);
      if (is_plain(character)) plain.push_back(ratio);
      if (seen >= well_seen) seen_well.push_back(ratio);
    }
  }
  std::printf("mean %.3f of %zu parts, %.3f of %zu of plain characters, %.3f of %zu well seen\n",
              mean(all), all.size(), mean(plain), plain.size(), mean(seen_well), seen_well.size());
  EXPECT_GE(mean(all), 0.9);
  EXPECT_GE(mean(plain), 0.9);
  EXPECT_GE(mean(seen_well), 0.9);
}

TEST_F(GroundTruth, ClearPairsAreInTheRightOrder) {
  int right = 0;
  int all = 0;
  for (const TrueCharacter& character : characters_) {
    const understanding::Proposal proposal = propose(character);
    std::set<std::pair<int, int>> touching;
    for (const understanding::NeighbourEvidence& pair : proposal.evidence)
      touching.insert({pair.a, pair.b});
    for (const TruePair& pair : character.pairs) {
      const double share = pair.a_in_front / (pair.a_in_front + pair.b_in_front);
      const auto a = static_cast<uint16_t>(pair.a);
      const auto b = static_cast<uint16_t>(pair.b);
      if (std::max(share, 1 - share) < clear_majority) continue;
      if (touching.count(std::minmax(pair.a, pair.b)) == 0) continue;
      const bool ordered =
          (proposal.regions.part_of(a) > proposal.regions.part_of(b)) == (share > 0.5);
      if (!ordered)
        std::printf("  %s: %d and %d are in front at %g and %g px\n", character.name.c_str(),
                    pair.a, pair.b, pair.a_in_front, pair.b_in_front);
      right += ordered ? 1 : 0;
      ++all;
    }
  }
  std::printf("%d of %d pairs that touch are in the right order\n", right, all);
  EXPECT_GE(right, 0.95 * all);
}

TEST_F(GroundTruth, TurnedBodiesLeanAndOthersDoNot) {
  for (const TrueCharacter& character : characters_) {
    SCOPED_TRACE(character.name);
    const understanding::Proposal proposal = propose(character);
    EXPECT_EQ(!proposal.joining.leans.empty(), is_turned(character));
    for (const understanding::ProposedLean& proposed : proposal.joining.leans) {
      std::printf("%s: part %d leans by %.3f, confidence %.2f\n", character.name.c_str(),
                  proposal.regions.labels[proposed.part], proposed.lean.x, proposed.confidence);
      EXPECT_GE(proposed.lean.x, 0.12);
      EXPECT_LE(proposed.lean.x, 0.25);
    }
  }
}

TEST_F(GroundTruth, ReliefsHaveTheTrueDepth) {
  for (const TrueCharacter& character : characters_) {
    SCOPED_TRACE(character.name);
    const understanding::Proposal proposal = propose(character);
    const ReliefMaps maps = relief_maps(character, proposal.scene);
    if (maps.height.empty()) continue;
    std::map<int, std::string> names;
    for (const TruePart& part : character.parts) names[part.label] = part.name;
    DepthSamples body;
    std::map<int, DepthSamples> by_part;
    for (int y = 0; y < maps.height.height; ++y)
      for (int x = 0; x < maps.height.width; ++x) {
        const int label = character.labels.at(x, y);
        const double height = maps.height.at(x, y);
        if (label == 0 || std::isnan(height)) continue;
        for (DepthSamples* samples : {&by_part[label], is_limb(names[label]) ? nullptr : &body}) {
          if (samples == nullptr) continue;
          samples->at.push_back({x + 0.5, y + 0.5});
          samples->relief.push_back(height);
          samples->truth.push_back(character.depth.at(x, y));
        }
      }
    const DepthFit plain = fit_depth(body, false);
    const DepthFit tilted = fit_depth(body, true);
    std::printf("%s: correlation %.3f over the body, %.3f without its lean\n",
                character.name.c_str(), plain.correlation, tilted.correlation);
    double unexplained = 0;
    for (const auto& [label, samples] : by_part) {
      const std::vector<double> error = height_errors(samples, plain);
      const double cost = is_limb(names[label]) ? 0 : unexplained_share(error, plain, body);
      unexplained += cost;
      std::printf("  %2d %-26s too high by %6.1f px, costs %.3f\n", label, names[label].c_str(),
                  mean(error), cost);
    }
    EXPECT_NEAR(unexplained, 1 - plain.correlation * plain.correlation, 1e-6);
    EXPECT_GE(plain.correlation, 0.9);
    EXPECT_LE(tilted.correlation, plain.correlation + 0.03) << "its lean is not understood";
  }
}

}  // namespace
}  // namespace relievo
