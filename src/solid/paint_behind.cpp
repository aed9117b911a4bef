#include "solid/paint_behind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/compose.h"
#include "kernel/image/diffusion.h"
#include "kernel/image/distance_transform.h"
#include "kernel/image/morphology.h"
#include "kernel/image/pixel_box.h"
#include "relief/finish/cover_ink.h"
#include "relief/finish/fill_triangle.h"
#include "relief/finish/spread_colours.h"

namespace relievo {
namespace {

constexpr int longest_side = 192;      ///< cells of the harmonic paint
constexpr double rim_share = 0.025;    ///< of the figure's side: paint of the front beside the rim
constexpr double grain_share = 0.008;  ///< of it: the longest waves of grain
constexpr int least_mark = 12;         ///< of 255, by which marks depart from the paint around,
constexpr int mark_over_grain = 4;     ///< besides so many times the median departure
constexpr int neutral = 128;           ///< stands for no difference in images of half differences

/// Returns the rearmost part at every pixel, counted from 1, or 0.
Image16 rear_parts(const relief::VisibleSheet& sheet, ImageSize size) {
  const Model& model = sheet.model;
  Image16 rear(size.width, size.height, 1);
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const int part = sheet.back[model.triangles[t][0]].part;
    relief::for_each_pixel_inside(
        relief::corners_on_image(model, t, size), size,
        [&](int x, int y) { rear.at(x, y) = static_cast<uint16_t>(part + 1); });
  }
  return rear;
}

class BehindPainter {
 public:
  BehindPainter(const relief::VisibleSheet& sheet, const Image8& rgba)
      : rgb_(rgba.width, rgba.height, 3),
        front_(relief::front_parts(sheet.model, {rgba.width, rgba.height})),
        rear_(rear_parts(sheet, {rgba.width, rgba.height})),
        smooth_(rgba.width, rgba.height, 3) {
    for (size_t i = 0; i < front_.pixels.size(); ++i)
      for (size_t c = 0; c < 3; ++c)
        rgb_.pixels[3 * i + c] = on_paper(rgba.pixels[4 * i + c], rgba.pixels[4 * i + 3]);
    Image8 open(rgba.width, rgba.height, 1);
    for (size_t i = 0; i < open.pixels.size(); ++i) open.pixels[i] = front_.pixels[i] == 0 ? 1 : 0;
    from_rim_ = squared_distance_to(open);
    const int side = longest_side_of_figure();
    rim_ = std::max(2.0, rim_share * side);
    wave_ = std::max(1, static_cast<int>(grain_share * side));
    cell_ = (side + longest_side - 1) / longest_side;
    boxes_ = boxes_of_parts();
  }

  Image8 paint() {
    grow_paint(Image8(rgb_.width, rgb_.height, 1));
    const Image8 edges = edges_of_marks(half_difference());
    grow_paint(max_filter(edges, wave_ / 2));
    const Image8 difference = half_difference();
    const Image8 marks = with_other_parts(max_filter(edges, 2 * wave_));
    Image8 grain = find_grain(difference, marks);
    relief::cover_ink(rear_, marks, Image8(marks.width, marks.height, 1), grain);
    Image8 behind(rgb_.width, rgb_.height, 4, 255);
    Image8 known(rgb_.width, rgb_.height, 1);
    for (size_t i = 0; i < rear_.pixels.size(); ++i) {
      known.pixels[i] = rear_.pixels[i] != 0 ? 1 : 0;
      const double w = front_.pixels[i] == rear_.pixels[i] ? rim_weight(i) : 0;
      for (size_t c = 0; c < 3; ++c) {
        const int grown = smooth_.pixels[3 * i + c] + 2 * (grain.pixels[4 * i + c] - neutral);
        const double value = w * rgb_.pixels[3 * i + c] + (1 - w) * grown;
        rgb_.pixels[3 * i + c] = static_cast<uint8_t>(std::clamp(std::lround(value), 0L, 255L));
      }
    }
    relief::spread_colours(known, rgb_);
    for (size_t i = 0; i < rear_.pixels.size(); ++i)
      std::copy_n(&rgb_.pixels[3 * i], 3, &behind.pixels[4 * i]);
    return behind;
  }

 private:
  /// Returns the longer side of the box around the figure, px.
  int longest_side_of_figure() const {
    PixelBox box{rear_.width, rear_.height, 0, 0};
    for (int y = 0; y < rear_.height; ++y)
      for (int x = 0; x < rear_.width; ++x)
        if (rear_.at(x, y) != 0)
          box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
                 std::max(box.bottom, y + 1)};
    return std::max({1, box.width(), box.height()});
  }

