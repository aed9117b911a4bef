#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "io/svg/read_svg.h"
#include "kernel/geometry/polyline.h"
#include "relievo/files.h"
#include "understanding/joins/propose_layer_joins.h"

namespace relievo {
namespace {

understanding::LayeredDrawing sample(const std::string& name) {
  const auto bytes = read_file(std::string(RELIEVO_EXAMPLES) + "/" + name + ".svg");
  EXPECT_TRUE(bytes.ok());
  auto import = read_svg({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  EXPECT_TRUE(import.ok());
  return std::move(*import);
}

/// By how much the ends of two joins differ, either way round, relative to the first one's length.
double end_distance(const std::vector<Point2>& a, const std::vector<Point2>& b) {
  const double straight = distance(a.front(), b.front()) + distance(a.back(), b.back());
  const double crossed = distance(a.front(), b.back()) + distance(a.back(), b.front());
  return std::min(straight, crossed) / 2 / line_length(a);
}

TEST(ProposedJoins, AreMostlyThoseThatTheSamplesAuthorsDrew) {
  size_t drawn = 0;
  size_t proposed = 0;
  std::vector<double> off;
  for (const char* name : {"bunny", "elephant", "farmer", "lamb", "unicorn", "wolf"}) {
    const understanding::LayeredDrawing import = sample(name);
    const Scene& scene = import.scene;
    const understanding::JoinProposals joining =
        understanding::propose_layer_joins(scene, import.colors, import.anchors);
    drawn += scene.joins.size();
    proposed += joining.joins.size();
    for (const Join& join : scene.joins)
      for (const understanding::ProposedJoin& guess : joining.joins)
        if (guess.join.upper == join.upper && guess.join.lower == join.lower)
          off.push_back(end_distance(join.line, guess.join.line));
  }
  std::sort(off.begin(), off.end());
  ASSERT_FALSE(off.empty());
  const double median = off[off.size() / 2];
  const auto near = std::upper_bound(off.begin(), off.end(), 0.1) - off.begin();
  std::cout << "of " << drawn << " joins drawn by hand " << off.size() << " are proposed, among "
            << proposed << "; their ends are off by " << median
            << " of their length in the median, of " << near << " by at most a tenth\n";
  EXPECT_GE(off.size(), drawn * 9 / 10);
  EXPECT_LE(proposed, 42U);
  EXPECT_LE(median, 0.02);
  EXPECT_GE(near, 23);
}

}  // namespace
}  // namespace relievo
