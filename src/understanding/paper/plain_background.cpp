#include "understanding/paper/plain_background.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/components.h"
#include "kernel/image/compose.h"
#include "kernel/image/image_size.h"
#include "kernel/image/mask.h"
#include "kernel/image/morphology.h"
#include "understanding/lines/line_map.h"
#include "understanding/paper/page.h"
#include "understanding/paper/paper_light.h"
#include "understanding/paper/pure_white.h"

namespace relievo::understanding {
namespace {

// Colours differ by their largest difference of a channel, of 255.
constexpr int whitest_background = 248;  ///< darkest channel; lighter backgrounds are white paper
constexpr int plain_noise = 3;           ///< difference within a background of one even colour
constexpr double plain_share = 0.7;      ///< least share of the picture's border that shows it
constexpr int most_noise = 16;           ///< largest difference within a grainy background
/// Differences up to which cells count when the light is fitted, by round.
constexpr std::array<double, 6> fit_tolerances = {60, 30, 15, 8, 8, 8};
constexpr int lighter_step = 24;  ///< difference of a pixel that is lighter than the background
constexpr double lighter_share = 0.05;  ///< least share of such pixels in a figure on uneven light
constexpr int background_noise = 6;     ///< difference of a pixel of the background at most
constexpr int speck_noise = 20;         ///< the same for a speck of compression noise
constexpr int half_speck = 2;           ///< half width of such a speck, px
constexpr double wide_share = 0.01;  ///< least share of the picture wider than lines in a painting
constexpr int darkest_inked = 128;   ///< brightest channel; no ink is drawn on darker backgrounds
constexpr double through_share = 0.2;    ///< largest area of background inside a figure, per figure
constexpr int darkest_through = 60;      ///< brightest channel; darker areas in a figure may be ink
constexpr double smallest_hole = 1e-4;   ///< least area of background in a figure, per picture
constexpr double least_page = 0.15;      ///< least area of a page, per picture
constexpr double least_overlap = 0.94;   ///< least page_overlap of a page
constexpr double cut_page_share = 0.05;  ///< largest share of the border that a page reaches
constexpr int margin = 4;                ///< px, width of the band along a page's rim
constexpr int page_noise = 40;           ///< difference from the median of the band at most
constexpr double rim_share = 0.8;        ///< least share of the band that has that colour
constexpr int blend = 3;                 ///< px, width in which paint and background blend

using ByteColour = std::array<uint8_t, 3>;

/// A background of one colour in slowly changing light.
struct Background {
  Image8 colour;  ///< [drawing size] RGB
  bool even;      ///< without grain or a change of light
  int noise;      ///< largest difference of its pixels
};

/// Computes the difference of a pixel, or of the mean of a cell, from a light.
double difference(const uint8_t* pixel, const Light& light, const Quadratic& terms) {
  double most = 0;
  for (size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(pixel[c] - light[c].dot(terms)));
  return most;
}

int difference(const uint8_t* p, const uint8_t* q) {
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

/// Returns the value of a rank, 0 being the least. Precondition: rank < number of values.
template <class T>
T ranked(std::vector<T> values, size_t rank) {
  const auto nth = values.begin() + static_cast<ptrdiff_t>(rank);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Computes the median of each channel of some pixels. Precondition: there are some.
ByteColour median_colour(const Image8& image, const std::vector<size_t>& pixels) {
  ByteColour colour;
  for (size_t c = 0; c < 3; ++c) {
    std::vector<uint8_t> values;
    for (const size_t i : pixels) values.push_back(image.pixels[i * image.channels + c]);
    colour[c] = ranked(std::move(values), pixels.size() / 2);
  }
  return colour;
}

std::vector<size_t> cells_at_edge(const Image8& cells) {
  std::vector<size_t> at_edge;
  along_edge(cells.width, cells.height,
             [&](int x, int y) { at_edge.push_back(static_cast<size_t>(y) * cells.width + x); });
  return at_edge;
}

/// Fits light to the `first` cells, of which there is at least one, then to all that agree with it.
Light fit_background(const Image8& cells, const std::vector<size_t>& first) {
  const std::vector<Quadratic> terms = light_terms(cells);
  std::vector<uint8_t> is_first(terms.size(), 0);
  for (const size_t k : first) is_first[k] = 1;
  const ByteColour start = median_colour(cells, first);
  Light light;
  for (size_t c = 0; c < 3; ++c) light[c] = Quadratic::Unit(0) * start[c];
  for (size_t round = 0; round < fit_tolerances.size(); ++round) {
    std::vector<double> weights(terms.size(), 0);
    for (size_t k = 0; k < weights.size(); ++k) {
      const bool counts = is_first[k] != 0 || 2 * round >= fit_tolerances.size();
      const uint8_t* cell = &cells.pixels[k * cells.channels];
      const double off = difference(cell, light, terms[k]);
      weights[k] = counts && off <= fit_tolerances[round] ? 1 : 0;
    }
    for (int c = 0; c < 3; ++c) light[c] = fit_light(cells, terms, c, weights);
  }
  return light;
}

/// Evaluates a light at every pixel, RGB.
Image8 paint_light(const Light& light, int width, int height) {
  std::vector<double> columns;
  for (int x = 0; x < width; ++x) columns.push_back(light_terms(x, 0, width, height)[1]);
  Image8 rgb(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int c = 0; c < 3; ++c) {
      const double v = light_terms(0, y, width, height)[2];
      const double constant = light[c][0] + light[c][2] * v + light[c][5] * v * v + 0.5;
      const double linear = light[c][1] + light[c][4] * v;
      for (int x = 0; x < width; ++x) {
        const double value = constant + (linear + light[c][3] * columns[x]) * columns[x];
        rgb.at(x, y, c) = static_cast<uint8_t>(std::clamp(value, 0.0, 255.0));
      }
    }
  return rgb;
}

/// Computes the ninth decile of the differences from the background along the picture's border,
/// over the pixels that show it. Nothing where too few do, or where it is too large.
std::optional<int> noise_of_edge(const Image8& rgba, const Image8& background) {
  std::vector<int> shown;
  int64_t all = 0;
  along_edge(rgba.width, rgba.height, [&](int x, int y) {
    const int off = difference(&rgba.at(x, y), &background.at(x, y));
    ++all;
    if (off <= 2 * most_noise) shown.push_back(off);
  });
  if (static_cast<double>(shown.size()) < plain_share * static_cast<double>(all)) return {};
  const size_t rank = shown.size() * 9 / 10;
  const int noise = ranked(std::move(shown), rank);
  return noise <= most_noise ? std::optional(noise) : std::nullopt;
}

/// Finds the background of an opaque picture; nothing where it is white or where too little of the
/// picture's border shows it.
std::optional<Background> find_background(const Image8& rgba) {
  if (least_alpha(rgba) < 255) return {};
  const Image8 cells = light_cells(rgba);
  const Light light = fit_background(cells, cells_at_edge(cells));
  if (std::min({light[0][0], light[1][0], light[2][0]}) >= whitest_background) return {};
  Background background{paint_light(light, rgba.width, rgba.height), true, background_noise};
  const std::optional<int> noise = noise_of_edge(rgba, background.colour);
  if (!noise) return {};
  for (const Quadratic& channel : light)
    background.even = background.even && channel.tail<5>().cwiseAbs().maxCoeff() < plain_noise;
  if (*noise <= plain_noise) return background;
  background.even = false;
  background.noise = std::max(background_noise, 3 * *noise / 2);
  return background;
}

/// Returns 1 where a pixel has the background's colour, or is a speck of compression noise on it.
Image8 like_background(const Image8& rgba, const Background& background) {
  const Image8 smooth = background.noise > background_noise ? box_blur(rgba, 1) : rgba;
  const auto differs = [&](size_t i, int most) {
    return difference(&smooth.pixels[4 * i], &background.colour.pixels[3 * i]) > most;
  };
  const Image8 other =
      mask_where(rgba.width, rgba.height, [&](size_t i) { return differs(i, background.noise); });
  const Image8 broad = remove_specks(other, half_speck);
  return mask_where(rgba.width, rgba.height, [&](size_t i) {
    return other.pixels[i] == 0 || (broad.pixels[i] == 0 && !differs(i, speck_noise));
  });
}

/// Returns whether a good part of the figure is lighter than the background, as no paint on paper
/// is.
bool is_lighter(const Image8& rgba, const Background& background, const Image8& like) {
  int64_t figure = 0;
  int64_t lighter = 0;
  for (size_t i = 0; i < like.pixels.size(); ++i) {
    if (like.pixels[i] != 0) continue;
    ++figure;
    const uint8_t* p = &rgba.pixels[4 * i];
    const uint8_t* q = &background.colour.pixels[3 * i];
    lighter += std::max({p[0] - q[0], p[1] - q[1], p[2] - q[2]}) > lighter_step ? 1 : 0;
  }
  return static_cast<double>(lighter) > lighter_share * static_cast<double>(figure);
}

/// Returns whether the figure is painted, not drawn in lines.
bool is_paint_on(const Image8& like) {
  const int half_line = static_cast<int>(widest_line / 2 * std::hypot(like.width, like.height));
  const Image8 wide = min_filter(complement(like), std::max(3, half_line));
  return static_cast<double>(pixel_count(wide)) >
         wide_share * static_cast<double>(wide.pixels.size());
}

/// Computes for each piece of the `pieces` the difference of its mean from the background.
std::vector<double> mean_differences(const Image8& rgba, const Background& background,
                                     const Components& pieces) {
  std::vector<std::array<double, 3>> sums(pieces.areas.size());
  for (size_t i = 0; i < pieces.label.pixels.size(); ++i)
    for (size_t c = 0; c < 3; ++c)
      sums[pieces.label.pixels[i]][c] +=
          rgba.pixels[4 * i + c] - background.colour.pixels[3 * i + c];
  std::vector<double> differences;
  for (size_t k = 0; k < sums.size(); ++k) {
    const double most =
        std::max({std::abs(sums[k][0]), std::abs(sums[k][1]), std::abs(sums[k][2])});
    differences.push_back(most / static_cast<double>(std::max(int64_t{1}, pieces.areas[k])));
  }
  return differences;
}

/// Returns 1 on the background: pixels `like` it that are connected to the picture's border, or are
/// seen through a painted figure or between chalk lines. Empty where ink lines on a bright
/// background may bound areas of its colour.
Image8 background_pixels(const Image8& rgba, const Background& background, Image8 like) {
  if (!background.even && !is_lighter(rgba, background, like)) return {};
  const bool painted = is_paint_on(like);
  const uint8_t* middle = &background.colour.at(like.width / 2, like.height / 2);
  const int brightest = *std::max_element(middle, middle + 3);
  const bool dark = brightest < darkest_inked;
  if (!painted && !dark) return {};
  const Components pieces = connected_components(like, Connectivity::sides);
  std::vector<uint8_t> reaches = pieces_at_edge(pieces);
  int64_t outside = 0;
  int64_t enclosed = 0;
  for (size_t k = 1; k < reaches.size(); ++k)
    (reaches[k] != 0 ? outside : enclosed) += pieces.areas[k];
  const auto figure = static_cast<double>(like.pixels.size()) - static_cast<double>(outside);
  const bool little = static_cast<double>(enclosed) < through_share * figure;
  if (painted && !little && !dark) return {};
  const bool through = !painted || (little && brightest > darkest_through);
  const double least = smallest_hole * static_cast<double>(like.pixels.size());
  // Eyes may be nearly as dark as a dark background, so holes must have exactly its colour.
  const std::vector<double> off =
      through ? mean_differences(rgba, background, pieces) : std::vector<double>();
  for (size_t k = 1; k < off.size(); ++k)
    if (static_cast<double>(pieces.areas[k]) > least && off[k] <= plain_noise) reaches[k] = 1;
  for (size_t i = 0; i < like.pixels.size(); ++i) like.pixels[i] = reaches[pieces.label.pixels[i]];
  return like;
}

/// Returns the colour that most of a mask has along its rim, as a page has; nothing where there is
/// none.
std::optional<ByteColour> colour_of_rim(const Image8& rgba, const Image8& mask) {
  const Image8 outer = min_filter(mask, margin);
  const Image8 inner = min_filter(outer, margin);
  std::vector<size_t> band;
  for (size_t i = 0; i < mask.pixels.size(); ++i)
    if (outer.pixels[i] != inner.pixels[i]) band.push_back(i);
  if (band.empty()) return {};
  const ByteColour colour = median_colour(rgba, band);
  const auto like = std::count_if(band.begin(), band.end(), [&](size_t i) {
    return difference(&rgba.pixels[4 * i], colour.data()) <= page_noise;
  });
  if (static_cast<double>(like) < rim_share * static_cast<double>(band.size())) return {};
  return colour;
}

/// Returns whether a mask on the background is a page: lighter, not small, and a quadrilateral.
bool is_page(const Image8& rgba, const Background& background, const Image8& mask) {
  const auto area = static_cast<double>(pixel_count(mask));
  const auto is_inside = [&](int x, int y) { return mask.at(x, y) != 0; };
  if (area < least_page * static_cast<double>(mask.pixels.size()) ||
      share_of_edge(mask.width, mask.height, is_inside) > cut_page_share ||
      page_overlap(mask) < least_overlap)
    return false;
  const std::optional<ByteColour> colour = colour_of_rim(rgba, mask);
  const uint8_t* around = &background.colour.at(mask.width / 2, mask.height / 2);
  return colour && (*colour)[0] > around[0] && (*colour)[1] > around[1] && (*colour)[2] > around[2];
}

/// Returns the nearest pixel within `blend` px of (x, y) that is pure paint, or -1. Pixels are 1 in
/// `near_background` where the background is so near that it blends with the paint.
int64_t nearest_core(const Image8& near_background, int x, int y) {
  int64_t best = -1;
  int least = 2 * blend * blend + 1;
  for (int v = std::max(0, y - blend); v <= std::min(near_background.height - 1, y + blend); ++v)
    for (int u = std::max(0, x - blend); u <= std::min(near_background.width - 1, x + blend); ++u) {
      const int distance = (u - x) * (u - x) + (v - y) * (v - y);
      if (near_background.at(u, v) != 0 || distance >= least) continue;
      least = distance;
      best = static_cast<int64_t>(v) * near_background.width + u;
    }
  return best;
}

/// Computes the share of paint in a pixel that blends paint and background by projecting its colour
/// onto the line between theirs; not clamped to [0, 1].
double share_of_paint(const uint8_t* pixel, const uint8_t* paint, const uint8_t* background) {
  double along = 0;
  double all = 0;
  for (size_t c = 0; c < 3; ++c) {
    along += (pixel[c] - background[c]) * (paint[c] - background[c]);
    all += (paint[c] - background[c]) * (paint[c] - background[c]);
  }
  return all > 0 ? along / all : 1;
}

/// Continues a page over its table in the page's own light. Empty where the page is too narrow.
Image8 spread_page(const Image8& rgba, const Image8& page) {
  const Image8 within = min_filter(page, margin);
  const Image8 cells = light_cells(rgba);
  std::vector<size_t> on_page;
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x)
      if (within.at(x * rgba.width / cells.width, y * rgba.height / cells.height) != 0)
        on_page.push_back(static_cast<size_t>(y) * cells.width + x);
  if (on_page.empty()) return {};
  const Image8 light = paint_light(fit_background(cells, on_page), rgba.width, rgba.height);
  Image8 spread = rgba;
  for (size_t i = 0; i < within.pixels.size(); ++i)
    if (within.pixels[i] == 0) std::copy_n(&light.pixels[3 * i], 3, &spread.pixels[4 * i]);
  return spread;
}

/// Makes the drawing transparent where `background` is 1. Pixels in which paint and background
/// blend become paint alone or transparent. `colour` is that of the background.
Image8 cut_out(const Image8& rgba, const Image8& background, const Image8& colour) {
  const Image8 near_background = max_filter(background, blend);
  Image8 cut = rgba;
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const auto i = static_cast<size_t>(y) * rgba.width + x;
      if (background.pixels[i] != 0) cut.pixels[4 * i + 3] = 0;
      if (background.pixels[i] != 0 || near_background.pixels[i] == 0) continue;
      const int64_t core = nearest_core(near_background, x, y);
      if (core < 0) continue;
      const uint8_t* paint = &rgba.pixels[4 * static_cast<size_t>(core)];
      const bool most = share_of_paint(&rgba.pixels[4 * i], paint, &colour.pixels[3 * i]) >= 0.5;
      std::copy(paint, paint + 3, &cut.pixels[4 * i]);
      cut.pixels[4 * i + 3] = most ? 255 : 0;
    }
  return cut;
}

/// Cuts out the painted figure in front of a background, whose colour the pixels of `like` have.
/// Empty where there is none.
Image8 cut_figure(const Image8& rgba, const Background& found, Image8 like) {
  Image8 background = background_pixels(rgba, found, std::move(like));
  if (background.empty()) return {};
  const Image8 rest = complement(background);
  const double filled = share_of_box(rest);
  if (found.even && (filled == 0 || filled > framed_share)) return {};
  if (!found.even) background = complement(without_small_pieces(rest));
  return cut_out(rgba, background, found.colour);
}

}  // namespace

WithoutBackground without_background(const Image8& rgba) {
  assert(rgba.channels == 4);
  const std::optional<Background> found = find_background(rgba);
  if (!found) return {};
  Image8 like = like_background(rgba, *found);
  const Image8 page = without_holes(without_small_pieces(complement(like)));
  if (!is_page(rgba, *found, page)) {
    Image8 cut = cut_figure(rgba, *found, std::move(like));
    const bool is_cut = !cut.empty();
    return {std::move(cut), is_cut};
  }
  Image8 spread = spread_page(rgba, page);
  const std::optional<Background> paper = find_background(spread);  // it may be coloured
  Image8 cut = paper ? cut_figure(spread, *paper, like_background(spread, *paper)) : Image8{};
  const bool is_cut = !cut.empty();
  return {is_cut ? std::move(cut) : std::move(spread), is_cut};
}

}  // namespace relievo::understanding
