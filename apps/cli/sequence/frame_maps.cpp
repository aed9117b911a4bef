#include "apps/cli/sequence/frame_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "kernel/image/diffusion.h"

namespace relievo::cli {
namespace {

/// Maximum differences at still pixels: of a colour, of 255, and of an outline, canvas px.
constexpr int still_colour = 2;
constexpr double still_px = 0.5;

/// Distance over which still heights blend into moving ones, so that their border has no kink; a
/// share of the longer side.
constexpr float blend_distance = 0.005F;

/// Returns the range of old pixels that a new pixel covers along a side.
std::pair<int, int> covered(int i, int old_side, int new_side) {
  const int from = static_cast<int>(static_cast<int64_t>(i) * old_side / new_side);
  const int to = static_cast<int>(static_cast<int64_t>(i + 1) * old_side / new_side);
  return {from, std::max(to, from + 1)};
}

bool same_shape(const Ring& a, const Ring& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](Point2 p, Point2 q) { return distance(p, q) <= still_px; });
}

/// Returns, for each part, whether its outline is the same in both frames.
std::map<int, bool> parts_at_rest(const FrameMaps& a, const FrameMaps& b) {
  std::map<int, bool> rests;
  for (const auto& [number, outline] : a.outlines) {
    const auto other = b.outlines.find(number);
    rests[number] = other != b.outlines.end() &&
                    std::equal(outline.begin(), outline.end(), other->second.begin(),
                               other->second.end(), same_shape);
  }
  return rests;
}

bool same_colour(const FrameMaps& a, const FrameMaps& b, size_t i) {
  for (size_t c = 4 * i; c < 4 * i + 4; ++c)
    if (std::abs(a.colour.pixels[c] - b.colour.pixels[c]) > still_colour) return false;
  return true;
}

/// Returns the still pixels; none if the frames differ in size.
std::vector<size_t> still_pixels(const FrameMaps& before, const FrameMaps& after) {
  if (before.part.width != after.part.width || before.part.height != after.part.height) return {};
  std::map<int, bool> at_rest = parts_at_rest(before, after);
  std::vector<size_t> still;
  for (size_t i = 0; i < before.part.pixels.size(); ++i) {
    const int part = before.part.pixels[i];
    if (part >= 0 && part == after.part.pixels[i] && at_rest[part] && same_colour(before, after, i))
      still.push_back(i);
  }
  return still;
}

/// Adds heights to a surface, and adapts its normals. `pixel`: canvas px per pixel.
void add_heights(const ImageF& rise, double pixel, FrameMaps& frame, ImageF& normal) {
  const auto [w, h] = std::pair(rise.width, rise.height);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      if (frame.part.at(x, y) < 0) continue;
      frame.height.at(x, y) += rise.at(x, y);
      const auto [left, right] = std::pair(std::max(x - 1, 0), std::min(x + 1, w - 1));
      const auto [top, bottom] = std::pair(std::max(y - 1, 0), std::min(y + 1, h - 1));
      const double nz = normal.at(x, y, 2);
      double nx = normal.at(x, y, 0);
      double ny = normal.at(x, y, 1);
      if (right > left)
        nx -= nz * (rise.at(right, y) - rise.at(left, y)) / (pixel * (right - left));
      if (bottom > top)
        ny += nz * (rise.at(x, bottom) - rise.at(x, top)) / (pixel * (bottom - top));
      const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
      normal.at(x, y, 0) = static_cast<float>(nx / length);
      normal.at(x, y, 1) = static_cast<float>(ny / length);
      normal.at(x, y, 2) = static_cast<float>(nz / length);
    }
}

}  // namespace

FrameMaps blank_maps(const std::string& name, ImageSize size) {
  const auto [w, h] = size;
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  FrameMaps maps{name,
                 Image8(w, h, 4),
                 Image8(w, h, 3, 128),
                 Image8(w, h, 1, 255),
                 ImageF(w, h, 1, nothing),
                 Image<int32_t>(w, h, 1, -1),
                 {}};
  for (size_t i = 2; i < maps.normal.pixels.size(); i += 3) maps.normal.pixels[i] = 255;
  return maps;
}

