#include "understanding/labels/drawing_evidence.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "kernel/image/compose.h"

namespace relievo::understanding {
namespace {

constexpr int border_reach = 3;  ///< px that are looked at on either side of a border
/// A channel varies by at most this share of its largest value where nothing is drawn,
constexpr double plain_share = 0.12;
/// and this more, of 255.
constexpr double grain = 6;
constexpr int darkest_paint = 60;    ///< of 255; ink is not visible beside darker paint
constexpr double open_share = 0.7;   ///< least share of an open border at which nothing is drawn
constexpr int least_pairs = 8;       ///< least length of an open border, pixel sides
constexpr double ink_share = 0.65;   ///< brightness of ink over that of its label, at most
constexpr double widest_ink = 0.03;  ///< of the diagonal
/// Median ratio of a line's width to its length along rows and columns.
constexpr double slant = 0.85;

/// A row or column of pixels, in either direction.
struct Scan {
  ptrdiff_t first = 0;
  ptrdiff_t step = 0;
  int count = 0;

  ptrdiff_t pixel(int k) const { return first + k * step; }
};

/// All rows and columns, and where `both_ways` their reverses.
std::vector<Scan> all_scans(const Image16& labels, bool both_ways) {
  const ptrdiff_t w = labels.width;
  const ptrdiff_t h = labels.height;
  std::vector<Scan> scans;
  for (ptrdiff_t y = 0; y < h; ++y) {
    scans.push_back({y * w, 1, labels.width});
    if (both_ways) scans.push_back({y * w + w - 1, -1, labels.width});
  }
  for (ptrdiff_t x = 0; x < w; ++x) {
    scans.push_back({x, w, labels.height});
    if (both_ways) scans.push_back({(h - 1) * w + x, -w, labels.height});
  }
  return scans;
}

/// Whether nothing is drawn on the pixels `begin` to before `end` of a scan.
bool is_plain(const Image8& rgba, const Scan& scan, int begin, int end) {
  int brightest = 0;
  for (int c = 0; c < 3; ++c) {
    int low = 255;
    int high = 0;
    for (int k = begin; k < end; ++k) {
      const uint8_t* pixel = &rgba.pixels[4 * scan.pixel(k)];
      const int value = on_paper(pixel[c], pixel[3]);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    brightest = std::max(brightest, high);
    if (high - low > grain + plain_share * high) return false;
  }
  return brightest > darkest_paint;
}

std::vector<std::pair<PartLabel, PartLabel>> open_borders(const Image8& rgba,
                                                          const Image16& labels) {
  std::map<std::pair<PartLabel, PartLabel>, std::array<int, 2>> borders;  // all sides, open ones
  for (const Scan& scan : all_scans(labels, false))
    for (int k = 1; k < scan.count; ++k) {
      const PartLabel a = labels.pixels[scan.pixel(k - 1)];
      const PartLabel b = labels.pixels[scan.pixel(k)];
      if (a == b || a == 0 || b == 0) continue;
      auto& [all, open] = borders[std::minmax(a, b)];
      const int begin = std::max(0, k - border_reach);
      const int end = std::min(scan.count, k + border_reach);
      ++all;
      open += is_plain(rgba, scan, begin, end) ? 1 : 0;
    }
  std::vector<std::pair<PartLabel, PartLabel>> pairs;
  for (const auto& [pair, sides] : borders)
    if (sides[0] >= least_pairs && sides[1] >= open_share * sides[0]) pairs.push_back(pair);
  return pairs;
}

/// The median over a histogram, 0 where that is empty.
double median(const std::vector<int64_t>& counts) {
  int64_t all = 0;
  for (const int64_t count : counts) all += count;
  int64_t below = 0;
  for (size_t value = 0; value < counts.size(); ++value)
    if ((below += counts[value]) * 2 >= all && all > 0) return static_cast<double>(value);
  return 0;
}

double rim_width(const Image8& rgba, const Image16& labels,
                 const std::vector<std::array<double, 3>>& colours) {
  std::vector<double> darkest;  // per label, the brightness up to which its pixels are ink
  for (const auto& colour : colours)
    darkest.push_back(ink_share * *std::max_element(colour.begin(), colour.end()));
  const auto is_ink = [&](ptrdiff_t i, PartLabel label) {
    const uint8_t* pixel = &rgba.pixels[4 * i];
    return labels.pixels[i] == label &&
           on_paper(std::max({pixel[0], pixel[1], pixel[2]}), pixel[3]) < darkest[label];
  };
  const int widest = static_cast<int>(widest_ink * std::hypot(labels.width, labels.height)) + 1;
  std::vector<int64_t> counts(static_cast<size_t>(widest), 0);  // by the width of the ink
  for (const Scan& scan : all_scans(labels, true))
    for (int k = 1; k < scan.count; ++k) {
      const PartLabel label = labels.pixels[scan.pixel(k)];
      if (label == 0 || labels.pixels[scan.pixel(k - 1)] != 0) continue;
      int width = 0;
      while (k + width < scan.count && width < widest && is_ink(scan.pixel(k + width), label))
        ++width;
      const bool inside = k + width < scan.count && labels.pixels[scan.pixel(k + width)] == label;
      if (inside && width < widest) ++counts[width];
    }
  return slant * median(counts) / 2;
}

/// Measures how far labels are seen in front of their neighbours (see DrawingEvidence::front): the
/// mean, over the pixel sides of their border, of the way to the front across them. O(pixels).
std::map<std::pair<PartLabel, PartLabel>, double> measure_front(const Image16& labels,
                                                                const FrontMap& front) {
  std::map<std::pair<PartLabel, PartLabel>, std::pair<double, int>> sums;
  const auto add = [&](int x, int y, int dx, int dy) {
    const PartLabel a = labels.at(x, y);
    const PartLabel b = labels.at(x + dx, y + dy);
    if (a == b || a == 0 || b == 0) return;
    const auto cell = [&](double at, int cells) {
      return std::clamp(static_cast<int>(at / front.cell), 0, cells - 1);
    };
    const int u = cell(x + 0.5 * (1 + dx), front.way.width);
    const int v = cell(y + 0.5 * (1 + dy), front.way.height);
    const double to_b = dx * double{front.way.at(u, v, 0)} + dy * double{front.way.at(u, v, 1)};
    auto& [sum, sides] = sums[std::minmax(a, b)];
    sum += a < b ? -to_b : to_b;
    ++sides;
  };
  for (int y = 0; y < labels.height && !front.way.empty(); ++y)
    for (int x = 0; x < labels.width; ++x) {
      if (x + 1 < labels.width) add(x, y, 1, 0);
      if (y + 1 < labels.height) add(x, y, 0, 1);
    }
  std::map<std::pair<PartLabel, PartLabel>, double> means;
  for (const auto& [pair, sum] : sums) means[pair] = sum.first / sum.second;
  return means;
}

}  // namespace

bool DrawingEvidence::is_open(PartLabel a, PartLabel b) const {
  return std::binary_search(open.begin(), open.end(),
                            std::pair<PartLabel, PartLabel>(std::minmax(a, b)));
}

double DrawingEvidence::front_of(PartLabel a, PartLabel b) const {
  const auto found = front.find({a, b});
  return found != front.end() ? found->second : 0;
}

DrawingEvidence measure_evidence(const Image8& rgba, const Image16& labels, const FrontMap& front) {
  assert(rgba.width == labels.width && rgba.height == labels.height);
  DrawingEvidence evidence;
  evidence.colours = label_colours(rgba, labels);
  evidence.open = open_borders(rgba, labels);
  evidence.front = measure_front(labels, front);
  evidence.rim = rim_width(rgba, labels, evidence.colours);
  return evidence;
}

}  // namespace relievo::understanding
