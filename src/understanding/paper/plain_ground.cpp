#include "understanding/paper/plain_ground.h"

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
#include "kernel/image/image_size.h"
#include "kernel/image/mask_pieces.h"
#include "kernel/image/morphology.h"
#include "understanding/lines/line_map.h"
#include "understanding/paper/page.h"
#include "understanding/paper/paper_light.h"
#include "understanding/paper/pure_white.h"

namespace relievo::understanding {
namespace {

constexpr int whitest_ground = 248;  ///< darkest channel of grounds that are no white paper
constexpr int plain_noise = 3;       ///< difference of channels within one colour
constexpr double plain_share = 0.7;  ///< of the picture's edge that has it
constexpr int most_noise = 16;       ///< difference of channels within grain
/// Differences of channels within which cells count, round by round.
constexpr std::array<double, 6> ground_tolerances = {60, 30, 15, 8, 8, 8};
constexpr int lighter_step = 24;        ///< difference of channels of what is lighter than a ground
constexpr double lighter_share = 0.05;  ///< of the figure
constexpr int ground_noise = 6;         ///< difference of channels of the ground
constexpr int speck_noise = 20;         ///< the same of specks on it
constexpr int half_speck = 2;           ///< px
constexpr double painted_share = 0.01;  ///< of the picture, that is wider than lines
constexpr int darkest_ground = 128;     ///< brightest channel of a ground that no ink is on
constexpr double through_share = 0.2;   ///< of the figure, up to which ground shows through it
constexpr int darkest_through = 60;     ///< brightest channel; darker may be ink
constexpr double smallest_hole = 1e-4;  ///< of the picture
constexpr double least_page = 0.15;     ///< of the picture
constexpr double least_overlap = 0.94;  ///< page_overlap of a page, at least
constexpr double cut_page_share = 0.05;  ///< of the picture's edge that a page reaches at most
constexpr int margin = 4;                ///< px, of the band at the rim that tells a page
constexpr int page_noise = 40;           ///< difference of channels within it
constexpr double rim_share = 0.8;        ///< of it, that has one colour
constexpr int rim = 3;                   ///< px, within which paint and ground blend

using ByteColour = std::array<uint8_t, 3>;

/// What lies around a figure: one colour in slowly changing light.
struct Ground {
  Image8 colour;  ///< RGB
  bool even;      ///< neither grain nor a change of light
  int noise;      ///< difference of channels of what belongs to it, at most
};

/// Largest difference of the channels of a pixel, or of the mean of a cell, from a light.
double difference(const uint8_t* pixel, const Light& light, const Quadratic& terms) {
  double most = 0;
  for (size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(pixel[c] - light[c].dot(terms)));
  return most;
}

int difference(const uint8_t* p, const uint8_t* q) {
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

/// The value of a rank, 0 being the least. Precondition: rank < number of values.
template <class T>
T ranked(std::vector<T> values, size_t rank) {
  const auto nth = values.begin() + static_cast<ptrdiff_t>(rank);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// The median of each channel of some pixels. Precondition: there are some.
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

/// The light of the `first` cells, of which there are some, then of all that agree with it.
Light fit_ground(const LightCells& cells, const std::vector<size_t>& first) {
  std::vector<uint8_t> is_first(cells.terms.size(), 0);
  for (const size_t k : first) is_first[k] = 1;
  const ByteColour start = median_colour(cells.mean, first);
  Light light;
  for (size_t c = 0; c < 3; ++c) light[c] = Quadratic::Unit(0) * start[c];
  for (size_t round = 0; round < ground_tolerances.size(); ++round) {
    std::vector<double> weights(cells.terms.size(), 0);
    for (size_t k = 0; k < weights.size(); ++k) {
      const bool counts = is_first[k] != 0 || 2 * round >= ground_tolerances.size();
      const uint8_t* cell = &cells.mean.pixels[k * cells.mean.channels];
      const double off = difference(cell, light, cells.terms[k]);
      weights[k] = counts && off <= ground_tolerances[round] ? 1 : 0;
    }
    for (int c = 0; c < 3; ++c) light[c] = fit_light(cells, c, weights);
  }
  return light;
}

/// The colour of a light at every pixel.
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

/// The difference from the ground that nine tenths of what shows it along the picture's edge do not
/// exceed; nothing where too little shows it.
std::optional<int> noise_of_edge(const Image8& rgba, const Image8& ground) {
  std::vector<int> shown;
  int64_t all = 0;
  along_edge(rgba.width, rgba.height, [&](int x, int y) {
    const int off = difference(&rgba.at(x, y), &ground.at(x, y));
    ++all;
    if (off <= 2 * most_noise) shown.push_back(off);
  });
  if (static_cast<double>(shown.size()) < plain_share * static_cast<double>(all)) return {};
  const size_t rank = shown.size() * 9 / 10;
  const int noise = ranked(std::move(shown), rank);
  return noise <= most_noise ? std::optional(noise) : std::nullopt;
}

/// The ground of an opaque picture, where most of its edge shows one that is not white.
std::optional<Ground> find_ground(const Image8& rgba) {
  if (least_alpha(rgba) < 255) return {};
  const LightCells cells = light_cells(rgba);
  const Light light = fit_ground(cells, cells_at_edge(cells.mean));
  if (std::min({light[0][0], light[1][0], light[2][0]}) >= whitest_ground) return {};
  Ground ground{paint_light(light, rgba.width, rgba.height), true, ground_noise};
  const std::optional<int> noise = noise_of_edge(rgba, ground.colour);
  if (!noise) return {};
  for (const Quadratic& channel : light)
    ground.even = ground.even && channel.tail<5>().cwiseAbs().maxCoeff() < plain_noise;
  if (*noise <= plain_noise) return ground;
  ground.even = false;
  ground.noise = std::max(ground_noise, 3 * *noise / 2);
  return ground;
}

/// 1 where a pixel has the ground's colour, specks that a codec leaves beside outlines included.
Image8 like_ground(const Image8& rgba, const Ground& ground) {
  const Image8 smooth = ground.noise > ground_noise ? box_blur(rgba, 1) : rgba;
  const auto differs = [&](size_t i, int most) {
    return difference(&smooth.pixels[4 * i], &ground.colour.pixels[3 * i]) > most;
  };
  Image8 other(rgba.width, rgba.height, 1);
  for (size_t i = 0; i < other.pixels.size(); ++i)
    other.pixels[i] = differs(i, ground.noise) ? 1 : 0;
  const Image8 broad = remove_specks(other, half_speck);
  Image8 like(rgba.width, rgba.height, 1);
  for (size_t i = 0; i < like.pixels.size(); ++i) {
    const bool speck = broad.pixels[i] == 0 && !differs(i, speck_noise);
    like.pixels[i] = other.pixels[i] == 0 || speck ? 1 : 0;
  }
  return like;
}

/// Whether a good part of what is not ground is lighter than it, as no paint on paper is.
bool is_lighter(const Image8& rgba, const Ground& ground, const Image8& like) {
  int64_t figure = 0;
  int64_t lighter = 0;
  for (size_t i = 0; i < like.pixels.size(); ++i) {
    if (like.pixels[i] != 0) continue;
    ++figure;
    const uint8_t* p = &rgba.pixels[4 * i];
    const uint8_t* q = &ground.colour.pixels[3 * i];
    lighter += std::max({p[0] - q[0], p[1] - q[1], p[2] - q[2]}) > lighter_step ? 1 : 0;
  }
  return static_cast<double>(lighter) > lighter_share * static_cast<double>(figure);
}

/// Whether what is not ground covers areas, rather than lines bounding them.
bool is_paint_on(const Image8& like) {
  const int half_line = static_cast<int>(widest_line / 2 * std::hypot(like.width, like.height));
  const Image8 wide = min_filter(complement(like), std::max(3, half_line));
  const auto count = std::count(wide.pixels.begin(), wide.pixels.end(), 1);
  return static_cast<double>(count) > painted_share * static_cast<double>(wide.pixels.size());
}

/// By piece of what is like the ground, how far its mean is from that, the largest of the channels.
std::vector<double> mean_differences(const Image8& rgba, const Ground& ground,
                                     const Components& pieces) {
  std::vector<std::array<double, 3>> sums(pieces.areas.size());
  for (size_t i = 0; i < pieces.label.pixels.size(); ++i)
    for (size_t c = 0; c < 3; ++c)
      sums[pieces.label.pixels[i]][c] += rgba.pixels[4 * i + c] - ground.colour.pixels[3 * i + c];
  std::vector<double> differences;
  for (size_t k = 0; k < sums.size(); ++k) {
    const double most =
        std::max({std::abs(sums[k][0]), std::abs(sums[k][1]), std::abs(sums[k][2])});
    differences.push_back(most / static_cast<double>(std::max(int64_t{1}, pieces.areas[k])));
  }
  return differences;
}

/// 1 where the ground is: of what is `like` it what reaches the edge, and what a painted figure or
/// chalk lines enclose. Nothing where ink lines on a bright ground may bound areas that it fills.
Image8 ground_of(const Image8& rgba, const Ground& ground, Image8 like) {
  if (!ground.even && !is_lighter(rgba, ground, like)) return {};
  const bool painted = is_paint_on(like);
  const uint8_t* middle = &ground.colour.at(like.width / 2, like.height / 2);
  const int brightest = *std::max_element(middle, middle + 3);
  const bool dark = brightest < darkest_ground;
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
  // Eyes may be nearly as dark as a dark ground; what shows through is the ground itself.
  const std::vector<double> off =
      through ? mean_differences(rgba, ground, pieces) : std::vector<double>();
  for (size_t k = 1; k < off.size(); ++k)
    if (static_cast<double>(pieces.areas[k]) > least && off[k] <= plain_noise) reaches[k] = 1;
  for (size_t i = 0; i < like.pixels.size(); ++i) like.pixels[i] = reaches[pieces.label.pixels[i]];
  return like;
}

/// The colour that most of a mask has along its rim, as a page has; nothing where there is none.
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

/// Whether what lies on the ground is a page: lighter, not small, and a quadrilateral.
bool is_page(const Image8& rgba, const Ground& ground, const Image8& mask) {
  const auto area = static_cast<double>(std::count(mask.pixels.begin(), mask.pixels.end(), 1));
  const auto is_inside = [&](int x, int y) { return mask.at(x, y) != 0; };
  if (area < least_page * static_cast<double>(mask.pixels.size()) ||
      share_of_edge(mask.width, mask.height, is_inside) > cut_page_share ||
      page_overlap(mask) < least_overlap)
    return false;
  const std::optional<ByteColour> colour = colour_of_rim(rgba, mask);
  const uint8_t* around = &ground.colour.at(mask.width / 2, mask.height / 2);
  return colour && (*colour)[0] > around[0] && (*colour)[1] > around[1] && (*colour)[2] > around[2];
}

/// The pixel within `rim` px of (x, y) that is nearest of those that no ground is so near to, or
/// -1.
int64_t nearest_core(const Image8& near_ground, int x, int y) {
  int64_t best = -1;
  int least = 2 * rim * rim + 1;
  for (int v = std::max(0, y - rim); v <= std::min(near_ground.height - 1, y + rim); ++v)
    for (int u = std::max(0, x - rim); u <= std::min(near_ground.width - 1, x + rim); ++u) {
      const int distance = (u - x) * (u - x) + (v - y) * (v - y);
      if (near_ground.at(u, v) != 0 || distance >= least) continue;
      least = distance;
      best = static_cast<int64_t>(v) * near_ground.width + u;
    }
  return best;
}

/// How much of a pixel is paint of one colour, the rest of it ground: 0 to 1 and beyond.
double share_of_paint(const uint8_t* pixel, const uint8_t* paint, const uint8_t* ground) {
  double along = 0;
  double all = 0;
  for (size_t c = 0; c < 3; ++c) {
    along += (pixel[c] - ground[c]) * (paint[c] - ground[c]);
    all += (paint[c] - ground[c]) * (paint[c] - ground[c]);
  }
  return all > 0 ? along / all : 1;
}

/// The page continued over the table in its own light; empty where it is too narrow to have one.
Image8 spread_page(const Image8& rgba, const Image8& page) {
  const Image8 within = min_filter(page, margin);
  const LightCells cells = light_cells(rgba);
  std::vector<size_t> on_page;
  for (int y = 0; y < cells.mean.height; ++y)
    for (int x = 0; x < cells.mean.width; ++x)
      if (within.at(x * rgba.width / cells.mean.width, y * rgba.height / cells.mean.height) != 0)
        on_page.push_back(static_cast<size_t>(y) * cells.mean.width + x);
  if (on_page.empty()) return {};
  const Image8 light = paint_light(fit_ground(cells, on_page), rgba.width, rgba.height);
  Image8 spread = rgba;
  for (size_t i = 0; i < within.pixels.size(); ++i)
    if (within.pixels[i] == 0) std::copy_n(&light.pixels[3 * i], 3, &spread.pixels[4 * i]);
  return spread;
}

/// The drawing cut out, transparent where `ground` is, with the blend at the rim gone.
Image8 cut_out(const Image8& rgba, const Image8& ground, const Image8& colour) {
  const Image8 near_ground = max_filter(ground, rim);
  Image8 cut = rgba;
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      const auto i = static_cast<size_t>(y) * rgba.width + x;
      if (ground.pixels[i] != 0) cut.pixels[4 * i + 3] = 0;
      if (ground.pixels[i] != 0 || near_ground.pixels[i] == 0) continue;
      const int64_t core = nearest_core(near_ground, x, y);
      if (core < 0) continue;
      const uint8_t* paint = &rgba.pixels[4 * static_cast<size_t>(core)];
      const bool most = share_of_paint(&rgba.pixels[4 * i], paint, &colour.pixels[3 * i]) >= 0.5;
      std::copy(paint, paint + 3, &cut.pixels[4 * i]);
      cut.pixels[4 * i + 3] = most ? 255 : 0;
    }
  return cut;
}

/// The painted figure on a ground, to which what is `like` it belongs, cut out; empty where it is
/// none.
Image8 cut_figure(const Image8& rgba, const Ground& found, Image8 like) {
  Image8 ground = ground_of(rgba, found, std::move(like));
  if (ground.empty()) return {};
  const Image8 rest = complement(ground);
  const double filled = share_of_box(rest);
  if (found.even && (filled == 0 || filled > framed_share)) return {};
  if (!found.even) ground = complement(without_small_pieces(rest));
  return cut_out(rgba, ground, found.colour);
}

}  // namespace

WithoutGround without_ground(const Image8& rgba) {
  assert(rgba.channels == 4);
  const std::optional<Ground> found = find_ground(rgba);
  if (!found) return {};
  Image8 like = like_ground(rgba, *found);
  const Image8 page = without_holes(without_small_pieces(complement(like)));
  if (!is_page(rgba, *found, page)) {
    Image8 cut = cut_figure(rgba, *found, std::move(like));
    const bool is_cut = !cut.empty();
    return {std::move(cut), is_cut};
  }
  Image8 spread = spread_page(rgba, page);
  const std::optional<Ground> paper = find_ground(spread);  // which may be coloured
  Image8 cut = paper ? cut_figure(spread, *paper, like_ground(spread, *paper)) : Image8{};
  const bool is_cut = !cut.empty();
  return {is_cut ? std::move(cut) : std::move(spread), is_cut};
}

}  // namespace relievo::understanding
