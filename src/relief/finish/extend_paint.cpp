#include "relief/finish/extend_paint.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/image/components.h"
#include "kernel/image/compose.h"
#include "kernel/image/diffusion.h"
#include "kernel/image/distance_transform.h"
#include "kernel/image/morphology.h"
#include "relief/finish/fill_triangle.h"
#include "relief/finish/own_palette.h"

namespace relievo::relief {
namespace {

// Tuned on the samples and on drawings on coloured paper.
constexpr int blended = 3;          ///< px inside the outline that paper may blend into
constexpr int beyond_outline = 3;   ///< px beyond the outline that get paint, for filtering
constexpr int widest_sliver = 3;    ///< px, half the width of slivers of paper inside the outline
constexpr int ink_outside = 4;      ///< px beyond the outline that may hold half of its line
constexpr int least_contrast = 60;  ///< RGB distance of paper and paint that can be distinguished
constexpr double most_off_blend = 0.4;  ///< distance of blends from the line q c, of |c - q|
constexpr double least_paint = 0.7;     ///< share of paint in pixels that are not slivers

using Colour = std::array<int, 3>;

/// Returns the colour of a pixel on white paper.
Colour seen_colour(const Image8& rgba, size_t i) {
  const uint8_t* p = &rgba.pixels[4 * i];
  return {on_paper(p[0], p[3]), on_paper(p[1], p[3]), on_paper(p[2], p[3])};
}

/// Colours of some pixels, spread smoothly over the picture in cells of `size` x `size` pixels.
class SpreadColours {
 public:
  /// `of`: not 0 on the pixels whose colours are spread.
  SpreadColours(const Image8& of, const Image8& rgba, int size) : size_(size) {
    ImageF cells((of.width + size - 1) / size, (of.height + size - 1) / size, 4);
    for (size_t i = 0; i < of.pixels.size(); ++i) {
      if (of.pixels[i] == 0) continue;
      float* cell =
          &cells.at(static_cast<int>(i) % of.width / size, static_cast<int>(i) / of.width / size);
      const Colour colour = seen_colour(rgba, i);
      for (int c = 0; c < 3; ++c) cell[c] += static_cast<float>(colour[c]);
      ++cell[3];
    }
    for (size_t i = 0; i < cells.pixels.size(); i += 4) {
      float* cell = &cells.pixels[i];
      for (int c = 0; c < 3 && cell[3] > 0; ++c) cell[c] /= cell[3];
      cell[3] = std::min(cell[3], 1.0F);
    }
    colours_ = pull_push(cells);
  }

  Colour at(int x, int y) const {
    const float* cell = &colours_.at(x / size_, y / size_);
    return {static_cast<int>(cell[0]), static_cast<int>(cell[1]), static_cast<int>(cell[2])};
  }

