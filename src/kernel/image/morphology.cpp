#include "kernel/image/morphology.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>
#include <vector>

namespace relievo {
namespace {

struct Larger {
  uint8_t operator()(uint8_t a, uint8_t b) const { return a > b ? a : b; }
};
struct Smaller {
  uint8_t operator()(uint8_t a, uint8_t b) const { return a < b ? a : b; }
};

template <class Pick>
void pick_rows(const uint8_t* a, const uint8_t* b, uint8_t* out, size_t n, const Pick& pick) {
  for (size_t i = 0; i < n; ++i) out[i] = pick(a[i], b[i]);
}

/// Running extremes of blocks of `window` rows, from their first row down and from their last up.
/// The extreme of any `window` rows is then that of two of them.
template <class Pick>
Image8 filter_columns(const Image8& image, int radius, const Pick& pick) {
  const int window = 2 * radius + 1;
  const int h = image.height;
  const size_t n = static_cast<size_t>(image.width) * image.channels;
  Image8 down = image;
  for (int y = 1; y < h; ++y)
    if (y % window != 0) pick_rows(&down.at(0, y - 1), &down.at(0, y), &down.at(0, y), n, pick);
  Image8 up = image;
  for (int y = h - 2; y >= 0; --y)
    if ((y + 1) % window != 0) pick_rows(&up.at(0, y + 1), &up.at(0, y), &up.at(0, y), n, pick);
  Image8 result(image.width, h, image.channels);
  for (int y = 0; y < h; ++y) {
    const int first = std::max(0, y - radius);
    const int last = std::min(h - 1, y + radius);
    // A window that is cut off lies within one block, which begins or ends where it does.
    const bool from_start = y - radius < 0;
    const bool in_one_block = first / window == last / window;
    const uint8_t* head = from_start ? &down.at(0, last) : &up.at(0, first);
    const uint8_t* tail = in_one_block ? head : &down.at(0, last);
    pick_rows(head, tail, &result.at(0, y), n, pick);
  }
  return result;
}

template <int channels>
void transpose_block(const Image8& image, Image8& result, int x0, int y0, int block) {
  const int x1 = std::min(image.width, x0 + block);
  const int y1 = std::min(image.height, y0 + block);
  for (int x = x0; x < x1; ++x) {
    uint8_t* out = &result.at(y0, x);
    for (int y = y0; y < y1; ++y) {
      const uint8_t* in = &image.pixels[(static_cast<size_t>(y) * image.width + x) * channels];
      for (int c = 0; c < channels; ++c) *out++ = in[c];
    }
  }
}

Image8 transpose(const Image8& image) {
  constexpr int block = 64;
  Image8 result(image.height, image.width, image.channels);
  const auto each_block = [&](auto transpose_one) {
    for (int y = 0; y < image.height; y += block)
      for (int x = 0; x < image.width; x += block) transpose_one(image, result, x, y, block);
  };
  assert(image.channels >= 1 && image.channels <= 4);
  switch (image.channels) {
    case 1:
      each_block(transpose_block<1>);
      break;
    case 2:
      each_block(transpose_block<2>);
      break;
    case 3:
      each_block(transpose_block<3>);
      break;
    default:
      each_block(transpose_block<4>);
      break;
  }
  return result;
}

using Ring8 = std::array<uint8_t, 8>;  ///< neighbours clockwise from the one above, 0 or 1

Ring8 neighbours(const Image8& mask, int x, int y) {
  static constexpr int dx[] = {0, 1, 1, 1, 0, -1, -1, -1};
  static constexpr int dy[] = {-1, -1, 0, 1, 1, 1, 0, -1};
  Ring8 ring = {};
  for (int k = 0; k < 8; ++k) {
    const int nx = x + dx[k];
    const int ny = y + dy[k];
    const bool inside = nx >= 0 && ny >= 0 && nx < mask.width && ny < mask.height;
    ring[k] = inside && mask.at(nx, ny) != 0 ? 1 : 0;
  }
  return ring;
}

/// Whether a pixel with these neighbours can go in the given half of a round.
bool is_removable(const Ring8& p, int half) {
  int count = 0;
  int entries = 0;
  for (int k = 0; k < 8; ++k) {
    count += p[k];
    entries += p[k] == 0 && p[(k + 1) % 8] == 1 ? 1 : 0;
  }
  if (count < 2 || count > 6 || entries != 1) return false;
  const uint8_t up = p[0];
  const uint8_t right = p[2];
  const uint8_t down = p[4];
  const uint8_t left = p[6];
  return half == 0 ? (up & right & down) == 0 && (right & down & left) == 0
                   : (up & right & left) == 0 && (up & down & left) == 0;
}

}  // namespace

Image8 max_filter(const Image8& image, int radius) {
  assert(radius >= 0);
  if (radius == 0 || image.empty()) return image;
  const Image8 columns = transpose(filter_columns(image, radius, Larger()));
  return transpose(filter_columns(columns, radius, Larger()));
}

Image8 min_filter(const Image8& image, int radius) {
  assert(radius >= 0);
  if (radius == 0 || image.empty()) return image;
  const Image8 columns = transpose(filter_columns(image, radius, Smaller()));
  return transpose(filter_columns(columns, radius, Smaller()));
}

Image8 close_gaps(const Image8& image, int radius) {
  assert(radius >= 0);
  if (radius == 0 || image.empty()) return image;
  const Image8 columns = transpose(filter_columns(image, radius, Larger()));
  const Image8 squares = filter_columns(columns, radius, Larger());
  return filter_columns(transpose(filter_columns(squares, radius, Smaller())), radius, Smaller());
}

Image8 thin(const Image8& mask) {
  assert(mask.channels == 1);
  Image8 result = mask;
  std::vector<std::pair<int, int>> left;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) == 0) continue;
      result.at(x, y) = 255;
      left.emplace_back(x, y);
    }
  std::vector<std::pair<int, int>> gone;
  for (bool changed = true; changed;) {
    changed = false;
    for (int half = 0; half < 2; ++half) {
      gone.clear();
      for (const auto& [x, y] : left)
        if (is_removable(neighbours(result, x, y), half)) gone.emplace_back(x, y);
      for (const auto& [x, y] : gone) result.at(x, y) = 0;
      changed = changed || !gone.empty();
      left.erase(std::remove_if(left.begin(), left.end(),
                                [&](const auto& p) { return result.at(p.first, p.second) == 0; }),
                 left.end());
    }
  }
  return result;
}

}  // namespace relievo
