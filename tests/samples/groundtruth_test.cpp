#include "samples/groundtruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "relief/model/relief_maps.h"
#include "relief/pipeline/build_relief.h"
#include "relief/pipeline/propose_scene.h"

namespace relievo {
namespace {

using namespace testing;

/// Where one of two overlapping parts is in front in this share of the overlap, the order is clear.
constexpr double clear_majority = 0.75;

/// A least-squares line from one list of values to another.
struct Fit {
  double scale = 0;
  double offset = 0;
  double correlation = 0;
};

Fit fit(const std::vector<double>& from, const std::vector<double>& to) {
  const auto n = static_cast<double>(from.size());
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (size_t i = 0; i < from.size(); ++i) {
    x += from[i] / n;
    y += to[i] / n;
  }
  for (size_t i = 0; i < from.size(); ++i) {
    xx += (from[i] - x) * (from[i] - x);
    xy += (from[i] - x) * (to[i] - y);
    yy += (to[i] - y) * (to[i] - y);
  }
  return {xy / xx, y - xy / xx * x, xy / std::sqrt(xx * yy)};
}

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

/// Parts that hang on the body at one end only: the drawing does not say how far they point
/// towards the viewer or away.
bool is_limb(const std::string& name) {
  for (const char* word : {"arm", "hand", "leg", "bone", "hip", "foot", "horn", "tail", "beak"})
    if (name.find(word) != std::string::npos) return true;
  return false;
}

class GroundTruth : public ::testing::Test {
 protected:
  void SetUp() override {
    characters_ = true_characters();
    if (characters_.empty()) GTEST_SKIP() << "the characters with known depth are not here";
  }

  static Proposal propose(const TrueCharacter& character) {
    auto proposal = propose_scene(character.labels);
    EXPECT_TRUE(proposal.ok()) << (proposal.ok() ? "" : to_string(proposal.error()));
    return proposal.ok() ? std::move(*proposal) : Proposal();
  }

  std::vector<TrueCharacter> characters_;
};

TEST_F(GroundTruth, PartsAreCompletedToTheirTrueShapes) {
  for (const TrueCharacter& character : characters_) {
    const Proposal proposal = propose(character);
    double sum = 0;
    std::printf("%s\n", character.name.c_str());
    for (const TruePart& part : character.parts) {
      const int index = proposal.regions.part_of(static_cast<uint16_t>(part.label));
      const double ratio = overlap_ratio(proposal.completion.parts[index].shape, part.mask);
      const double seen = overlap_ratio(proposal.regions.visible[index], part.mask);
      std::printf("  %2d %-28s seen %.2f completed %.3f kind %d\n", part.label, part.name.c_str(), seen, ratio, (int)proposal.completion.parts[index].kind);
      sum += ratio;
    }
    const double mean = sum / static_cast<double>(character.parts.size());
    std::printf("  mean %.3f\n", mean);
    EXPECT_GE(mean, 0.9);
  }
}

TEST_F(GroundTruth, ClearPairsAreInTheRightOrder) {
  int right = 0;
  int all = 0;
  for (const TrueCharacter& character : characters_) {
    const Proposal proposal = propose(character);
    int r=0,n=0;
    const auto rank = [&](int label) {
      return proposal.stacking.rank[proposal.regions.part_of(static_cast<uint16_t>(label))];
    };
    for (const TruePair& pair : character.pairs) {
      const double share = pair.a_in_front / (pair.a_in_front + pair.b_in_front);
      if (std::max(share, 1 - share) < clear_majority) continue;
      const bool ordered = (rank(pair.a) > rank(pair.b)) == (share > 0.5);
      if (!ordered)
        std::printf("  %s: %d and %d, %g : %g\n", character.name.c_str(), pair.a, pair.b,
                    pair.a_in_front, pair.b_in_front);
      right += ordered ? 1 : 0;r+=ordered;n++;
      ++all;
    }
    std::printf("%s %d/%d\n",character.name.c_str(),r,n);
  }
  std::printf("%d of %d pairs\n", right, all);
  EXPECT_GE(right, 0.95 * all);
}

TEST_F(GroundTruth, ReliefsHaveTheTrueDepth) {
  for (const TrueCharacter& character : characters_) {
    const Proposal proposal = propose(character);
    ReliefOptions options;
    options.layers.vertex_budget = 20000;
    const auto relief = build_relief(proposal.scene, options);
    ASSERT_TRUE(relief.ok()) << to_string(relief.error());
    const auto maps =
        rasterize_relief(relief->layers, relief->inflation, relief->ordering, proposal.scene,
                         character.labels.width, character.labels.height);
    ASSERT_TRUE(maps.ok());
    std::map<int, std::string> names;
    for (const TruePart& part : character.parts) names[part.label] = part.name;
    std::map<int, std::pair<std::vector<double>, std::vector<double>>> by_part;
    std::vector<double> body, body_truth, all, all_truth;
    for (size_t i = 0; i < maps->height.pixels.size(); ++i) {
      const int label = character.labels.pixels[i];
      if (label == 0 || std::isnan(maps->height.pixels[i])) continue;
      by_part[label].first.push_back(maps->height.pixels[i]);
      by_part[label].second.push_back(character.depth.pixels[i]);
      all.push_back(maps->height.pixels[i]);
      all_truth.push_back(character.depth.pixels[i]);
      if (is_limb(names[label])) continue;
      body.push_back(maps->height.pixels[i]);
      body_truth.push_back(character.depth.pixels[i]);
    }
    const Fit whole = fit(all, all_truth);
    const Fit trunk = fit(body, body_truth);
    for (const auto& [label, lists] : by_part) {
      double error = 0;
      for (size_t i = 0; i < lists.first.size(); ++i)
        error += (trunk.offset + trunk.scale * lists.first[i] - lists.second[i]);
      std::printf("  %2d %-28s %s mean error %7.1f px\n", label, names[label].c_str(), is_limb(names[label]) ? "limb" : "body",
                  error / static_cast<double>(lists.first.size()) / trunk.scale);
    }
    std::printf("%s body %.3f all %.3f\n", character.name.c_str(), trunk.correlation,
                whole.correlation);
    EXPECT_GE(trunk.correlation, 0.9);
  }
}

}  // namespace
}  // namespace relievo
