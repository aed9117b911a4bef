#include "understanding/perception/perceive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernel/base/exact_functions.h"
#include "kernel/image/enlarge.h"

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

/// Returns a picture with one pixel for each square of the given side.
Image8 with_own_pixels(const Image8& rgba, int side) {
  Image8 result(rgba.width / side, rgba.height / side, 4);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      std::copy_n(&rgba.at(side * x, side * y), 4, &result.at(x, y));
  return result;
}

/// The pixels of a row or column that a cell of a grid takes in, and their weights, of sum 1.
struct Span {
  int first = 0;
  std::vector<float> weights;
};

/// Returns the spans of a grid of `cells` over `pixels`. A pixel at the distance d from the middle
/// of a cell has the weight 1 - d / r, where r is the greater of a pixel and a cell.
std::vector<Span> spans_of(int cells, int pixels) {
  const double step = static_cast<double>(pixels) / cells;
  const double reach = std::max(1.0, step);
  std::vector<Span> spans(cells);
  for (int k = 0; k < cells; ++k) {
    const double middle = (k + 0.5) * step - 0.5;
    spans[k].first = std::max(0, static_cast<int>(std::floor(middle - reach)) + 1);
    const int last = std::min(pixels - 1, static_cast<int>(std::ceil(middle + reach)) - 1);
    double sum = 0;
    for (int x = spans[k].first; x <= last; ++x) sum += 1 - std::abs(x - middle) / reach;
    for (int x = spans[k].first; x <= last; ++x)
      spans[k].weights.push_back(static_cast<float>((1 - std::abs(x - middle) / reach) / sum));
  }
  return spans;
}

/// Returns a row of a picture on white, with its alpha, at the resolution of a grid.
ImageF scaled_row(const Image8& rgba, int y, const std::vector<Span>& columns) {
  ImageF row(static_cast<int>(columns.size()), 1, 4);
  for (int u = 0; u < row.width; ++u)
    for (size_t i = 0; i < columns[u].weights.size(); ++i) {
      const uint8_t* pixel = &rgba.at(columns[u].first + static_cast<int>(i), y);
      const float alpha = static_cast<float>(pixel[3]) / 255;
      for (int c = 0; c < 3; ++c)
        row.at(u, 0, c) +=
            columns[u].weights[i] * (alpha * static_cast<float>(pixel[c]) / 255 + (1 - alpha));
      row.at(u, 0, 3) += columns[u].weights[i] * alpha;
    }
  return row;
}

/// Scales a picture on white, with its alpha, to a grid.
ImageF scaled(const Image8& rgba, int width, int height) {
  const std::vector<Span> columns = spans_of(width, rgba.width);
  const std::vector<Span> rows = spans_of(height, rgba.height);
  std::vector<ImageF> scaled_rows(rgba.height);
  for (int y = 0; y < rgba.height; ++y) scaled_rows[y] = scaled_row(rgba, y, columns);
  ImageF result(width, height, 4);
  for (int v = 0; v < height; ++v)
    for (size_t j = 0; j < rows[v].weights.size(); ++j) {
      const ImageF& row = scaled_rows[rows[v].first + j];
      for (size_t i = 0; i < row.pixels.size(); ++i)
        (&result.at(0, v))[i] += rows[v].weights[j] * row.pixels[i];
    }
  return result;
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
  // Enlarged pixels are seen as they were.
  const int side = square_side(rgba);
  const Image8 reduced = side > 1 ? with_own_pixels(rgba, side) : Image8();
  const Image8& own = side > 1 ? reduced : rgba;
  const double scale = static_cast<double>(longest_side) / std::max(own.width, own.height);
  const auto scaled_to = [scale](int length) {
    return std::max(1, static_cast<int>(std::lround(scale * length)));
  };
  const int w = scaled_to(own.width);
  const int h = scaled_to(own.height);
  const auto whole = [](int length) { return (length + unit - 1) / unit * unit; };
  const ImageF seen = apply_layers(network, extended(scaled(own, w, h), whole(w), whole(h)));
  Perception result;
  const int cells_x = (w + 1) / 2;
  const int cells_y = (h + 1) / 2;
  result.figure = probabilities(seen, 0, cells_x, cells_y);
  result.contour = probabilities(seen, 1, cells_x, cells_y);
  result.cell = 2 * side / scale;
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
