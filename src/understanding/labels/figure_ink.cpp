#include "understanding/labels/figure_ink.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "kernel/image/components.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr int clear_ink = 64;           ///< of 255; what is fainter is the blur of a line
constexpr double contour_reach = 0.8;   ///< widths of a line, which its outer half has at most
constexpr double speck_length = 3;      ///< widths of a line, up to which ink is part of a part
constexpr double tube_length = 0.03;    ///< of the figure's diagonal, from which on ink is a tube
constexpr double apart_length = 0.08;   ///< likewise, where it touches no part
constexpr double given_up_share = 0.2;  ///< of ink in areas that strokes made background
constexpr double thinnest_tube = 0.01;  ///< of the figure's diagonal

/// A piece of ink that bounds nothing.
struct LooseInk {
  std::vector<int32_t> pixels;
  Box2 box;
  int beside = 0;        ///< the label that it touches, or 0
  int64_t in_areas = 0;  ///< pixels in areas that strokes made background
};

class InkTaker {
 public:
  InkTaker(const Basins& basins, int last_label, Image<int32_t>& labels)
      : basins_(basins), last_label_(last_label), labels_(labels) {}

  void run(const InkVotes& votes) {
    grow_contours();
    std::vector<LooseInk> pieces = loose_pieces();
    const double diagonal = figure_diagonal(pieces);
    const std::map<int32_t, int> said = said_of(votes);
    for (const LooseInk& piece : pieces) settle(piece, diagonal, said);
  }

 private:
  bool is_free_ink(size_t i) const {
    return basins_.barrier.pixels[i] == LineMap::line && labels_.pixels[i] == 0 &&
           basins_.ink.pixels[i] >= clear_ink;
  }

  /// A label beside the pixel, or 0.
  int32_t label_beside(int32_t i) const {
    const int x = i % labels_.width;
    const int y = i / labels_.width;
    for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
      const int u = x + dx;
      const int v = y + dy;
      if (u >= 0 && v >= 0 && u < labels_.width && v < labels_.height && labels_.at(u, v) != 0)
        return labels_.at(u, v);
    }
    return 0;
  }

  /// Step by step outwards from the parts.
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
    Image8 mask(labels_.width, labels_.height, 1);
    for (size_t i = 0; i < labels_.pixels.size(); ++i) mask.pixels[i] = is_free_ink(i) ? 1 : 0;
    const Components found = connected_components(mask, Connectivity::corners);
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

  /// Of the box around all parts, and where there are none, around the longest ink.
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

  std::map<int32_t, int> said_of(const InkVotes& votes) const {
    std::map<int32_t, int> said;
    for (const MarkedPixel& mark : votes.marks)
      if (is_free_ink(mark.pixel)) said[mark.pixel] = votes.label_of_stroke[mark.stroke];
    return said;
  }

  /// The pixels of a piece by the stroke that is nearest along the ink; none where no stroke lies
  /// on it.
  std::map<int, std::vector<int32_t>> divided(const LooseInk& piece,
                                              const std::map<int32_t, int>& said) const {
    std::map<int, std::vector<int32_t>> pixels_of_label;
    std::map<int32_t, int> label_of;
    std::vector<int32_t> queue;
    for (const int32_t i : piece.pixels)
      if (const auto found = said.find(i); found != said.end()) {
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

  /// Whether it bounded an area that strokes made background.
  static bool is_given_up(const LooseInk& piece) {
    return static_cast<double>(piece.in_areas) >
           given_up_share * static_cast<double>(piece.pixels.size());
  }

  bool crosses_the_picture(const LooseInk& piece) const {
    return (piece.box.min.x < 2 && piece.box.max.x > labels_.width - 2) ||
           (piece.box.min.y < 2 && piece.box.max.y > labels_.height - 2);
  }

  /// Whether the picture's edge cuts off most of it, as it cuts off what lies beside a page.
  bool lies_along_edge(const LooseInk& piece) const {
    const auto at_edge = std::count_if(piece.pixels.begin(), piece.pixels.end(), [&](int32_t i) {
      const int x = i % labels_.width;
      const int y = i / labels_.width;
      return x == 0 || y == 0 || x == labels_.width - 1 || y == labels_.height - 1;
    });
    return static_cast<double>(at_edge) > 0.5 * distance(piece.box.min, piece.box.max);
  }

  void settle(const LooseInk& piece, double diagonal, const std::map<int32_t, int>& said) {
    const auto wanted = divided(piece, said);
    for (const auto& [label, pixels] : wanted)
      if (label > 0) lay_tube(pixels, label, diagonal);
    if (!wanted.empty() || crosses_the_picture(piece) || lies_along_edge(piece) ||
        is_given_up(piece))
      return;
    const double extent = distance(piece.box.min, piece.box.max);
    const bool speck = extent < std::max(speck_length * basins_.line_width, tube_length * diagonal);
    if (!speck && (piece.beside != 0 || extent >= apart_length * diagonal))
      lay_tube(piece.pixels, ++last_label_, diagonal);
    else if (piece.beside != 0)
      for (const int32_t i : piece.pixels) labels_.pixels[i] = piece.beside;
  }

  /// The ink, as wide as a tube needs to be.
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

void take_ink(const Basins& basins, const InkVotes& votes, int last_label, Image<int32_t>& labels) {
  InkTaker(basins, last_label, labels).run(votes);
}

}  // namespace relievo::understanding
