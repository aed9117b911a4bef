#include "relief/drawing/label_colours.h"

#include <algorithm>
#include <cassert>

#include "kernel/image/compose.h"

namespace relievo {
namespace {

constexpr int colour_margin = 3;  ///< px

/// Sum of colours on white, and how many pixels it is of.
struct ColourSum {
  std::array<double, 3> sum = {};
  double pixels = 0;

  void add(const uint8_t* rgba) {
    for (size_t c = 0; c < 3; ++c) sum[c] += on_paper(rgba[c], rgba[3]);
    ++pixels;
  }
};

/// Whether the four pixels at the margin's distance, as far as they are in the picture, have the
/// same label.
bool is_inside(const Image16& labels, int x, int y) {
  const uint16_t own = labels.at(x, y);
  const auto same = [&](int u, int v) {
    return u < 0 || v < 0 || u >= labels.width || v >= labels.height || labels.at(u, v) == own;
  };
  return same(x - colour_margin, y) && same(x + colour_margin, y) && same(x, y - colour_margin) &&
         same(x, y + colour_margin);
}

}  // namespace

std::vector<std::array<double, 3>> label_colours(const Image8& rgba, const Image16& labels) {
  assert(rgba.channels == 4 && rgba.width == labels.width && rgba.height == labels.height);
  if (labels.empty()) return {};
  const size_t count = size_t{*std::max_element(labels.pixels.begin(), labels.pixels.end())} + 1;
  std::vector<ColourSum> inside(count);
  std::vector<ColourSum> whole(count);
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) {
      const uint16_t label = labels.at(x, y);
      whole[label].add(&rgba.at(x, y));
      if (is_inside(labels, x, y)) inside[label].add(&rgba.at(x, y));
    }
  std::vector<std::array<double, 3>> colours(count);
  for (size_t label = 0; label < count; ++label) {
    const ColourSum& used = inside[label].pixels > 0 ? inside[label] : whole[label];
    for (size_t c = 0; c < 3; ++c) colours[label][c] = used.sum[c] / std::max(used.pixels, 1.0);
  }
  return colours;
}

}  // namespace relievo
