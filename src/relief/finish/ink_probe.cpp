#include "relief/finish/ink_probe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "kernel/image/compose.h"
#include "relief/finish/fill_triangle.h"

namespace relievo::relief {
namespace {

// Tuned on the samples.
constexpr double widest_line = 0.03;  ///< of the drawing's diagonal
constexpr double ink_contrast = 40;   ///< between ink and the paint beside it, of 255
constexpr double paint_share = 0.35;  ///< least contrast of paint, of the greatest
constexpr double level_share = 0.1;   ///< variation of paint, of its contrast to ink
constexpr double level_run = 4;       ///< px over which paint stays level
constexpr double off_outline = 2;     ///< px from the outline at which parts are looked up
constexpr double core_reach = 2.5;    ///< px from the outline at which there is ink, if any
constexpr int paper_distance = 60;    ///< RGB distance of ink from the paper around
constexpr double step = 0.5;          ///< px between samples

/// Returns the pixel that a point lies on, or the nearest to it.
template <class T>
const T* pixel_at(const Image<T>& image, Point2 p) {
  return &image.at(std::clamp(static_cast<int>(p.x), 0, image.width - 1),
                   std::clamp(static_cast<int>(p.y), 0, image.height - 1));
}

/// Finds where ink ends along samples: half way to the first paint that stays about as bright.
/// `from`: a sample of the ink. Returns nothing if there is no paint.
std::optional<double> edge_of_ink(const std::vector<double>& values, std::ptrdiff_t from,
                                  double darkest) {
  // An eye farther in may be darker than the ink.
  auto core = values.begin() + from;
  for (auto v = core; v != values.end() && *v - darkest < ink_contrast; ++v)
    if (*v < darkest) {
      core = v;
      darkest = *v;
    }
  const double most = *std::max_element(core, values.end()) - darkest;
  if (most < ink_contrast) return std::nullopt;
  const auto run = static_cast<std::ptrdiff_t>(level_run / step);
  const auto is_paint = [&](auto v) {
    const double contrast = *v - darkest;
    const auto ahead = v + std::min<std::ptrdiff_t>(run, values.end() - v);
    return contrast >= std::max(ink_contrast, paint_share * most) &&
           *std::max_element(v, ahead) - *v <= level_share * contrast;
  };
  auto paint = core;
  while (!is_paint(paint)) ++paint;
  const double between = 0.5 * (*paint + darkest);
  const auto end = std::find_if(core, values.end(), [&](double v) { return v > between; });
  if (end == values.begin()) return 0;
  const auto k = static_cast<double>(end - values.begin());
  return step * (k - (*end - between) / (*end - *(end - 1)));
}

}  // namespace

InkProbe::InkProbe(const Model& model, const Image8& rgba)
    : rgba_(rgba),
      scale_(rgba.width / model.width),
      widest_(widest_line * std::hypot(rgba.width, rgba.height)),
      front_(front_parts(model, {rgba.width, rgba.height})),
      grey_(rgba.width, rgba.height, 1) {
  for (size_t i = 0; i < grey_.pixels.size(); ++i) {
    const uint8_t* c = &rgba.pixels[4 * i];
    grey_.pixels[i] = static_cast<uint8_t>(
        (on_paper(c[0], c[3]) + on_paper(c[1], c[3]) + on_paper(c[2], c[3])) / 3);
  }
}

bool InkProbe::ends_at(Point2 at, Point2 out, int part) const {
  return part_at(at - off_outline * out) == part + 1 && part_at(at + off_outline * out) <= part;
}

double InkProbe::room(Point2 at, Point2 out, int part) const {
  double t = off_outline;
  while (t < 4 * widest_ && part_at(at - t * out) == part + 1) ++t;
  return 0.5 * t;
}

std::optional<Crossing> InkProbe::cross(Point2 at, Point2 out) const {
  const std::vector<double> inwards = brightness_from(at, -1 * out, 2 * widest_);
  const std::vector<double> outwards = brightness_from(at, out, widest_);
  const auto reach = std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(core_reach / step),
                                              std::ssize(outwards) - 1);
  const auto in = std::min_element(inwards.begin(), inwards.begin() + reach + 1);
  const auto beyond = std::min_element(outwards.begin(), outwards.begin() + reach + 1);
  const double darkest = std::min(*in, *beyond);
  const bool is_beyond = *beyond < *in;
  const auto inner = edge_of_ink(inwards, is_beyond ? 0 : in - inwards.begin(), darkest);
  if (!inner || *inner > widest_) return std::nullopt;
  Crossing found;
  found.inside = *inner;
  if (part_at(at + off_outline * out) > 0)
    if (const auto outer =
            edge_of_ink(outwards, is_beyond ? beyond - outwards.begin() : 0, darkest))
      found.outside = std::min(*outer, widest_);
  const double core =
      step * static_cast<double>(is_beyond ? outwards.begin() - beyond : in - inwards.begin());
  found.rgb = colour(at - core * out);
  if (is_on_paper_of(found.rgb, at, out)) return std::nullopt;
  return found;
}

std::array<uint8_t, 3> InkProbe::colour(Point2 p) const {
  const uint8_t* c = pixel_at(rgba_, p);
  return {on_paper(c[0], c[3]), on_paper(c[1], c[3]), on_paper(c[2], c[3])};
}

bool InkProbe::is_on_paper_of(std::array<uint8_t, 3> rgb, Point2 at, Point2 out) const {
  for (double t = off_outline; t <= widest_; ++t) {
    if (part_at(at + t * out) != 0) return false;
    int squared = 0;
    const std::array<uint8_t, 3> here = colour(at + t * out);
    for (size_t k = 0; k < 3; ++k) squared += (here[k] - rgb[k]) * (here[k] - rgb[k]);
    if (squared > paper_distance * paper_distance) return false;
  }
  return true;
}

int InkProbe::part_at(Point2 p) const {
  const bool on = p.x >= 0 && p.y >= 0 && p.x < front_.width && p.y < front_.height;
  return on ? *pixel_at(front_, p) : 0;
}

double InkProbe::brightness(Point2 p) const {
  const double x = std::clamp(p.x - 0.5, 0.0, grey_.width - 1.0);
  const double y = std::clamp(p.y - 0.5, 0.0, grey_.height - 1.0);
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, grey_.width - 1);
  const int y1 = std::min(y0 + 1, grey_.height - 1);
  const double u = x - x0;
  const double v = y - y0;
  return (1 - v) * ((1 - u) * grey_.at(x0, y0) + u * grey_.at(x1, y0)) +
         v * ((1 - u) * grey_.at(x0, y1) + u * grey_.at(x1, y1));
}

std::vector<double> InkProbe::brightness_from(Point2 at, Point2 direction, double length) const {
  std::vector<double> values;
  for (double t = 0; t <= length; t += step) values.push_back(brightness(at + t * direction));
  return values;
}

}  // namespace relievo::relief