  /// Returns the weight of the front's own paint, 1 at the rim and 0 from rim_ px on.
  double rim_weight(size_t i) const {
    const double t = std::min(1.0, std::sqrt(from_rim_.pixels[i]) / rim_);
    return (1 - t * t) * (1 - t * t);
  }

  /// Returns the cells around each part's pixels, with one more on each side.
  std::vector<PixelBox> boxes_of_parts() const {
    std::vector<PixelBox> boxes;
    for (int y = 0; y < rear_.height; ++y)
      for (int x = 0; x < rear_.width; ++x) {
        const uint16_t part = rear_.at(x, y);
        if (part == 0) continue;
        if (boxes.size() < part) boxes.resize(part, {INT32_MAX, INT32_MAX, 0, 0});
        PixelBox& box = boxes[part - 1];
        box = {std::min(box.left, x / cell_ - 1), std::min(box.top, y / cell_ - 1),
               std::max(box.right, x / cell_ + 2), std::max(box.bottom, y / cell_ + 2)};
      }
    for (PixelBox& box : boxes)
      if (box.right == 0) box = {};
    return boxes;
  }

  /// Returns the sums of a part's colours by cell and, last, their counts: of the pixels within
  /// `reach` of the rim that are not left out.
  ImageF sums_by_cell(uint16_t part, const PixelBox& box, const Image8& left_out,
                      double reach) const {
    ImageF sums(box.width(), box.height(), 4);
    const auto begin = [this](int at) { return std::max(0, at * cell_); };
    for (int y = begin(box.top); y < std::min(rear_.height, box.bottom * cell_); ++y)
      for (int x = begin(box.left); x < std::min(rear_.width, box.right * cell_); ++x) {
        if (front_.at(x, y) != part || left_out.at(x, y) != 0) continue;
        if (from_rim_.at(x, y) > reach * reach) continue;
        float* sum = &sums.at(x / cell_ - box.left, y / cell_ - box.top);
        for (int c = 0; c < 3; ++c) sum[c] += rgb_.at(x, y, c);
        ++sum[3];
      }
    return sums;
  }

  /// Grows the paint of every part from the rim over all of it. `left_out`: 1 on pixels whose
  /// paint does not count if there is other paint.
  void grow_paint(const Image8& left_out) {
    for (size_t p = 0; p < boxes_.size(); ++p)
      if (boxes_[p].width() > 0) grow_paint(static_cast<uint16_t>(p + 1), boxes_[p], left_out);
  }

  void grow_paint(uint16_t part, const PixelBox& box, const Image8& left_out) {
    const auto has_paint = [](const ImageF& sums) {
      for (size_t i = 3; i < sums.pixels.size(); i += 4)
        if (sums.pixels[i] > 0) return true;
      return false;
    };
    ImageF sums = sums_by_cell(part, box, left_out, rim_);
    if (!has_paint(sums)) sums = sums_by_cell(part, box, left_out, no_distance);
    if (!has_paint(sums))
      sums = sums_by_cell(part, box, Image8(rgb_.width, rgb_.height, 1), no_distance);
    std::array<ImageF, 3> grown;
    for (int c = 0; c < 3; ++c) {
      ImageF known(sums.width, sums.height, 2);
      for (size_t i = 0; i < sums.pixels.size() / 4; ++i)
        if (const float count = sums.pixels[4 * i + 3]; count > 0) {
          known.pixels[2 * i] = sums.pixels[4 * i + c] / count;
          known.pixels[2 * i + 1] = fixed_weight;
        }
      grown[c] = diffuse(known);
    }
    for (int y = std::max(0, box.top * cell_); y < std::min(rear_.height, box.bottom * cell_); ++y)
      for (int x = std::max(0, box.left * cell_); x < std::min(rear_.width, box.right * cell_); ++x)
        if (rear_.at(x, y) == part)
          for (int c = 0; c < 3; ++c)
            smooth_.at(x, y, c) = static_cast<uint8_t>(
                std::lround(std::clamp(between_cells(grown[c], box, x, y), 0.0, 255.0)));
  }

