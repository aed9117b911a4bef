#include "understanding/labels/figure_ink.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "kernel/image/components.h"
#include "kernel/image/watershed.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr int clear_ink = 64;          ///< least ink of a line, of 255; less is its blur
constexpr double contour_reach = 0.8;  ///< largest width of an outline's outer half, line widths
constexpr double speck_length = 3;     ///< line widths, length up to which ink is a speck
// Lengths below are per diagonal of the figure.
constexpr double tube_length = 0.03;    ///< least length of a tube
constexpr double thinnest_tube = 0.01;  ///< least width of a tube
/// Share of the ink in areas that strokes made background above which it is their outline.
constexpr double outline_share = 0.2;

/// A connected piece of ink that bounds nothing.
struct LooseInk {
  std::vector<int32_t> pixels;  ///< y * width + x
  Box2 box;
  int beside = 0;        ///< label that it touches, or 0
  int64_t in_areas = 0;  ///< number of pixels in areas that strokes made background
};

class InkTaker {
 public:
  InkTaker(const Basins& basins, int last_label, Image<int32_t>& labels)
      : basins_(basins), last_label_(last_label), labels_(labels) {}

  void run(const Scribbles& scribbles, const std::vector<StrokePixel>& marks) {
    grow_contours();
    const std::vector<LooseInk> pieces = loose_pieces();
    const double diagonal = figure_diagonal(pieces);
    std::map<int32_t, int> strokes;
    for (const StrokePixel& mark : marks)
      if (is_free_ink(mark.pixel)) strokes[mark.pixel] = scribbles.strokes[mark.stroke].label();
    for (const LooseInk& piece : pieces) settle(piece, diagonal, strokes);
  }

 private:
  bool is_free_ink(size_t i) const {
    return basins_.barrier.pixels[i] == LineMap::line && labels_.pixels[i] == 0 &&
           basins_.ink.pixels[i] >= clear_ink;
  }

  /// Returns the label of a neighbour of a pixel, or 0.
  int32_t label_beside(int32_t i) const {
    for (const auto& [x, y] : side_neighbours(i % labels_.width, i / labels_.width))
      if (x >= 0 && y >= 0 && x < labels_.width && y < labels_.height && labels_.at(x, y) != 0)
        return labels_.at(x, y);
    return 0;
  }

  /// Gives the outer half of outlines to their parts, step by step outwards.
  void grow_contours() {
    std::vector<int32_t> waiting;
    for (size_t i = 0; i < labels_.pixels.size(); ++i)
      if (is_free_ink(i)) waiting.push_back(static_cast<int32_t>(i));
    const int steps = static_cast<int>(std::lround(contour_reach * basins_.line_width)) + 1;
    for (int step = 0; step < steps; ++step) {
      std::vector<std::pair<int32_t, int32_t>> taken;
      std::vector<int32_t> left;
      for (const int32_t i : waiting)
        if (const int32_t label = label_beside(i); label != 0)
          taken.emplace_back(i, label);
        else
          left.push_back(i);
      for (const auto& [i, label] : taken) labels_.pixels[i] = label;
      waiting = std::move(left);
    }
  }

  std::vector<LooseInk> loose_pieces() const {
    const Components found = connected_components(
        mask_where(labels_.width, labels_.height, [this](size_t i) { return is_free_ink(i); }),
        Connectivity::corners);
    std::vector<LooseInk> pieces(found.areas.size() - 1);
    for (size_t i = 0; i < labels_.pixels.size(); ++i) {
      if (found.label.pixels[i] == 0) continue;
      LooseInk& piece = pieces[found.label.pixels[i] - 1];
      const auto pixel = static_cast<int32_t>(i);
      piece.pixels.push_back(pixel);
      piece.box.add(middle(pixel));
      piece.in_areas += basins_.region[basins_.index.pixels[i]] != 0 ? 1 : 0;
      if (piece.beside == 0) piece.beside = label_beside(pixel);
    }
    return pieces;
  }

  Point2 middle(int32_t i) const {
    return {i % labels_.width + 0.5, i / labels_.width + 0.5};  // NOLINT(bugprone-integer-division)
  }

  /// Computes the diagonal of the box around all parts and the largest piece of loose ink, px.
  double figure_diagonal(const std::vector<LooseInk>& pieces) const {
    Box2 box;
    for (size_t i = 0; i < labels_.pixels.size(); ++i)
      if (labels_.pixels[i] != 0) box.add(middle(static_cast<int32_t>(i)));
    const LooseInk* longest = nullptr;
    for (const LooseInk& piece : pieces)
      if (longest == nullptr || piece.pixels.size() > longest->pixels.size()) longest = &piece;
    if (longest != nullptr) box.add(longest->box);
    return box.empty() ? 0 : distance(box.min, box.max);
  }

