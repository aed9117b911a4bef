#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "kernel/image/enlarge.h"
#include "relievo/pixel_art.h"

namespace relievo {
namespace {

// Tuned on the sprites of a game and on drawings and icons of 16 to 256 px: nine sprites of ten are
// recognised, and one of a hundred others is taken for one.
constexpr size_t most_colours = 64;
constexpr double most_blended = 0.3;  ///< share of pixels on steps that blend both sides
constexpr double least_step = 60;     ///< distance of colours on both sides of a step
constexpr double on_segment = 0.03;   ///< squared distance of blends from the mixtures, of a step's
constexpr double least_portion = 0.1;  ///< of either side in a blend

using WeightedColour = std::array<double, 4>;

/// A picture with one pixel for each square.
struct Squares {
  const Image8& rgba;
  int side;

  int width() const { return rgba.width / side; }
  int height() const { return rgba.height / side; }
  const uint8_t* at(int x, int y) const { return &rgba.at(side * x, side * y); }

  /// Returns colours that count by their alpha.
  WeightedColour colour(int x, int y) const {
    const uint8_t* p = at(x, y);
    const double share = p[3] / 255.0;
    return {p[0] * share, p[1] * share, p[2] * share, 1.0 * p[3]};
  }
};

bool has_few_colours(const Squares& squares) {
  std::vector<std::array<uint8_t, 4>> colours;
  for (int y = 0; y < squares.height(); ++y)
    for (int x = 0; x < squares.width() && colours.size() <= most_colours; ++x) {
      const auto is_like = [p = squares.at(x, y)](const std::array<uint8_t, 4>& known) {
        return is_same_colour(p, known.data());
      };
      if (std::any_of(colours.begin(), colours.end(), is_like)) continue;
      const uint8_t* p = squares.at(x, y);
      colours.push_back({p[0], p[1], p[2], p[3]});
    }
  return colours.size() <= most_colours;
}

/// Counts pixels between different colours.
struct Steps {
  int all = 0;
  int blended = 0;  ///< of them, mixtures of the colours on both sides
};

void count(const WeightedColour& before, const WeightedColour& here, const WeightedColour& after,
           bool& step, bool& blend) {
  double length = 0;
  double along = 0;
  double away = 0;
  for (size_t c = 0; c < 4; ++c) {
    const double to_after = after[c] - before[c];
    const double to_here = here[c] - before[c];
    length += to_after * to_after;
    along += to_here * to_after;
    away += to_here * to_here;
  }
  if (length < least_step * least_step) return;
  step = true;
  const double portion = along / length;
  blend = blend || (portion > least_portion && portion < 1 - least_portion &&
                    away - along * portion < on_segment * length);
}

Steps steps_of(const Squares& squares) {
  Steps steps;
  for (int y = 1; y + 1 < squares.height(); ++y)
    for (int x = 1; x + 1 < squares.width(); ++x) {
      const WeightedColour here = squares.colour(x, y);
      bool step = false;
      bool blend = false;
      count(squares.colour(x - 1, y), here, squares.colour(x + 1, y), step, blend);
      count(squares.colour(x, y - 1), here, squares.colour(x, y + 1), step, blend);
      steps.all += step ? 1 : 0;
      steps.blended += blend ? 1 : 0;
    }
  return steps;
}

}  // namespace

int own_pixels(const Image8& rgba, std::optional<bool> is_pixel_art) {
  if (rgba.empty() || !is_pixel_art.value_or(true)) return 0;
  const Squares squares{rgba, square_side(rgba)};
  if (is_pixel_art) return squares.side;
  if (std::max(squares.width(), squares.height()) >= small_side || !has_few_colours(squares))
    return 0;
  const Steps steps = steps_of(squares);
  return steps.all > 0 && steps.blended <= most_blended * steps.all ? squares.side : 0;
}

int map_side(const Drawing& drawing, int usual) {
  if (drawing.pixel_art == 0) return usual;
  const int own = std::max(drawing.rgba.width, drawing.rgba.height) / drawing.pixel_art;
  return own * std::max(1, usual / own);
}

}  // namespace relievo