Image8 resized(const Image8& rgba, ImageSize size) {
  Image8 out(size.width, size.height, 4);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const auto [top, bottom] = covered(y, rgba.height, size.height);
      const auto [left, right] = covered(x, rgba.width, size.width);
      std::array<int64_t, 4> sum{};
      for (int v = top; v < bottom; ++v)
        for (int u = left; u < right; ++u) {
          const int alpha = rgba.at(u, v, 3);
          for (int c = 0; c < 3; ++c) sum[c] += int64_t{alpha} * rgba.at(u, v, c);
          sum[3] += alpha;
        }
      if (sum[3] == 0) continue;
      const int64_t count = int64_t{bottom - top} * (right - left);
      for (int c = 0; c < 3; ++c)
        out.at(x, y, c) = static_cast<uint8_t>((sum[c] + sum[3] / 2) / sum[3]);
      out.at(x, y, 3) = static_cast<uint8_t>((sum[3] + count / 2) / count);
    }
  return out;
}

int PartNumbers::number_of(const std::string& name) {
  const auto number = std::find(names_.begin(), names_.end(), name) - names_.begin();
  if (number == std::ssize(names_)) names_.push_back(name);
  return static_cast<int>(number);
}

std::vector<int> PartNumbers::by_name(const Scene& scene) {
  std::vector<int> number;
  for (const Part& part : scene.parts) number.push_back(number_of(part.id));
  return number;
}

std::vector<int> PartNumbers::by_place(const Scene& scene, const Image<int32_t>& part) {
  std::map<std::pair<int, int>, int> common;
  for (size_t i = 0; i < part.pixels.size() && !last_.empty(); ++i)
    if (part.pixels[i] >= 0 && last_.pixels[i] >= 0) ++common[{part.pixels[i], last_.pixels[i]}];
  std::vector<std::tuple<int, int, int>> most;  // less pixels, part, number
  for (const auto& [pair, pixels] : common) most.emplace_back(-pixels, pair.first, pair.second);
  std::sort(most.begin(), most.end());
  std::vector<int> number(scene.parts.size(), -1);
  std::vector<bool> taken(names_.size(), false);
  for (const auto& [pixels, one, before] : most) {
    if (number[one] >= 0 || taken[before]) continue;
    number[one] = before;
    taken[before] = true;
  }
  for (int& one : number)
    if (one < 0) one = number_of("part-" + std::to_string(names_.size() + 1));
  return number;
}

std::vector<int> PartNumbers::renumber(const Scene& scene, bool flat, Image<int32_t>& part) {
  std::vector<int> number = flat ? by_place(scene, part) : by_name(scene);
  for (int32_t& pixel : part.pixels)
    if (pixel >= 0) pixel = number[pixel];
  last_ = part;
  return number;
}

void hold_heights(const FrameMaps& before, double pixel, FrameMaps& frame, ImageF& normal) {
  const std::vector<size_t> still = still_pixels(before, frame);
  if (still.empty()) return;
  const auto [w, h] = std::pair(frame.height.width, frame.height.height);
  const float softness = blend_distance * static_cast<float>(std::max(w, h));
  ImageF known(w, h, 2);
  for (const size_t i : still) {
    known.pixels[2 * i] = before.height.pixels[i] - frame.height.pixels[i];
    known.pixels[2 * i + 1] = 1 / std::max(1.0F, softness * softness);
  }
  add_heights(diffuse(known), pixel, frame, normal);
}

Flicker measure_flicker(const FrameMaps& before, const FrameMaps& after, const HeightRange& range) {
  const double extent = range.high - range.low;
  std::vector<double> changes;
  for (const size_t i : still_pixels(before, after)) {
    const double change = std::abs(static_cast<double>(after.height.pixels[i]) -
                                   static_cast<double>(before.height.pixels[i]));
    changes.push_back(extent > 0 ? change / extent : 0);
  }
  if (changes.empty()) return {};
  const auto figure = std::count_if(before.part.pixels.begin(), before.part.pixels.end(),
                                    [](int part) { return part >= 0; });
  std::sort(changes.begin(), changes.end());
  return {static_cast<double>(changes.size()) / static_cast<double>(figure),
          changes[changes.size() / 2], changes[changes.size() * 99 / 100], changes.back()};
}

}  // namespace relievo::cli
