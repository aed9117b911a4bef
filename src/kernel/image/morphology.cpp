#include "kernel/image/morphology.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

namespace relievo {
namespace {

/// Running maxima of blocks of `window` rows, from their first row down and from their last up.
/// The largest of any `window` rows is then the larger of two of them.
Image8 max_over_columns(const Image8& image, int radius) {
  const int window = 2 * radius + 1;
  const int h = image.height;
  const size_t n = static_cast<size_t>(image.width) * image.channels;
  const auto larger = [n](const uint8_t* a, const uint8_t* b, uint8_t* out) {
    for (size_t i = 0; i < n; ++i) out[i] = std::max(a[i], b[i]);
  };
  Image8 down = image;
  for (int y = 1; y < h; ++y)
    if (y % window != 0) larger(&down.at(0, y - 1), &down.at(0, y), &down.at(0, y));
  Image8 up = image;
  for (int y = h - 2; y >= 0; --y)
    if ((y + 1) % window != 0) larger(&up.at(0, y + 1), &up.at(0, y), &up.at(0, y));
  Image8 result(image.width, h, image.channels);
  for (int y = 0; y < h; ++y) {
    const int first = std::max(0, y - radius);
    const int last = std::min(h - 1, y + radius);
    // A window that is cut off lies within one block, which begins or ends where it does.
    const bool from_start = y - radius < 0;
    const bool in_one_block = first / window == last / window;
    const uint8_t* head = from_start ? &down.at(0, last) : &up.at(0, first);
    const uint8_t* tail = in_one_block ? head : &down.at(0, last);
    larger(head, tail, &result.at(0, y));
  }
  return result;
}

Image8 transpose(const Image8& image) {
  constexpr int block = 32;
  const int channels = image.channels;
  Image8 result(image.height, image.width, channels);
  for (int y0 = 0; y0 < image.height; y0 += block)
    for (int x0 = 0; x0 < image.width; x0 += block)
      for (int y = y0; y < std::min(image.height, y0 + block); ++y)
        for (int x = x0; x < std::min(image.width, x0 + block); ++x)
          std::memcpy(&result.at(y, x), &image.at(x, y), channels);
  return result;
}

Image8 inverted(Image8 image) {
  for (uint8_t& value : image.pixels) value = static_cast<uint8_t>(255 - value);
  return image;
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
  return transpose(max_over_columns(transpose(max_over_columns(image, radius)), radius));
}

Image8 min_filter(const Image8& image, int radius) {
  return inverted(max_filter(inverted(image), radius));
}

Image8 close_gaps(const Image8& image, int radius) {
  return min_filter(max_filter(image, radius), radius);
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
