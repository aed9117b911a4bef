#include "relief/model/extend_paint.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/image/distance_transform.h"
#include "kernel/image/lay_over.h"
#include "relief/model/fill_triangle.h"

namespace relievo {
namespace {

constexpr int blended = 2;  ///< px inside the outline that paper may blend into
constexpr int outside = 3;  ///< px beyond it that get paint, for what lies between pixels

using Colour = std::array<int, 3>;

/// Goes outwards from what is painted for certain, one pixel a step.
class PaintCarrier {
 public:
  PaintCarrier(const Image8& open, Image8& rgba) : open_(open), rgba_(rgba), known_(open) {
    const Image<int32_t> depth = squared_distance_to(open);
    for (size_t i = 0; i < known_.pixels.size(); ++i)
      known_.pixels[i] = depth.pixels[i] > blended * blended ? 1 : 0;
    const Image<int32_t> away = squared_distance_to(known_);
    constexpr int reach = blended + outside;
    for (size_t i = 0; i < known_.pixels.size(); ++i)
      if (known_.pixels[i] == 0 && away.pixels[i] <= reach * reach)
        waiting_.push_back(static_cast<int>(i));
  }

  void step() {
    std::vector<std::pair<int, Colour>> found;
    for (const int i : waiting_)
      if (known_.pixels[i] == 0) add_if_beside(i % known_.width, i / known_.width, found);
    for (const auto& [i, colour] : found) {
      known_.pixels[i] = 1;
      if (open_.pixels[i] != 0 || brightness(colour) < brightness(seen(i))) paint(i, colour);
    }
  }

 private:
  static int brightness(const Colour& colour) { return colour[0] + colour[1] + colour[2]; }

  Colour seen(int i) const {
    const uint8_t* p = &rgba_.pixels[4 * static_cast<size_t>(i)];
    return {on_paper(p[0], p[3]), on_paper(p[1], p[3]), on_paper(p[2], p[3])};
  }

  void paint(int i, const Colour& colour) {
    uint8_t* p = &rgba_.pixels[4 * static_cast<size_t>(i)];
    for (int c = 0; c < 3; ++c) p[c] = static_cast<uint8_t>(colour[c]);
    p[3] = 255;
  }

  void add_if_beside(int x, int y, std::vector<std::pair<int, Colour>>& found) const {
    Colour sum = {};
    int count = 0;
    for (int v = std::max(0, y - 1); v <= std::min(known_.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(known_.width - 1, x + 1); ++u) {
        if (known_.at(u, v) == 0) continue;
        const Colour colour = seen(v * known_.width + u);
        for (int c = 0; c < 3; ++c) sum[c] += colour[c];
        ++count;
      }
    if (count == 0) return;
    for (int& value : sum) value = (value + count / 2) / count;
    found.emplace_back(y * known_.width + x, sum);
  }

  const Image8& open_;
  Image8& rgba_;
  Image8 known_;
  std::vector<int> waiting_;  ///< pixels that can be reached
};

}  // namespace

void extend_paint(const Model& model, Image8& rgba) {
  if (rgba.empty()) return;
  const Image8 open = uncovered_pixels(model, {rgba.width, rgba.height});
  PaintCarrier carrier(open, rgba);
  for (int step = 0; step < blended + outside; ++step) carrier.step();
}

}  // namespace relievo
