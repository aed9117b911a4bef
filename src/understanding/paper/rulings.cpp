#include "understanding/paper/rulings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "relievo/point.h"

namespace relievo::understanding {
namespace {

// Rulings are horizontal below; vertical ones are found in the transposed drawing.
constexpr int strip_count = 48;        ///< vertical strips of the picture that are searched
constexpr double half_width = 0.0035;  ///< half width of the widest ruling, per diagonal
constexpr int darkest_thin = 80;       ///< contrast of a ruling at most, of 255; more is ink
constexpr float palest_ruling = 5;     ///< mean contrast of a ruling in a strip at least, of 255
constexpr double steepest = 0.1;       ///< largest slope of a ruling
constexpr double stray = 2;            ///< largest distance to the fitted line in a strip, px
/// Least number of strips from the first to the last that shows a ruling, as a share of all.
constexpr double least_span = 0.6;
constexpr double least_seen = 0.4;     ///< least share of the strips that show a ruling
constexpr double margin_seen = 0.75;   ///< least share that show a single line, such as a margin
constexpr double median_seen = 0.6;    ///< least median of those shares on a ruled page
constexpr size_t fewest = 5;           ///< least number of rulings on a page
constexpr double regular = 0.2;        ///< deviation of a regular spacing, per median spacing
constexpr double regular_share = 0.8;  ///< least share of the spacings that are regular
constexpr double ink_contrast = 1.7;   ///< contrast above which ink lies on a ruling, per its own
constexpr int noise = 12;              ///< allowance for noise in that contrast, of 255

/// A line of the paper.
struct Ruling {
  std::vector<double> y;  ///< [strips] where it crosses them, px from the top
  int seen = 0;           ///< number of strips that show it
  double darkness = 0;    ///< median contrast, of 255
};

/// [strips][rows] mean contrast of thin dark lines along a row of a strip.
using Profiles = std::vector<std::vector<float>>;

/// Returns 255 less the darkest channel, over white paper.
Image8 darkness_of(const Image8& rgba) {
  Image8 dark(rgba.width, rgba.height, 1);
  for (size_t i = 0; i < dark.pixels.size(); ++i) {
    const uint8_t* p = &rgba.pixels[4 * i];
    dark.pixels[i] = static_cast<uint8_t>((255 - std::min({p[0], p[1], p[2]})) * p[3] / 255);
  }
  return dark;
}

Image8 transposed(const Image8& image) {
  Image8 out(image.height, image.width, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(&image.at(x, y), image.channels, &out.at(y, x));
  return out;
}

/// Measures how much darker a row of each strip is than the rows `reach` px above and below it.
Profiles profiles_of(const Image8& dark, int reach) {
  Profiles profiles(strip_count, std::vector<float>(dark.height, 0.0F));
  for (int y = reach; y + reach < dark.height; ++y)
    for (int s = 0; s < strip_count; ++s) {
      const int from = s * dark.width / strip_count;
      const int to = (s + 1) * dark.width / strip_count;
      int sum = 0;
      for (int x = from; x < to; ++x) {
        const int beside = std::max(dark.at(x, y - reach), dark.at(x, y + reach));
        sum += std::clamp(dark.at(x, y) - beside, 0, darkest_thin);
      }
      profiles[s][y] = static_cast<float>(sum) / static_cast<float>(to - from);
    }
  return profiles;
}

/// Finds the rows at which a strip is darkest within `reach` px, from top to bottom, px.
std::vector<double> peaks_of(const std::vector<float>& profile, int reach) {
  std::vector<double> peaks;
  const int n = static_cast<int>(profile.size());
  for (int y = reach; y + reach < n; ++y) {
    const auto* around = &profile[y - reach];
    if (profile[y] < palest_ruling ||
        std::max_element(around, around + 2 * reach + 1) != &profile[y])
      continue;
    double weight = 0;
    double sum = 0;
    for (int v = y - reach; v <= y + reach; ++v) {
      weight += profile[v];
      sum += static_cast<double>(profile[v]) * v;
    }
    peaks.push_back(sum / weight);
  }
  return peaks;
}

/// Returns the peak nearest to `y`, or nothing where none lies within that distance.
std::optional<double> nearest(const std::vector<double>& peaks, double y, double within) {
  std::optional<double> best;
  for (auto p = std::lower_bound(peaks.begin(), peaks.end(), y - within);
       p != peaks.end() && *p <= y + within; ++p)
    if (!best || std::abs(*p - y) < std::abs(*best - y)) best = *p;
  return best;
}

/// Predicts where a ruling crosses strip `s` by a straight line fitted to the last ten points seen.
/// x counts strips, y is in px from the top.
double expected_at(const std::vector<Point2>& seen, double s) {
  const size_t n = std::min<size_t>(seen.size(), 10);
  if (n < 3) return seen.back().y;
  Point2 mean;
  for (size_t k = seen.size() - n; k < seen.size(); ++k)
    mean = mean + (1 / static_cast<double>(n)) * seen[k];
  double ss = 0;
  double sy = 0;
  for (size_t k = seen.size() - n; k < seen.size(); ++k) {
    const Point2 d = seen[k] - mean;
    ss += d.x * d.x;
    sy += d.x * d.y;
  }
  return mean.y + sy / ss * (s - mean.x);
}

/// Follows a ruling from a peak in strip `first` to the last strip, also where it is hidden.
std::vector<Point2> follow(const std::vector<std::vector<double>>& peaks, int first, double y,
                           double strip_width) {
  std::vector<Point2> seen = {{static_cast<double>(first), y}};
  for (int s = first + 1; s < strip_count; ++s) {
    const double since = s - seen.back().x;
    const double within = seen.size() < 3 ? stray + steepest * strip_width * since : stray;
    if (const auto found = nearest(peaks[s], expected_at(seen, s), within))
      seen.push_back({static_cast<double>(s), *found});
  }
  return seen;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Interpolates and extends a ruling through the points where it was seen.
Ruling ruling_through(const std::vector<Point2>& seen, const Profiles& profiles) {
  Ruling ruling;
  ruling.seen = static_cast<int>(seen.size());
  std::vector<double> dark;
  size_t k = 0;
  for (int s = 0; s < strip_count; ++s) {
    while (k + 2 < seen.size() && seen[k + 1].x <= s) ++k;
    const Point2 a = seen[k];
    const Point2 d = seen[k + 1] - a;
    ruling.y.push_back(a.y + d.y * (s - a.x) / d.x);
  }
  for (const auto& [s, y] : seen) dark.push_back(profiles[static_cast<size_t>(s)][std::lround(y)]);
  ruling.darkness = median(dark);
  return ruling;
}

/// Finds thin dark lines across most of the picture, from top to bottom. They are darker than the
/// rows `reach` px above and below them.
std::vector<Ruling> lines_across(const Image8& dark, int reach) {
  const Profiles profiles = profiles_of(dark, reach);
  const double strip_width = static_cast<double>(dark.width) / strip_count;
  std::vector<std::vector<double>> peaks;
  for (const std::vector<float>& strip : profiles) peaks.push_back(peaks_of(strip, reach));
  std::vector<Ruling> lines;
  for (int first = 0; first < (1 - least_span) * strip_count; ++first)
    for (const double y : std::vector<double>(peaks[first])) {
      const auto seen = follow(peaks, first, y, strip_width);
      if (seen.back().x - first < least_span * strip_count ||
          static_cast<double>(seen.size()) < least_seen * strip_count)
        continue;
      for (const auto& [s, at] : seen) std::erase(peaks[static_cast<size_t>(s)], at);
      const Ruling line = ruling_through(seen, profiles);
      auto below = lines.begin();
      while (below != lines.end() && below->y[strip_count / 2] < line.y[strip_count / 2]) ++below;
      lines.insert(below, line);
    }
  return lines;
}

/// Computes the distance between neighbouring rulings, px. It is 0 unless the lines are those of a
/// page: clearly seen and at equal distances, though some may be missing.
double spacing_of(const std::vector<Ruling>& lines) {
  if (lines.size() < fewest) return 0;
  std::vector<double> spacings;
  std::vector<double> seen;
  for (size_t k = 0; k < lines.size(); ++k) {
    seen.push_back(lines[k].seen);
    if (k > 0) spacings.push_back(lines[k].y[strip_count / 2] - lines[k - 1].y[strip_count / 2]);
  }
  const double typical = median(spacings);
  const auto like = std::count_if(spacings.begin(), spacings.end(), [typical](double spacing) {
    const double times = std::max(1.0, std::round(spacing / typical));
    return std::abs(spacing - times * typical) < regular * typical;
  });
  const bool regularly =
      static_cast<double>(like) > regular_share * static_cast<double>(spacings.size());
  return regularly && median(seen) > median_seen * strip_count ? typical : 0;
}

/// Adds rulings that cross only a corner of the picture, since the paper is turned.
void add_corners(double spacing, int height, std::vector<Ruling>& lines) {
  const size_t count = lines.size();
  const auto beside = [&](const Ruling& line, double step) {
    Ruling next = line;
    for (double& y : next.y) y += step;
    const auto [least, most] = std::minmax_element(next.y.begin(), next.y.end());
    return *most > 0 && *least < height ? std::optional(next) : std::nullopt;
  };
  for (const double step : {-spacing, spacing}) {
    const Ruling outermost = step < 0 ? lines.front() : lines[count - 1];
    for (auto next = beside(outermost, step); next; next = beside(*next, step))
      lines.push_back(*next);
  }
}

/// Gives a ruling's pixels the colour of its darker side, except where they are so dark that ink
/// lies there.
void erase_ruling(const Ruling& ruling, int reach, Image8& rgba) {
  const double strip_width = static_cast<double>(rgba.width) / strip_count;
  const auto most = static_cast<int>(ink_contrast * ruling.darkness) + noise;
  for (int x = 0; x < rgba.width; ++x) {
    const double s = std::clamp(x / strip_width - 0.5, 0.0, strip_count - 1.001);
    const auto k = static_cast<size_t>(s);
    const double at = ruling.y[k] + (s - static_cast<double>(k)) * (ruling.y[k + 1] - ruling.y[k]);
    const int y = static_cast<int>(std::lround(at));
    if (y <= -reach || y >= rgba.height + reach) continue;
    const uint8_t* above = &rgba.at(x, y < reach ? y + reach : y - reach);
    const uint8_t* below = &rgba.at(x, y + reach >= rgba.height ? y - reach : y + reach);
    for (int v = std::max(0, y - reach + 1); v < std::min(rgba.height, y + reach); ++v)
      for (int c = 0; c < 3; ++c) {
        uint8_t& value = rgba.at(x, v, c);
        const uint8_t darker = std::min(above[c], below[c]);
        if (darker > value && darker - value <= most) value = darker;
      }
  }
}

}  // namespace

Image8 without_rulings(const Image8& drawing) {
  assert(drawing.channels == 4);
  const int reach =
      std::max(3, static_cast<int>(half_width * std::hypot(drawing.width, drawing.height)));
  if (std::min(drawing.width, drawing.height) < std::max(strip_count, 4 * reach)) return {};
  const Image8 dark = darkness_of(drawing);
  std::vector<Ruling> rows = lines_across(dark, reach);
  std::vector<Ruling> columns = lines_across(transposed(dark), reach);
  const double row_spacing = spacing_of(rows);
  const double column_spacing = spacing_of(columns);
  if (row_spacing == 0 && column_spacing == 0) return {};
  const auto settle = [](double spacing, int height, std::vector<Ruling>& lines) {
    if (spacing > 0) return add_corners(spacing, height, lines);
    std::erase_if(lines, [](const Ruling& line) { return line.seen < margin_seen * strip_count; });
  };
  settle(row_spacing, drawing.height, rows);
  settle(column_spacing, drawing.width, columns);
  Image8 rgba = drawing;
  for (const Ruling& line : rows) erase_ruling(line, reach, rgba);
  rgba = transposed(rgba);
  for (const Ruling& line : columns) erase_ruling(line, reach, rgba);
  return transposed(rgba);
}

}  // namespace relievo::understanding
