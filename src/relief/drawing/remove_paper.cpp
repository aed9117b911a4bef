#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "kernel/image/components.h"
#include "kernel/image/compose.h"
#include "kernel/image/filters.h"
#include "kernel/image/image_size.h"
#include "kernel/image/morphology.h"
#include "relief/drawing/figure_mask.h"
#include "relief/drawing/line_map.h"

namespace relievo {
namespace {

constexpr int fit_side = 48;          ///< cells along the longer side that the light is fitted to
constexpr int fit_rounds = 12;        ///< of reweighting at most; weights settle in about eight
constexpr double dark_weight = 0.02;  ///< of cells below the fit, which may be ink or paint
constexpr float darkest_paper = 40;   ///< light below which nothing is divided out

constexpr int whitest_ground = 248;     ///< darkest channel of grounds that are no white paper
constexpr int plain_noise = 3;          ///< difference of channels within one colour
constexpr double plain_share = 0.9;     ///< of the picture's edge that has it
constexpr int ground_noise = 6;         ///< difference of channels of the ground
constexpr int speck_noise = 20;         ///< the same of specks on it
constexpr int half_speck = 2;           ///< px
constexpr double painted_share = 0.01;  ///< of the picture, that is wider than lines
constexpr int darkest_ground = 128;     ///< brightest channel of a ground that no ink is on
constexpr double through_share = 0.2;   ///< of the figure, up to which ground shows through it
constexpr int darkest_through = 60;     ///< brightest channel; darker may be ink
constexpr double smallest_hole = 1e-4;  ///< of the picture
constexpr int whitest_page = 55;        ///< difference of channels of a page from white
constexpr double page_share = 0.6;      ///< the same where most of it is white
constexpr int rim = 2;                  ///< px, within which paint and ground blend

uint8_t least_alpha(const Image8& rgba) {
  uint8_t least = 255;
  for (size_t i = 3; i < rgba.pixels.size(); i += 4)
    least = rgba.pixels[i] < least ? rgba.pixels[i] : least;
  return least;
}

/// An opaque picture without its alpha.
Image8 drop_alpha(const Image8& rgba) {
  Image8 rgb(rgba.width, rgba.height, 3);
  const uint8_t* in = rgba.pixels.data();
  uint8_t* out = rgb.pixels.data();
  for (size_t left = rgba.pixels.size() / 4; left > 0; --left, in += 4, out += 3) {
    out[0] = in[0];
    out[1] = in[1];
    out[2] = in[2];
  }
  return rgb;
}

Image8 lay_on_white(const Image8& rgba, bool invert) {
  const uint8_t flip = invert ? 255 : 0;
  Image8 rgb(rgba.width, rgba.height, 3);
  const uint8_t* in = rgba.pixels.data();
  for (uint8_t* out = rgb.pixels.data(); out != rgb.pixels.data() + rgb.pixels.size(); in += 4) {
    const int alpha = in[3];
    for (int c = 0; c < 3; ++c) *out++ = on_paper(in[c] ^ flip, alpha);
  }
  return rgb;
}

using Quadratic = Eigen::Matrix<double, 6, 1>;

/// Terms of a quadratic at x, y in [-1, 1].
Quadratic terms(double x, double y) {
  Quadratic t;
  t << 1, x, y, x * x, x * y, y * y;
  return t;
}

double position(int i, int n) { return n < 2 ? 0 : 2.0 * i / (n - 1) - 1; }

/// The terms at every cell, row by row.
std::vector<Quadratic> terms_of_cells(int width, int height) {
  std::vector<Quadratic> all;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) all.push_back(terms(position(x, width), position(y, height)));
  return all;
}

/// The quadratic of least squares through one channel.
Quadratic weighted_fit(const Image8& cells, int channel, const std::vector<Quadratic>& terms,
                       const std::vector<double>& weights) {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
  Quadratic b = Quadratic::Zero();
  for (size_t k = 0; k < terms.size(); ++k) {
    const double value = cells.pixels[k * cells.channels + channel];
    b += weights[k] * value * terms[k];
    for (int j = 0; j < 6; ++j)
      for (int i = j; i < 6; ++i) A(i, j) += weights[k] * terms[k][i] * terms[k][j];
  }
  return A.ldlt().solve(b);
}

/// The light on the paper in one channel: a fit that hardly minds what lies far below it.
Quadratic fit_light(const Image8& cells, int channel, const std::vector<Quadratic>& terms) {
  std::vector<double> weights(terms.size(), 1);
  Quadratic light = weighted_fit(cells, channel, terms, weights);
  for (int round = 1; round < fit_rounds; ++round) {
    std::vector<double> next;
    for (size_t k = 0; k < terms.size(); ++k) {
      const double value = cells.pixels[k * cells.channels + channel];
      next.push_back(value < terms[k].dot(light) - 3 ? dark_weight : 1);
    }
    if (next == weights) break;
    weights = std::move(next);
    light = weighted_fit(cells, channel, terms, weights);
  }
  return light;
}

bool is_white(const Quadratic& light) {
  return light[0] > 250 && light.tail<5>().cwiseAbs().maxCoeff() < 3;
}

/// What the pixels of one row of a channel are multiplied with, 255 over the light.
void scale_of_row(const Quadratic& light, double v, const std::vector<float>& u,
                  std::vector<float>& scale) {
  const auto constant = static_cast<float>(light[0] + light[2] * v + light[5] * v * v);
  const auto linear = static_cast<float>(light[1] + light[4] * v);
  const auto square = static_cast<float>(light[3]);
  for (size_t x = 0; x < u.size(); ++x) scale[x] = constant + (linear + square * u[x]) * u[x];
  // Where paint covers the paper the fit is a guess, which may be brighter than white.
  for (float& value : scale) value = std::clamp(value, darkest_paper, 255.0F);
  for (float& value : scale) value = 255 / value;
}

/// Divides the channels by the light on them; white light changes nothing.
void divide_by(Image8& rgb, const std::array<Quadratic, 3>& lights) {
  const auto width = static_cast<size_t>(rgb.width);
  std::vector<float> u(width);
  for (size_t x = 0; x < width; ++x)
    u[x] = static_cast<float>(position(static_cast<int>(x), rgb.width));
  std::vector<float> scale(width);
  std::vector<float> scales(3 * width, 1.0F);
  for (int y = 0; y < rgb.height; ++y) {
    for (size_t c = 0; c < 3; ++c) {
      if (is_white(lights[c])) continue;
      scale_of_row(lights[c], position(y, rgb.height), u, scale);
      for (size_t x = 0; x < width; ++x) scales[3 * x + c] = scale[x];
    }
    uint8_t* value = &rgb.at(0, y);
    for (size_t i = 0; i < scales.size(); ++i)
      value[i] =
          static_cast<uint8_t>(static_cast<int>(std::min(255.0F, value[i] * scales[i] + 0.5F)));
  }
}

/// A colour of opaque pixels, channels of 255.
using Colour = std::array<int, 3>;

int difference(const Image8& rgba, size_t i, const Colour& colour) {
  const uint8_t* p = &rgba.pixels[4 * i];
  return std::max(
      {std::abs(p[0] - colour[0]), std::abs(p[1] - colour[1]), std::abs(p[2] - colour[2])});
}

/// The commonest value of each channel along the picture's edge.
Colour colour_of_edge(const Image8& rgba) {
  std::array<std::array<int, 256>, 3> counts = {};
  along_edge(rgba.width, rgba.height, [&](int x, int y) {
    for (int c = 0; c < 3; ++c) ++counts[c][rgba.at(x, y, c)];
  });
  Colour colour = {};
  for (size_t c = 0; c < 3; ++c)
    colour[c] =
        static_cast<int>(std::max_element(counts[c].begin(), counts[c].end()) - counts[c].begin());
  return colour;
}

/// Whether nearly all of an opaque picture's edge has this colour, which is not white.
bool is_plain(const Image8& rgba, const Colour& colour) {
  if (least_alpha(rgba) < 255 || *std::min_element(colour.begin(), colour.end()) >= whitest_ground)
    return false;
  const auto is_like = [&](int x, int y) {
    return difference(rgba, static_cast<size_t>(y) * rgba.width + x, colour) <= plain_noise;
  };
  return share_of_edge(rgba.width, rgba.height, is_like) > plain_share;
}

/// 1 where a pixel has the ground's colour, specks that a codec leaves beside outlines included.
Image8 like_ground(const Image8& rgba, const Colour& colour) {
  Image8 other(rgba.width, rgba.height, 1);
  for (size_t i = 0; i < other.pixels.size(); ++i)
    other.pixels[i] = difference(rgba, i, colour) > ground_noise ? 1 : 0;
  const Image8 broad = remove_specks(other, half_speck);
  Image8 like(rgba.width, rgba.height, 1);
  for (size_t i = 0; i < like.pixels.size(); ++i) {
    const bool speck = broad.pixels[i] == 0 && difference(rgba, i, colour) <= speck_noise;
    like.pixels[i] = other.pixels[i] == 0 || speck ? 1 : 0;
  }
  return like;
}

/// Whether what is not ground covers areas, rather than lines bounding them.
bool is_paint_on(const Image8& like) {
  const int half_line = static_cast<int>(widest_line / 2 * std::hypot(like.width, like.height));
  const Image8 wide = min_filter(complement(like), std::max(3, half_line));
  const auto count = std::count(wide.pixels.begin(), wide.pixels.end(), 1);
  return static_cast<double>(count) > painted_share * static_cast<double>(wide.pixels.size());
}

/// 1 where the ground is: what has its colour and reaches the edge, and what a painted figure or
/// chalk lines enclose. Nothing where ink lines on a bright ground may bound areas that it fills.
Image8 ground_of(const Image8& rgba, const Colour& colour) {
  Image8 like = like_ground(rgba, colour);
  const bool painted = is_paint_on(like);
  const int brightest = *std::max_element(colour.begin(), colour.end());
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
  for (size_t k = 1; k < reaches.size(); ++k)
    if (through && static_cast<double>(pieces.areas[k]) > least) reaches[k] = 1;
  for (size_t i = 0; i < like.pixels.size(); ++i) like.pixels[i] = reaches[pieces.label.pixels[i]];
  return like;
}

/// Whether what is not ground is a page or a picture in a frame.
bool is_framed(const Image8& rgba, const Image8& ground) {
  const Image8 rest = complement(ground);
  int64_t area = 0;
  int64_t white = 0;
  for (size_t i = 0; i < rest.pixels.size(); ++i) {
    area += rest.pixels[i];
    const bool is_white = difference(rgba, i, {255, 255, 255}) < whitest_page;
    white += rest.pixels[i] != 0 && is_white ? 1 : 0;
  }
  return area == 0 || share_of_box(rest) > (2 * white > area ? page_share : framed_share);
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
double share_of_paint(const uint8_t* pixel, const uint8_t* paint, const Colour& ground) {
  double along = 0;
  double all = 0;
  for (size_t c = 0; c < 3; ++c) {
    along += (pixel[c] - ground[c]) * (paint[c] - ground[c]);
    all += (paint[c] - ground[c]) * (paint[c] - ground[c]);
  }
  return all > 0 ? along / all : 1;
}

}  // namespace

Image8 cut_from_plain_ground(const Image8& rgba) {
  assert(rgba.channels == 4);
  const Colour colour = colour_of_edge(rgba);
  if (!is_plain(rgba, colour)) return {};
  const Image8 ground = ground_of(rgba, colour);
  if (ground.empty() || is_framed(rgba, ground)) return {};
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
      const bool most = share_of_paint(&rgba.pixels[4 * i], paint, colour) >= 0.5;
      std::copy(paint, paint + 3, &cut.pixels[4 * i]);
      cut.pixels[4 * i + 3] = most ? 255 : 0;
    }
  return cut;
}

Image8 remove_paper(const Image8& rgba) {
  assert(rgba.channels == 4);
  const uint8_t alpha = least_alpha(rgba);
  const bool transparent = alpha < 128;
  Image8 rgb = alpha == 255 ? drop_alpha(rgba) : lay_on_white(rgba, is_light_on_nothing(rgba));
  if (rgb.empty() || transparent) return rgb;
  const int factor = (std::max(rgb.width, rgb.height) + fit_side - 1) / fit_side;
  const Image8 cells = shrink(rgb, factor);
  std::array<Quadratic, 3> lights;
  const std::vector<Quadratic> at_cells = terms_of_cells(cells.width, cells.height);
  for (int c = 0; c < 3; ++c) lights[c] = fit_light(cells, c, at_cells);
  if (!std::all_of(lights.begin(), lights.end(), is_white)) divide_by(rgb, lights);
  return rgb;
}

}  // namespace relievo