  double between_cells(const ImageF& cells, const PixelBox& box, int x, int y) const {
    const double u = std::clamp((x + 0.5) / cell_ - box.left - 0.5, 0.0, cells.width - 1.0);
    const double v = std::clamp((y + 0.5) / cell_ - box.top - 0.5, 0.0, cells.height - 1.0);
    const int i = std::min(static_cast<int>(u), cells.width - 2);
    const int j = std::min(static_cast<int>(v), cells.height - 2);
    const double s = u - i;
    const double t = v - j;
    return (1 - t) * ((1 - s) * cells.at(i, j) + s * cells.at(i + 1, j)) +
           t * ((1 - s) * cells.at(i, j + 1) + s * cells.at(i + 1, j + 1));
  }

  /// Returns half the difference of the front and the grown paint, plus `neutral`; where the front
  /// shows another part, `neutral` alone.
  Image8 half_difference() const {
    Image8 half(rgb_.width, rgb_.height, 3, neutral);
    for (size_t i = 0; i < rear_.pixels.size(); ++i)
      for (size_t c = 0; c < 3 && rear_.pixels[i] != 0 && front_.pixels[i] == rear_.pixels[i]; ++c)
        half.pixels[3 * i + c] = static_cast<uint8_t>(
            neutral + (rgb_.pixels[3 * i + c] - smooth_.pixels[3 * i + c]) / 2);
    return half;
  }

  Image8 blurred(const Image8& image) const { return box_blur(box_blur(image, wave_), wave_); }

  /// Returns 1 on the edges of marks, where paint departs most from that around.
  Image8 edges_of_marks(const Image8& difference) const {
    const Image8 waves = blurred(difference);
    Image8 departure(rgb_.width, rgb_.height, 1);
    std::array<int64_t, 256> counts{};
    int64_t all = 0;
    for (size_t i = 0; i < departure.pixels.size(); ++i) {
      int most = 0;
      for (size_t c = 0; c < 3; ++c)
        most = std::max(most, std::abs(difference.pixels[3 * i + c] - waves.pixels[3 * i + c]));
      departure.pixels[i] = static_cast<uint8_t>(std::min(255, 2 * most));
      if (front_.pixels[i] == 0 || front_.pixels[i] != rear_.pixels[i]) continue;
      ++counts[departure.pixels[i]];
      ++all;
    }
    int median = 0;
    for (int64_t below = counts[0]; 2 * below < all; below += counts[median]) ++median;
    for (uint8_t& d : departure.pixels) d = d > least_mark + mark_over_grain * median ? 1 : 0;
    return departure;
  }

  /// Adds the pixels where the front does not show the rear part.
  Image8 with_other_parts(Image8 marks) const {
    for (size_t i = 0; i < marks.pixels.size(); ++i)
      if (front_.pixels[i] != rear_.pixels[i]) marks.pixels[i] = 1;
    return marks;
  }

  /// Returns the short waves of half differences off the marks, plus `neutral`.
  Image8 find_grain(Image8 difference, const Image8& marks) const {
    Image8 share(marks.width, marks.height, 1, 0);
    for (size_t i = 0; i < marks.pixels.size(); ++i) {
      if (marks.pixels[i] == 0)
        share.pixels[i] = 255;
      else
        std::fill_n(&difference.pixels[3 * i], 3, uint8_t{neutral});
    }
    const Image8 waves = blurred(difference);
    share = blurred(share);
    Image8 grain(marks.width, marks.height, 4, neutral);
    for (size_t i = 0; i < marks.pixels.size(); ++i)
      for (size_t c = 0; c < 3 && marks.pixels[i] == 0; ++c) {
        const double wave =
            255.0 * (waves.pixels[3 * i + c] - neutral) / std::max<int>(1, share.pixels[i]);
        grain.pixels[4 * i + c] = static_cast<uint8_t>(
            std::clamp(std::lround(difference.pixels[3 * i + c] - wave), 0L, 255L));
      }
    return grain;
  }

  Image8 rgb_;  ///< the drawing on white
  Image16 front_;
  Image16 rear_;
  Image8 smooth_;  ///< the paint grown from the rim
  Image<int32_t> from_rim_;
  double rim_ = 0;               ///< px
  int wave_ = 0;                 ///< px
  int cell_ = 1;                 ///< px
  std::vector<PixelBox> boxes_;  ///< by rear part, cells; empty where it is none
};

}  // namespace

Image8 paint_behind(const relief::VisibleSheet& sheet, const Drawing& drawing) {
  return BehindPainter(sheet, drawing.rgba).paint();
}

}  // namespace relievo
