#include "understanding/labels/basin_votes.h"

#include <algorithm>

#include "kernel/image/image_size.h"

namespace relievo::understanding {
namespace {

constexpr int64_t slip_fraction = 10;     ///< pixels of a stroke over those of its largest slip
constexpr int64_t slip_out_fraction = 2;  ///< the same for a slip out of the figure
constexpr double along_lines = 0.2;  ///< share of a stroke on lines above which it follows them

int region_at(const Basins& basins, int32_t pixel) {
  return basins.region[basins.index.pixels[pixel]];
}

/// Removes the marks that do not vote: those on lines, unless all of the stroke lies on lines, and
/// those on the background of strokes along lines, which are for the ink (see take_ink).
void remove_silent(const Basins& basins, const Scribbles& scribbles,
                   std::vector<StrokePixel>& marks) {
  const auto on_line = [&](const StrokePixel& mark) {
    return basins.barrier.pixels[mark.pixel] != 0;
  };
  std::vector<int64_t> on_lines(scribbles.strokes.size(), 0);
  std::vector<int64_t> all(scribbles.strokes.size(), 0);
  for (const StrokePixel& mark : marks) {
    on_lines[mark.stroke] += on_line(mark) ? 1 : 0;
    ++all[mark.stroke];
  }
  std::erase_if(marks, [&](const StrokePixel& mark) {
    const int s = mark.stroke;
    if (on_line(mark) && on_lines[s] < all[s]) return true;
    return is_for_part(scribbles.strokes[s].kind) && region_at(basins, mark.pixel) == 0 &&
           static_cast<double>(on_lines[s]) > along_lines * static_cast<double>(all[s]);
  });
}

/// Marks background at the picture's border as such where hard strokes of parts lie in it: they
/// divide it, and no part floods the page.
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

BasinVotes count_votes(const Basins& basins, const Scribbles& scribbles,
                       std::vector<StrokePixel> marks) {
  remove_silent(basins, scribbles, marks);
  std::vector<std::map<int, int64_t>> in_region(scribbles.strokes.size());
  std::vector<int64_t> all(scribbles.strokes.size(), 0);
  for (const StrokePixel& mark : marks) {
    ++in_region[mark.stroke][region_at(basins, mark.pixel)];
    ++all[mark.stroke];
  }
  BasinVotes votes;
  votes.soft.resize(basins.basins.size());
  votes.labels_in_region.resize(static_cast<size_t>(basins.region_count) + 1);
  for (const StrokePixel& mark : marks) {
    const Scribble& stroke = scribbles.strokes[mark.stroke];
    const int basin = basins.index.pixels[mark.pixel];
    const int region = basins.region[basin];
    const int label = stroke.label();
    if (stroke.kind == ScribbleKind::soft) {
      ++votes.soft[basin][label];
    } else {
      const int64_t fraction = region == 0 ? slip_out_fraction : slip_fraction;
      const bool slipped = in_region[mark.stroke][region] * fraction < all[mark.stroke];
      if (label != 0 && slipped) continue;
      votes.hard.push_back({mark.pixel, basin, label});
    }
    votes.labels_in_region[region].insert(label);
  }
  hold_background_at_edge(basins, votes);
  std::sort(votes.hard.begin(), votes.hard.end(), [](const auto& a, const auto& b) {
    return a.basin != b.basin ? a.basin < b.basin : a.pixel < b.pixel;
  });
  return votes;
}

}  // namespace relievo::understanding
