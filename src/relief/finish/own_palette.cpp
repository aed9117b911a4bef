#include "relief/finish/own_palette.h"

#include <algorithm>
#include <array>
#include <vector>

#include "kernel/image/compose.h"
#include "relief/finish/fill_triangle.h"
#include "relief/finish/spread_colours.h"

namespace relievo::relief {
namespace {

constexpr int least_alpha = 128;
constexpr size_t most_colours = 256;

using PaletteColour = std::array<float, 3>;

double palette_distance(const PaletteColour& a, const PaletteColour& b) {
  double sum = 0;
  for (size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

/// Counts the pixels of each square that a model covers.
Image<int32_t> covered_pixels(const Model& model, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  const int side = drawing.pixel_art;
  const Image8 open = uncovered_pixels(model, {rgba.width, rgba.height});
  Image<int32_t> covered((rgba.width + side - 1) / side, (rgba.height + side - 1) / side, 1);
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) covered.at(x / side, y / side) += 1 - open.at(x, y);
  return covered;
}

}  // namespace

void extend_own_pixels(const Model& model, Drawing& drawing) {
  Image8& rgba = drawing.rgba;
  const int side = drawing.pixel_art;
  const Image<int32_t> covered = covered_pixels(model, drawing);
  Image8 known(covered.width, covered.height, 1);
  Image8 colours(covered.width, covered.height, 3, 255);
  for (int y = 0; y < known.height; ++y)
    for (int x = 0; x < known.width; ++x) {
      const uint8_t* p = &rgba.at(side * x, side * y);
      if (p[3] < least_alpha || 2 * covered.at(x, y) < side * side) continue;
      known.at(x, y) = 1;
      for (int c = 0; c < 3; ++c) colours.at(x, y, c) = on_paper(p[c], p[3]);
    }
  spread_colours(known, colours);
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      std::copy_n(&colours.at(x / side, y / side), 3, &rgba.at(x, y));
      rgba.at(x, y, 3) = 255;
    }
}

void keep_palette(const ImageF& seen, ImageF& filled) {
  std::vector<PaletteColour> palette;
  for (size_t i = 0; i < seen.pixels.size(); i += 4) {
    const PaletteColour colour{seen.pixels[i], seen.pixels[i + 1], seen.pixels[i + 2]};
    if (palette.size() > most_colours) break;
    if (seen.pixels[i + 3] > 0 &&
        std::find(palette.begin(), palette.end(), colour) == palette.end())
      palette.push_back(colour);
  }
  if (palette.empty() || palette.size() > most_colours) return;
  for (size_t i = 0; i < filled.pixels.size(); i += 3) {
    const PaletteColour smooth{filled.pixels[i], filled.pixels[i + 1], filled.pixels[i + 2]};
    const auto nearest = std::min_element(
        palette.begin(), palette.end(), [&smooth](const PaletteColour& a, const PaletteColour& b) {
          return palette_distance(a, smooth) < palette_distance(b, smooth);
        });
    std::copy_n(nearest->begin(), 3, filled.pixels.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace relievo::relief