  /// Divides the pixels of a piece among the strokes on it, to the nearest along the ink. Returns
  /// the pixels by label; none where no stroke lies on it. `strokes`: by pixel, the stroke's label.
  std::map<int, std::vector<int32_t>> divide(const LooseInk& piece,
                                             const std::map<int32_t, int>& strokes) const {
    std::map<int, std::vector<int32_t>> pixels_of_label;
    std::map<int32_t, int> label_of;
    std::vector<int32_t> queue;
    for (const int32_t i : piece.pixels)
      if (const auto found = strokes.find(i); found != strokes.end()) {
        label_of.insert(*found);
        queue.push_back(i);
      }
    if (queue.empty()) return pixels_of_label;
    const std::set<int32_t> ink(piece.pixels.begin(), piece.pixels.end());
    for (size_t k = 0; k < queue.size(); ++k) {
      const int label = label_of.at(queue[k]);
      pixels_of_label[label].push_back(queue[k]);
      for (const int dy : {-1, 0, 1})
        for (const int dx : {-1, 0, 1}) {
          const int32_t next = queue[k] + dy * labels_.width + dx;
          if (ink.count(next) > 0 && label_of.emplace(next, label).second) queue.push_back(next);
        }
    }
    return pixels_of_label;
  }

  /// Returns whether a piece bounds an area that strokes made background.
  static bool bounds_background(const LooseInk& piece) {
    return static_cast<double>(piece.in_areas) >
           outline_share * static_cast<double>(piece.pixels.size());
  }

  bool crosses_the_picture(const LooseInk& piece) const {
    return (piece.box.min.x < 2 && piece.box.max.x > labels_.width - 2) ||
           (piece.box.min.y < 2 && piece.box.max.y > labels_.height - 2);
  }

  /// Returns whether a piece is likelier part of the surroundings than of the figure.
  bool is_surroundings(const LooseInk& piece) const {
    const auto total =
        std::accumulate(piece.pixels.begin(), piece.pixels.end(), int64_t{0},
                        [this](int64_t sum, int32_t i) { return sum + basins_.figure.pixels[i]; });
    return total < 128 * static_cast<int64_t>(piece.pixels.size());
  }

  /// Makes a piece a tube, part of another part, or background.
  void settle(const LooseInk& piece, double diagonal, const std::map<int32_t, int>& strokes) {
    const auto scribbled = divide(piece, strokes);
    for (const auto& [label, pixels] : scribbled)
      if (label > 0) lay_tube(pixels, label, diagonal);
    if (!scribbled.empty() || crosses_the_picture(piece) || is_surroundings(piece) ||
        bounds_background(piece))
      return;
    const double extent = distance(piece.box.min, piece.box.max);
    const bool speck = extent < std::max(speck_length * basins_.line_width, tube_length * diagonal);
    if (!speck)
      lay_tube(piece.pixels, ++last_label_, diagonal);
    else if (piece.beside != 0)
      for (const int32_t i : piece.pixels) labels_.pixels[i] = piece.beside;
  }

  /// Labels ink, widened on the background to the least width of a tube.
  void lay_tube(const std::vector<int32_t>& ink, int32_t label, double diagonal) {
    const double width = std::max(basins_.line_width, thinnest_tube * diagonal);
    const double radius = (width - basins_.line_width) / 2;
    const int reach = static_cast<int>(radius);
    for (const int32_t i : ink) labels_.pixels[i] = label;
    for (const int32_t i : ink)
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
          const int x = i % labels_.width + dx;
          const int y = i / labels_.width + dy;
          if (dx * dx + dy * dy > radius * radius || x < 0 || y < 0 || x >= labels_.width ||
              y >= labels_.height)
            continue;
          if (labels_.at(x, y) == 0) labels_.at(x, y) = label;
        }
  }

  const Basins& basins_;
  int last_label_;
  Image<int32_t>& labels_;
};

}  // namespace

void take_ink(const Basins& basins, const Scribbles& scribbles,
              const std::vector<StrokePixel>& marks, int last_label, Image<int32_t>& labels) {
  InkTaker(basins, last_label, labels).run(scribbles, marks);
}

}  // namespace relievo::understanding
