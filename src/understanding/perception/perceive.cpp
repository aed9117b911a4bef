#include "understanding/perception/perceive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernel/base/exact_functions.h"

namespace relievo::understanding {
namespace {

constexpr int longest_side = 512;
/// Sides of the network's input are multiples of this, so that each level halves the one above.
constexpr int unit = 32;
constexpr size_t levels = 5;
// Positions of layers: after two for each level comes a third for the deepest one, then the
// context.
constexpr size_t deepest = 2 * levels;
constexpr size_t context = deepest + 1;
constexpr size_t layer_count = context + 2 * levels;

/// Returns the first pixel that cell `k` of `cells` covers, and the one after its last: all that
/// begin in it, or where cells are smaller than pixels the one that it lies in.
std::pair<int, int> pixels_of(int k, int cells, int pixels) {
  if (cells >= pixels) return {k * pixels / cells, k * pixels / cells + 1};
  const auto first = [&](int64_t cell) {
    return static_cast<int>((cell * pixels + cells - 1) / cells);
  };
  return {first(k), first(k + 1)};
}

/// Averages the pixels of a picture on white, with their alpha, over the cells of a grid.
ImageF scaled(const Image8& rgba, int width, int height) {
  ImageF means(width, height, 4);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const auto [x0, x1] = pixels_of(u, width, rgba.width);
      const auto [y0, y1] = pixels_of(v, height, rgba.height);
      float* mean = &means.at(u, v);
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
          const float alpha = static_cast<float>(rgba.at(x, y, 3)) / 255;
          for (int c = 0; c < 3; ++c)
            mean[c] += alpha * static_cast<float>(rgba.at(x, y, c)) / 255 + (1 - alpha);
          mean[3] += alpha;
        }
      const auto count = static_cast<float>((x1 - x0) * (y1 - y0));
      for (int c = 0; c < 4; ++c) mean[c] /= count;
    }
  return means;
}

/// Extends an image to the right and below by its last pixels.
ImageF extended(const ImageF& image, int width, int height) {
  ImageF result(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < image.channels; ++c)
        result.at(x, y, c) =
            image.at(std::min(x, image.width - 1), std::min(y, image.height - 1), c);
  return result;
}

/// Concatenates the channels of `a` with those of `b`, each pixel of which covers 2 x 2 of `a`.
ImageF joined(const ImageF& a, const ImageF& b) {
  ImageF result(a.width, a.height, a.channels + b.channels);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      std::copy_n(&a.at(x, y), a.channels, &result.at(x, y));
      std::copy_n(&b.at(x / 2, y / 2), b.channels, &result.at(x, y, a.channels));
    }
  return result;
}

/// Adds to every pixel a layer's value of the mean over the image.
ImageF with_context(ImageF image, const NetworkLayer& layer) {
  ImageF mean(1, 1, image.channels);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    mean.pixels[i % image.channels] += image.pixels[i];
  const auto count = static_cast<float>(image.width) * static_cast<float>(image.height);
  for (float& value : mean.pixels) value /= count;
  const ImageF added = convolve(mean, layer);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = std::clamp(image.pixels[i] + added.pixels[i % image.channels], 0.0F, 6.0F);
  return image;
}

/// Returns whether the layers have the channels that `apply_layers` needs.
bool fits(const Network& network) {
  if (network.size() != layer_count) return false;
  const auto outputs = [&](size_t k) { return network[k].outputs; };
  const auto takes = [&](size_t k, int inputs) { return network[k].inputs == inputs; };
  bool good = takes(0, 4) && outputs(layer_count - 1) == 4;
  for (size_t k = 1; k <= context; ++k) good = good && takes(k, outputs(k - 1));
  good = good && outputs(context) == outputs(deepest);
  int below = outputs(context);
  for (size_t level = levels - 1, k = context + 1; level-- > 0; k += 2) {
    good = good && takes(k, below) && takes(k + 1, outputs(2 * level + 1) + outputs(k));
    below = outputs(k + 1);
  }
  return good && takes(layer_count - 1, below);
}

/// Applies a network of the form of a U: `levels` times two layers, the first of which halves the
/// resolution; the context of the whole image; and back up, where each level is joined with the one
/// of its size.
ImageF apply_layers(const Network& network, const ImageF& image) {
  std::array<ImageF, levels> down;
  for (size_t level = 0; level < levels; ++level)
    down[level] = convolve(convolve(level == 0 ? image : down[level - 1], network[2 * level]),
                           network[2 * level + 1]);
  ImageF up = with_context(convolve(down.back(), network[deepest]), network[context]);
  for (size_t level = levels - 1, k = context + 1; level-- > 0; k += 2)
    up = convolve(joined(down[level], convolve(up, network[k])), network[k + 1]);
  return convolve(up, network.back());
}

/// Returns the probabilities, of 255, of a channel with log-odds.
Image8 probabilities(const ImageF& log_odds, int channel, int width, int height) {
  Image8 result(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      result.at(x, y) = static_cast<uint8_t>(
          std::lround(255 / (1 + exact::exp(-double{log_odds.at(x, y, channel)}))));
  return result;
}

/// Returns the two channels from the third on.
ImageF directions(const ImageF& seen, int width, int height) {
  ImageF result(width, height, 2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) std::copy_n(&seen.at(x, y, 2), 2, &result.at(x, y));
  return result;
}

}  // namespace

Result<Perception> perceive(const Image8& rgba, const Network& network) {
  if (!fits(network))
    return Error{ErrorCode::bad_input, "the network has other layers than expected", ""};
  const double scale = static_cast<double>(longest_side) / std::max(rgba.width, rgba.height);
  const auto scaled_to = [scale](int length) {
    return std::max(1, static_cast<int>(std::lround(scale * length)));
  };
  const int w = scaled_to(rgba.width);
  const int h = scaled_to(rgba.height);
  const auto whole = [](int length) { return (length + unit - 1) / unit * unit; };
  const ImageF seen = apply_layers(network, extended(scaled(rgba, w, h), whole(w), whole(h)));
  Perception result;
  const int cells_x = (w + 1) / 2;
  const int cells_y = (h + 1) / 2;
  result.figure = probabilities(seen, 0, cells_x, cells_y);
  result.contour = probabilities(seen, 1, cells_x, cells_y);
  result.cell = 2 / scale;
  result.front = {directions(seen, cells_x, cells_y), result.cell};
  return result;
}

Image8 at_pixels(const Image8& map, double cell, int width, int height) {
  // Two neighbouring cells and the share of the second, of 256, for each row or column.
  struct Place {
    int first, second, share;
  };
  const auto places = [cell](int count, int cells) {
    std::vector<Place> result;
    for (int k = 0; k < count; ++k) {
      const double at = std::clamp((k + 0.5) / cell - 0.5, 0.0, cells - 1.0);
      const int first = static_cast<int>(at);
      result.push_back({first, std::min(first + 1, cells - 1),
                        static_cast<int>(std::lround(256 * (at - first)))});
    }
    return result;
  };
  const std::vector<Place> columns = places(width, map.width);
  const std::vector<Place> rows = places(height, map.height);
  Image8 result(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto along = [&](int row) {
        return map.at(columns[x].first, row) * (256 - columns[x].share) +
               map.at(columns[x].second, row) * columns[x].share;
      };
      const int value =
          along(rows[y].first) * (256 - rows[y].share) + along(rows[y].second) * rows[y].share;
      result.at(x, y) = static_cast<uint8_t>((value + (1 << 15)) >> 16);
    }
  return result;
}

}  // namespace relievo::understanding
