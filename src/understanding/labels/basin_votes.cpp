#include "understanding/labels/basin_votes.h"

#include <algorithm>

#include "kernel/image/image_size.h"

namespace relievo::understanding {
namespace {

/// A slip is less than one part in so many of a stroke: into another part, out of the figure.
constexpr int64_t slip_fraction = 10;
constexpr int64_t slip_out_fraction = 2;
/// A stroke of which so much lies on lines follows them, and says nothing of the paper beside them.
constexpr double along_lines = 0.2;

bool is_for_background(ScribbleKind kind) {
  return kind == ScribbleKind::outside || kind == ScribbleKind::hole;
}

/// How many pixels of a stroke lie in each region, off the lines.
struct StrokeCounts {
  std::map<int, int64_t> in_region;
  int64_t total = 0;

  bool slipped_into(int region) const {
    return in_region.at(region) * (region == 0 ? slip_out_fraction : slip_fraction) < total;
  }
};

int region_at(const Basins& basins, int32_t pixel) {
  return basins.region[basins.index.pixels[pixel]];
}

/// Marks off the lines; of strokes that lie on lines altogether, those as well. What strokes along
/// lines cover of the background is left out: they are for the ink (see take_ink).
std::vector<MarkedPixel> counted_marks(const Basins& basins, const Scribbles& scribbles) {
  std::vector<MarkedPixel> marks = mark_pixels(scribbles, basins.index.width, basins.index.height);
  const auto on_line = [&](const MarkedPixel& mark) {
    return basins.barrier.pixels[mark.pixel] != 0;
  };
  std::vector<int64_t> on_lines(scribbles.strokes.size(), 0);
  std::vector<int64_t> all(scribbles.strokes.size(), 0);
  for (const MarkedPixel& mark : marks) {
    on_lines[mark.stroke] += on_line(mark) ? 1 : 0;
    ++all[mark.stroke];
  }
  const auto is_for_ink = [&](const MarkedPixel& mark) {
    if (on_line(mark) && on_lines[mark.stroke] < all[mark.stroke]) return true;
    return !is_for_background(scribbles.strokes[mark.stroke].kind) &&
           region_at(basins, mark.pixel) == 0 &&
           static_cast<double>(on_lines[mark.stroke]) >
               along_lines * static_cast<double>(all[mark.stroke]);
  };
  marks.erase(std::remove_if(marks.begin(), marks.end(), is_for_ink), marks.end());
  return marks;
}

/// Background that reaches the picture's edge is background there, whatever strokes for parts lie
/// in it: they divide it, and no part floods the page.
void hold_background_at_edge(const Basins& basins, BasinVotes& votes) {
  std::set<int> stroked;
  for (const BasinVotes::HardPixel& pixel : votes.hard)
    if (pixel.label != 0 && basins.region[pixel.basin] == 0) stroked.insert(pixel.basin);
  if (stroked.empty()) return;
  std::set<int32_t> marked;
  for (const BasinVotes::HardPixel& pixel : votes.hard) marked.insert(pixel.pixel);
  const int w = basins.index.width;
  along_edge(w, basins.index.height, [&](int x, int y) {
    const int32_t pixel = y * w + x;
    const int basin = basins.index.pixels[pixel];
    if (basins.barrier.pixels[pixel] == 0 && stroked.count(basin) > 0 && marked.count(pixel) == 0)
      votes.hard.push_back({pixel, basin, 0});
  });
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
      if (label != 0 && counts[mark.stroke].slipped_into(region)) continue;
      votes.hard.push_back({mark.pixel, basin, label});
    }
    votes.labels_in_region[region].insert(label);
    if (stroke.kind != ScribbleKind::hole) votes.is_hole[region] = false;
  }
  for (size_t r = 0; r < regions; ++r)
    if (votes.labels_in_region[r].empty()) votes.is_hole[r] = false;
  hold_background_at_edge(basins, votes);
  std::sort(votes.hard.begin(), votes.hard.end(), [](const auto& a, const auto& b) {
    return a.basin != b.basin ? a.basin < b.basin : a.pixel < b.pixel;
  });
  return votes;
}

}  // namespace relievo::understanding