 private:
  int size_;
  ImageF colours_;
};

/// Computes the share of paint in a colour p that blends paint c with paper q,
///   (p - q) . (c - q) / |c - q|^2.
/// Returns nothing if p is no such blend, as ink, or c is too similar to q.
std::optional<double> share_of_paint(const Colour& seen, const Colour& paint, const Colour& paper) {
  double along = 0;
  double contrast = 0;
  double departure = 0;
  for (size_t c = 0; c < 3; ++c) {
    const double to_paint = paint[c] - paper[c];
    const double here = seen[c] - paper[c];
    along += here * to_paint;
    contrast += to_paint * to_paint;
    departure += here * here;
  }
  if (contrast < least_contrast * least_contrast) return std::nullopt;
  const double off = departure - along * along / contrast;
  if (off > most_off_blend * most_off_blend * contrast) return std::nullopt;
  return along / contrast;
}

/// Returns the pixels farther than `distance` px from those of a mask.
Image8 beyond(const Image8& mask, int distance) {
  return complement(pixels_within(mask, distance));
}

/// Returns the colours of the paper around a model, spread below the model. `open`: not 0 on paper.
SpreadColours paper_around(const Image8& open, const Image8& rgba) {
  constexpr int cells = 64;  // along the longer side
  const Image8 off_ink = beyond(complement(open), ink_outside);
  const bool is_known = *std::max_element(off_ink.pixels.begin(), off_ink.pixels.end()) != 0;
  const int size = std::max(1, std::max(rgba.width, rgba.height) / cells);
  return {is_known ? off_ink : open, rgba, size};
}

/// Returns the paper around a model with the slivers of paper inside its outline: narrow, beside
/// broad paint, and connected to the paper around.
Image8 with_slivers(const Image8& open, const Image8& rgba, const SpreadColours& paper) {
  constexpr int cell = 8;  // px
  const Image8 deep = beyond(open, blended + widest_sliver);
  const Image8 off_paint = beyond(deep, blended + 2 * widest_sliver);
  const SpreadColours paint(deep, rgba, cell);
  Image8 like(open.width, open.height, 1);
  for (int y = 0; y < like.height; ++y)
    for (int x = 0; x < like.width; ++x) {
      if (open.at(x, y) != 0 || off_paint.at(x, y) != 0) continue;
      const size_t i = static_cast<size_t>(y) * like.width + x;
      const auto share = share_of_paint(seen_colour(rgba, i), paint.at(x, y), paper.at(x, y));
      like.at(x, y) = share && *share < least_paint ? 1 : 0;
    }
  const Image8 broad = max_filter(min_filter(like, widest_sliver), widest_sliver);
  for (size_t i = 0; i < like.pixels.size(); ++i)
    like.pixels[i] = open.pixels[i] != 0 || like.pixels[i] > broad.pixels[i] ? 1 : 0;
  return connected_to({0, 0, std::move(like)}, {0, 0, open}).inside;
}

/// Carries paint outwards from the pixels that certainly show paint, one pixel a step.
class PaintCarrier {
 public:
  /// `open`: 1 on pixels that the model does not cover. `settled`: 1 on pixels that stay.
  PaintCarrier(const Image8& open, const Image8& settled, Image8& rgba)
      : rgba_(rgba),
        paper_(paper_around(open, rgba)),
        open_(with_slivers(open, rgba, paper_)),
        known_(beyond(open_, blended)) {
    const Image8 out_of_reach = beyond(known_, blended + beyond_outline);
    for (size_t i = 0; i < known_.pixels.size(); ++i) {
      if (settled.pixels[i] != 0) {
        known_.pixels[i] = open.pixels[i] == 0 ? 1 : 0;
        continue;
      }
      const bool sliver = open_.pixels[i] != 0 && open.pixels[i] == 0;
      if (known_.pixels[i] == 0 && (sliver || out_of_reach.pixels[i] == 0))
        waiting_.push_back(static_cast<int>(i));
    }
  }

  /// Returns false if there is nothing left to paint.
  bool step() {
    std::vector<std::pair<int, Colour>> found;
    for (const int i : waiting_) add_if_beside(i % known_.width, i / known_.width, found);
    for (const auto& [i, colour] : found) {
      known_.pixels[i] = 1;
      if (open_.pixels[i] != 0 || is_blend(i, colour)) paint(i, colour);
    }
    const auto is_known = [this](int i) { return known_.pixels[i] != 0; };
    waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_known), waiting_.end());
    return !found.empty();
  }

 private:
  /// Returns whether paper blends into a pixel whose paint would be of this colour.
  bool is_blend(int i, const Colour& colour) const {
    const auto share = share_of_paint(seen(i), colour, paper_.at(i % rgba_.width, i / rgba_.width));
    return share && *share < 1;
  }

  Colour seen(int i) const { return seen_colour(rgba_, static_cast<size_t>(i)); }

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

  Image8& rgba_;
  SpreadColours paper_;
  Image8 open_;               ///< the paper, with slivers
  Image8 known_;              ///< the pixels that show paint
  std::vector<int> waiting_;  ///< pixels still to reach
};

}  // namespace

void extend_paint(const Model& model, const Image8& settled, Image8& rgba) {
  PaintCarrier carrier(uncovered_pixels(model, {rgba.width, rgba.height}), settled, rgba);
  while (carrier.step()) {
  }
}

void extend_paint(const Model& model, Drawing& drawing) {
  Image8& rgba = drawing.rgba;
  if (rgba.empty()) return;
  if (drawing.pixel_art > 0) return extend_own_pixels(model, drawing);
  extend_paint(model, Image8(rgba.width, rgba.height, 1), rgba);
}

}  // namespace relievo::relief
