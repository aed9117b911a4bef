// Measures the regions of pictures whose parts are known: relievo-regions < LIST. Each line of the
// list has a picture and a grey PNG file with the true part of each pixel, 0 outside the figure,
// separated by a tab. Each line of the output has "pair" or "region", the picture's number, a
// weight, 1 where the pair is one part or the region belongs to the figure, and the features.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/image/decode_image.h"
#include "io/image/png.h"
#include "relievo/files.h"
#include "understanding/areas/find_basins.h"
#include "understanding/areas/region_features.h"
#include "understanding/perception/built_in_network.h"

namespace relievo {
namespace {

using namespace understanding;

/// Per basin, the pixels of each true part.
using Overlaps = std::vector<std::map<int, int64_t>>;

Overlaps overlaps_of(const Basins& basins, const Image16& truth) {
  Overlaps overlaps(basins.basins.size());
  for (int y = 0; y < basins.index.height; ++y)
    for (int x = 0; x < basins.index.width; ++x) {
      const int u = static_cast<int>((x + 0.5) * truth.width / basins.index.width);
      const int v = static_cast<int>((y + 0.5) * truth.height / basins.index.height);
      ++overlaps[basins.index.at(x, y)][truth.at(u, v)];
    }
  return overlaps;
}

/// The true part of a region and the share of its pixels that belong to it.
std::pair<int, double> part_of(const std::map<int, int64_t>& overlaps) {
  int64_t all = 0;
  std::pair<int, int64_t> best = {0, -1};
  for (const auto& [part, pixels] : overlaps) {
    all += pixels;
    if (pixels > best.second) best = {part, pixels};
  }
  return {best.first, static_cast<double>(best.second) / static_cast<double>(all)};
}

template <class Features>
void write_row(const char* kind, int picture, double weight, bool truth, const Features& features) {
  std::printf("%s\t%d\t%.3f\t%d", kind, picture, weight, truth ? 1 : 0);
  for (const double feature : features) std::printf("\t%.4g", feature);
  std::printf("\n");
}

void write_regions(int picture, RegionMerging& regions, const DrawingMeasure& drawing,
                   const Overlaps& overlaps) {
  for (int r = 0; r < regions.count(); ++r) {
    if (!regions.is_region(r) || regions.region(r).area == 0) continue;
    const auto [part, purity] = part_of(overlaps[r]);
    const double share = static_cast<double>(regions.region(r).area) / drawing.picture;
    write_row("region", picture, purity * purity * std::sqrt(share), part > 0,
              features_of(regions, drawing, r));
  }
}

/// Unites the basins that are one part, those between which the weakest contours run first, and
/// writes all pairs of regions on the way, and the regions before and after.
void write_drawing(int picture, const Basins& basins, Overlaps overlaps) {
  RegionMerging regions(basins);
  const DrawingMeasure drawing = measure_drawing(basins);
  write_regions(picture, regions, drawing, overlaps);
  Merger merger(regions, [&](int a, int b) {
    const auto [part_a, purity_a] = part_of(overlaps[a]);
    const auto [part_b, purity_b] = part_of(overlaps[b]);
    const PairFeatures features = features_of(regions, drawing, a, b);
    const auto smaller =
        static_cast<double>(std::min(regions.region(a).area, regions.region(b).area));
    const double purity = std::min(purity_a, purity_b);
    const double weight = purity * purity * std::min(1.0, std::sqrt(20 * smaller / drawing.figure));
    write_row("pair", picture, weight, part_a == part_b, features);
    return part_a == part_b ? 1 - features[static_cast<size_t>(PairFeature::near_contour)] : -1;
  });
  while (const auto united = merger.unite_next())
    for (const auto& [part, pixels] : overlaps[united->b]) overlaps[united->a][part] += pixels;
  write_regions(picture, regions, drawing, overlaps);
}

/// Returns false where a file cannot be read.
bool add_picture(int number, const std::string& picture, const std::string& truth) {
  const auto bytes = read_file(picture);
  const auto true_bytes = read_file(truth);
  if (!bytes || !true_bytes) return false;
  auto decoded = decode_fitted(*bytes);
  const auto parts = decode_png_values(*true_bytes);
  if (!decoded || !parts) return false;
  const Drawing drawing{std::move(decoded->rgba)};
  const auto basins = find_basins(drawing, built_in_network());
  if (basins) write_drawing(number, *basins, overlaps_of(*basins, *parts));
  return true;
}

}  // namespace
}  // namespace relievo

int main() {
  std::string line;
  for (int number = 0; std::getline(std::cin, line); ++number) {
    const size_t tab = line.find('\t');
    if (tab == std::string::npos ||
        !relievo::add_picture(number, line.substr(0, tab), line.substr(tab + 1))) {
      std::cerr << "relievo-regions: cannot read \"" << line << "\"\n";
      return 1;
    }
  }
  return 0;
}
