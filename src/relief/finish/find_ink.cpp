#include "relief/finish/find_ink.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "relief/finish/ink_probe.h"
#include "relief/finish/open_outlines.h"

namespace relievo::relief {
namespace {

// Tuned on the samples.
constexpr double broadest_ink = 2;   ///< usual widths; broader darkness is paint, as on hooves
constexpr double most_uneven = 0.8;  ///< range of even widths, of their median
constexpr double least_share = 0.5;  ///< of an inked part's outline that has ink
constexpr double least_share_uneven = 0.75;  ///< of it if widths vary, as those of shade do
constexpr double blend_width = 0.5;          ///< px beside ink that blend with it
constexpr double gap_share = 4;              ///< usual widths; shorter gaps between ink are ink
constexpr double widths_nearby = 4;    ///< usual widths along an outline over which ink is alike
constexpr double most_of_usual = 1.3;  ///< width of ink, of the usual nearby
constexpr double most_of_room = 0.5;   ///< of half a part's breadth that ink takes

/// A point of an outline with the ink measured there.
struct Measured {
  OutlinePoint point;
  std::optional<Crossing> ink;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Measures a chain of an outline and splits it into the runs that are seen.
std::vector<std::vector<Measured>> measure_chain(const Model& model, const Drawing& drawing,
                                                 const InkProbe& probe, const OpenOutline& chain) {
  std::vector<std::vector<Measured>> runs;
  bool seen_before = false;
  for (size_t i = 0; i < chain.vertices.size(); ++i) {
    const int v = chain.vertices[i];
    const Point2 at{model.uvs[v].x * drawing.rgba.width, model.uvs[v].y * drawing.rgba.height};
    const Point2 out{chain.out[i].x, -chain.out[i].y};
    const bool seen = probe.ends_at(at, out, chain.part);
    if (seen) {
      if (!seen_before) runs.emplace_back();
      Measured m;
      m.point.vertex = v;
      m.point.place = {model.positions[v].x, model.positions[v].y};
      m.point.out = chain.out[i];
      m.point.room = probe.room(at, out, chain.part) / probe.scale();
      m.ink = probe.cross(at, out);
      runs.back().push_back(m);
    }
    seen_before = seen;
  }
  return runs;
}

/// Returns arc lengths along a run.
std::vector<double> lengths_along(const std::vector<Measured>& run) {
  std::vector<double> s(run.size(), 0);
  for (size_t i = 1; i < run.size(); ++i)
    s[i] = s[i - 1] + distance(run[i].point.place, run[i - 1].point.place);
  return s;
}

/// Fills short gaps between measurements from their neighbours.
void fill_gaps(std::vector<Measured>& run, double longest) {
  const std::vector<double> s = lengths_along(run);
  for (size_t i = 0; i + 1 < run.size(); ++i) {
    if (!run[i].ink || run[i + 1].ink) continue;
    size_t j = i + 1;
    while (j < run.size() && !run[j].ink) ++j;
    if (j == run.size() || s[j] - s[i] > longest) continue;
    for (size_t k = i + 1; k < j; ++k) {
      const double t = (s[k] - s[i]) / (s[j] - s[i]);
      Crossing ink = *run[i].ink;
      ink.inside += t * (run[j].ink->inside - ink.inside);
      ink.outside += t * (run[j].ink->outside - ink.outside);
      run[k].ink = ink;
    }
  }
}

/// Calls visit(i, first, end) for every measurement and those within `reach` canvas px along a run.
template <class Visit>
void for_each_stretch(const std::vector<Measured>& run, double reach, Visit visit) {
  const std::vector<double> s = lengths_along(run);
  size_t first = 0;
  size_t end = 0;
  for (size_t i = 0; i < run.size(); ++i) {
    while (s[i] - s[first] > reach) ++first;
    while (end < run.size() && s[end] - s[i] <= reach) ++end;
    visit(i, first, end);
  }
}

/// Limits widths to those usual nearby: where other strokes meet the outline, they are wider.
void limit_widths(std::vector<Measured>& run, double reach) {
  const std::vector<Measured> given = run;
  for_each_stretch(given, reach, [&](size_t i, size_t first, size_t end) {
    if (!given[i].ink) return;
    std::vector<double> inside;
    std::vector<double> outside;
    for (size_t k = first; k < end; ++k) {
      if (!given[k].ink) continue;
      inside.push_back(given[k].ink->inside);
      outside.push_back(given[k].ink->outside);
    }
    run[i].ink->inside = std::min(run[i].ink->inside, most_of_usual * median(std::move(inside)));
    run[i].ink->outside = std::min(run[i].ink->outside, most_of_usual * median(std::move(outside)));
  });
}

/// Averages widths over `reach` canvas px.
void smooth(std::vector<Measured>& run, double reach) {
  const std::vector<Measured> given = run;
  for_each_stretch(given, reach, [&](size_t i, size_t first, size_t end) {
    if (!given[i].ink) return;
    Crossing mean;
    double count = 0;
    for (size_t k = first; k < end; ++k) {
      if (!given[k].ink) continue;
      mean.inside += given[k].ink->inside;
      mean.outside += given[k].ink->outside;
      ++count;
    }
    run[i].ink->inside = mean.inside / count;
    run[i].ink->outside = mean.outside / count;
  });
}

/// The runs of one part's seen outlines.
struct PartRuns {
  std::vector<std::vector<Measured>> runs;
  std::vector<bool> closed;  ///< by run
};

double width_of(const Crossing& ink) { return ink.inside + ink.outside; }

/// Returns the usual width of the ink of a drawing, px of it; 0 if there is none.
double usual_width(const std::vector<PartRuns>& parts) {
  std::vector<double> widths;
  for (const PartRuns& part : parts)
    for (const std::vector<Measured>& run : part.runs)
      for (const Measured& m : run)
        if (m.ink) widths.push_back(width_of(*m.ink));
  return widths.empty() ? 0 : median(std::move(widths));
}

/// Drops broad darkness; returns the usual ink of the part, with a width of 0 unless at least half
/// of its outline is inked, or three quarters where widths vary, as those of shade do.
PartInk part_ink(PartRuns& part, double broadest) {
  std::vector<double> widths;
  std::array<std::vector<double>, 3> colours;
  size_t count = 0;
  for (std::vector<Measured>& run : part.runs)
    for (Measured& m : run) {
      ++count;
      if (m.ink && width_of(*m.ink) > broadest) m.ink.reset();
      if (!m.ink) continue;
      widths.push_back(width_of(*m.ink));
      for (size_t k = 0; k < 3; ++k) colours[k].push_back(m.ink->rgb[k]);
    }
  PartInk ink;
  if (widths.empty()) return ink;
  std::sort(widths.begin(), widths.end());
  const double usual = widths[widths.size() / 2];
  const double range = widths[3 * widths.size() / 4] - widths[widths.size() / 4];
  const double least = range > most_uneven * usual ? least_share_uneven : least_share;
  if (static_cast<double>(widths.size()) < least * static_cast<double>(count)) return ink;
  ink.width = usual;
  for (size_t k = 0; k < 3; ++k) ink.rgb[k] = static_cast<uint8_t>(median(std::move(colours[k])));
  return ink;
}

/// Adds the inked and the plain pieces of a run.
void split_run(const std::vector<Measured>& run, int part, bool inked, bool closed, double scale,
               ContourInk& found) {
  bool before = false;
  bool all = closed;
  const size_t first_line = found.lines.size();
  for (const Measured& m : run) {
    OutlinePoint p = m.point;
    const bool here = inked && m.ink;
    all = all && here;
    if (here) {
      p.inside = std::min((m.ink->inside + blend_width) / scale, most_of_room * p.room);
      p.outside = m.ink->outside > 0 ? (m.ink->outside + blend_width) / scale : 0;
      if (!before) found.lines.push_back({part, false, {}});
      found.lines.back().points.push_back(p);
    } else {
      found.plain.push_back(p);
    }
    before = here;
  }
  const auto is_point = [](const InkLine& line) { return line.points.size() < 2; };
  found.lines.erase(std::remove_if(found.lines.begin() + static_cast<std::ptrdiff_t>(first_line),
                                   found.lines.end(), is_point),
                    found.lines.end());
  if (all && found.lines.size() > first_line) found.lines.back().closed = true;
}

}  // namespace

ContourInk find_ink(const Model& model, const Drawing& drawing) {
  ContourInk found;
  found.parts.resize(model.parts.size());
  if (drawing.rgba.empty() || drawing.pixel_art > 0) return found;
  const InkProbe probe(model, drawing.rgba);
  std::vector<PartRuns> parts(model.parts.size());
  for (const OpenOutline& outline : open_outlines(model)) {
    PartRuns& part = parts[outline.part];
    auto runs = measure_chain(model, drawing, probe, outline);
    const bool whole =
        outline.closed && runs.size() == 1 && runs.front().size() == outline.vertices.size();
    for (std::vector<Measured>& run : runs) {
      part.closed.push_back(whole);
      part.runs.push_back(std::move(run));
    }
  }
  const double usual = usual_width(parts);
  for (size_t p = 0; p < parts.size(); ++p) {
    PartInk ink = part_ink(parts[p], broadest_ink * usual);
    for (size_t r = 0; r < parts[p].runs.size(); ++r) {
      std::vector<Measured>& run = parts[p].runs[r];
      if (ink.width > 0) {
        fill_gaps(run, gap_share * ink.width / probe.scale());
        limit_widths(run, widths_nearby * ink.width / probe.scale());
        smooth(run, 0.5 * ink.width / probe.scale());
      }
      split_run(run, static_cast<int>(p), ink.width > 0, parts[p].closed[r], probe.scale(), found);
    }
    ink.width /= probe.scale();
    found.parts[p] = ink;
  }
  return found;
}

}  // namespace relievo::relief
