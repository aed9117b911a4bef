#include "relief/drawing/basin_votes.h"

#include <algorithm>

namespace relievo {
namespace {

constexpr int64_t slip_fraction = 10;  ///< a slip is less than one part in this many of a stroke

bool is_for_background(ScribbleKind kind) {
  return kind == ScribbleKind::outside || kind == ScribbleKind::hole;
}

/// How many pixels of a stroke lie in each region, off the lines.
struct StrokeCounts {
  std::map<int, int64_t> in_region;
  int64_t total = 0;

  bool slipped_into(int region) const { return in_region.at(region) * slip_fraction < total; }
};

int region_at(const Basins& basins, int32_t pixel) {
  return basins.region[basins.index.pixels[pixel]];
}

/// Marks off the lines; of strokes that lie on lines altogether, all but those on the background,
/// which are for the ink (see take_ink).
std::vector<MarkedPixel> counted_marks(const Basins& basins, const Scribbles& scribbles) {
  std::vector<MarkedPixel> marks = mark_pixels(scribbles, basins.index.width, basins.index.height);
  std::vector<bool> leaves_lines(scribbles.strokes.size(), false);
  const auto on_line = [&](const MarkedPixel& mark) {
    return basins.barrier.pixels[mark.pixel] != 0;
  };
  for (const MarkedPixel& mark : marks)
    if (!on_line(mark)) leaves_lines[mark.stroke] = true;
  marks.erase(std::remove_if(marks.begin(), marks.end(),
                             [&](const MarkedPixel& mark) {
                               return on_line(mark) && (leaves_lines[mark.stroke] ||
                                                        region_at(basins, mark.pixel) == 0);
                             }),
              marks.end());
  return marks;
}

}  // namespace

BasinVotes count_votes(const Basins& basins, const Scribbles& scribbles) {
  const std::vector<MarkedPixel> marks = counted_marks(basins, scribbles);
  std::vector<StrokeCounts> counts(scribbles.strokes.size());
  for (const MarkedPixel& mark : marks) {
    ++counts[mark.stroke].in_region[region_at(basins, mark.pixel)];
    ++counts[mark.stroke].total;
  }
  const size_t regions = static_cast<size_t>(basins.region_count) + 1;
  BasinVotes votes;
  votes.soft.resize(basins.basins.size());
  votes.labels_in_region.resize(regions);
  votes.is_hole.assign(regions, true);
  for (const MarkedPixel& mark : marks) {
    const Scribble& stroke = scribbles.strokes[mark.stroke];
    const int basin = basins.index.pixels[mark.pixel];
    const int region = basins.region[basin];
    const int label = is_for_background(stroke.kind) ? 0 : stroke.part + 1;
    if (stroke.kind == ScribbleKind::soft) {
      ++votes.soft[basin][label];
    } else {
      if (counts[mark.stroke].slipped_into(region)) continue;
      votes.hard.push_back({mark.pixel, basin, label});
    }
    votes.labels_in_region[region].insert(label);
    if (stroke.kind != ScribbleKind::hole) votes.is_hole[region] = false;
  }
  for (size_t r = 0; r < regions; ++r)
    if (votes.labels_in_region[r].empty()) votes.is_hole[r] = false;
  std::stable_sort(votes.hard.begin(), votes.hard.end(),
                   [](const auto& a, const auto& b) { return a.basin < b.basin; });
  return votes;
}

}  // namespace relievo
