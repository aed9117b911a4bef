#include "understanding/labels/label_basins.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "kernel/image/image_size.h"
#include "kernel/image/watershed.h"
#include "understanding/areas/count_regions.h"
#include "understanding/labels/basin_votes.h"
#include "understanding/labels/choose_labels.h"
#include "understanding/labels/figure_ink.h"
#include "understanding/labels/find_bridges.h"
#include "understanding/labels/split_basins.h"
#include "understanding/labels/stroke_pixels.h"

namespace relievo::understanding {
namespace {

constexpr double much_unbounded = 0.2;   ///< share of unbounded ink above which there is a note
constexpr int many_parts = 40;           ///< number of parts above which there is a note
constexpr double nearly_all = 0.95;      ///< share of the picture, above which parts get a note
constexpr double nearly_nothing = 0.03;  ///< the same, below
constexpr double most_of_edge = 0.5;  ///< share of the picture's edge, above which parts get a note
constexpr size_t most_parts = 65534;  ///< limit of 16-bit labels
constexpr int most_count = 1000;      ///< largest Scribbles::count
constexpr double farthest = 1e6;      ///< px, largest coordinate of a stroke
constexpr double widest_stroke = 1000;  ///< px

Error bad_stroke(size_t number, const std::string& what) {
  const Culprit stroke{CulpritList::strokes, number};
  return {ErrorCode::bad_input, what, to_string(stroke), stroke};
}

Status check_scribbles(const Scribbles& scribbles) {
  std::set<std::string> ids;
  for (const std::string& id : scribbles.parts)
    if (id.empty() || !ids.insert(id).second)
      return Error{ErrorCode::bad_input, "part ids must be unique and not empty", id};
  const auto is_near = [](Point2 p) {
    return std::abs(p.x) < farthest && std::abs(p.y) < farthest;
  };
  for (size_t k = 0; k < scribbles.strokes.size(); ++k) {
    const Scribble& stroke = scribbles.strokes[k];
    if (is_for_part(stroke.kind) &&
        (stroke.part < 0 || stroke.part >= static_cast<int>(scribbles.parts.size())))
      return bad_stroke(k, "the stroke belongs to no part");
    if (stroke.points.empty() || !std::all_of(stroke.points.begin(), stroke.points.end(), is_near))
      return bad_stroke(k, "the stroke has no points or lies far outside the drawing");
    if (!(stroke.width > 0 && stroke.width <= widest_stroke))
      return bad_stroke(k, "the width of a stroke must lie in (0, 1000] px");
  }
  if (scribbles.count < 0 || scribbles.count > most_count)
    return Error{ErrorCode::bad_input, "the number of parts must lie in [1, 1000]", ""};
  return Done{};
}

/// Numbers the labels that occur, `used` in ascending order, so that scribbled parts come first,
/// and lists them as parts. Proposed parts get names that no scribbled part has.
std::vector<uint16_t> number_parts(const std::vector<int>& used, const Scribbles& scribbles,
                                   std::vector<SegmentedPart>& parts) {
  const auto scribbled = static_cast<int>(scribbles.parts.size());
  std::vector<uint16_t> number(used.empty() ? 1 : static_cast<size_t>(used.back()) + 1, 0);
  const std::set<std::string> taken(scribbles.parts.begin(), scribbles.parts.end());
  int names = 0;
  for (const int label : used) {
    if (label == 0) continue;
    const bool proposed = label > scribbled;
    std::string name = proposed ? "" : scribbles.parts[label - 1];
    while (name.empty() || (proposed && taken.count(name) > 0))
      name = "part" + std::to_string(++names);
    parts.push_back({name, proposed, 0, {}});
    number[label] = parts.back().label = static_cast<PartLabel>(parts.size());
  }
  return number;
}

/// Lists the labels that occur, in ascending order.
std::vector<int> used_labels(const Image<int32_t>& labels) {
  std::vector<int> used;
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    if (i == 0 || labels.pixels[i] != labels.pixels[i - 1]) used.push_back(labels.pixels[i]);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

/// Gives the pixels of proposed parts to the nearest scribbled part.
void give_to_scribbled(int parts, Image<int32_t>& pixels) {
  const auto is_scribbled = [parts](int32_t label) { return label > 0 && label <= parts; };
  if (std::none_of(pixels.pixels.begin(), pixels.pixels.end(), is_scribbled)) return;
  Image<int32_t> nearest = pixels;
  for (int32_t& label : nearest.pixels) label = is_scribbled(label) ? label : 0;
  flood_from_seeds(Image8(pixels.width, pixels.height, 1), nearest);
  for (size_t i = 0; i < pixels.pixels.size(); ++i)
    if (pixels.pixels[i] > parts) pixels.pixels[i] = nearest.pixels[i];
}

/// Labels all pixels, ink included. `labels`: [#B] those of the basins.
Image<int32_t> label_pixels(const Basins& basins, const std::vector<int>& labels,
                            const Scribbles& scribbles, const std::vector<StrokePixel>& marks) {
  Image<int32_t> pixels(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < pixels.pixels.size(); ++i)
    pixels.pixels[i] = labels[basins.index.pixels[i]];
  const auto parts = static_cast<int>(scribbles.parts.size());
  take_ink(basins, scribbles, marks, parts + basins.region_count, pixels);
  if (scribbles.complete) give_to_scribbled(parts, pixels);
  return pixels;
}

void measure_parts(Segmentation& segmentation) {
  const int w = segmentation.labels.width;
  for (int y = 0; y < segmentation.labels.height; ++y) {
    const uint16_t* row = &segmentation.labels.at(0, y);
    for (int begin = 0, end = 0; begin < w; begin = end) {
      while (end < w && row[end] == row[begin]) ++end;
      if (row[begin] == 0) continue;
      SegmentedPart& part = segmentation.parts[row[begin] - 1];
      part.area += end - begin;
      part.box.add(Point2{begin * 1.0, y * 1.0});
      part.box.add(Point2{end * 1.0, y + 1.0});
    }
  }
}

/// Computes the share of the picture that the parts cover.
double covered_share(const Segmentation& segmentation) {
  int64_t area = 0;
  for (const SegmentedPart& part : segmentation.parts) area += part.area;
  return static_cast<double>(area) / static_cast<double>(segmentation.labels.pixels.size());
}

void add_notes(const Basins& basins, const Scribbles& scribbles, Segmentation& segmentation) {
  std::set<std::string> present;
  for (const SegmentedPart& part : segmentation.parts) present.insert(part.id);
  for (const std::string& id : scribbles.parts)
    if (present.count(id) == 0)
      segmentation.notes.push_back("no area is left for the part \"" + id +
                                   "\": draw a hard stroke inside it");
  if (!scribbles.strokes.empty()) return;
  const Image16& labels = segmentation.labels;
  const double covered = covered_share(segmentation);
  const double covered_edge = share_of_edge(
      labels.width, labels.height, [&labels](int x, int y) { return labels.at(x, y) != 0; });
  if (covered > nearly_all || covered_edge > most_of_edge)
    segmentation.notes.push_back(
        "the parts cover nearly all of the picture or most of its edge: mark its background with "
        "an outside stroke");
  if (covered < nearly_nothing)
    segmentation.notes.push_back(
        "the parts cover very little of the picture: crop it to the figure, or mark each part "
        "with a stroke");
  if (basins.unbounded_ink > much_unbounded)
    segmentation.notes.push_back(
        "many lines bound no area and became tubes; if they are outlines with wide gaps, mark each "
        "part with a stroke");
  if (segmentation.parts.size() > many_parts)
    segmentation.notes.push_back(
        "more areas were found than a character has parts: mark each part with a stroke");
}

Segmentation assemble(const Basins& basins, const std::vector<int>& labels,
                      const Scribbles& scribbles, const std::vector<StrokePixel>& marks) {
  Segmentation segmentation;
  const Image<int32_t> of_pixel = label_pixels(basins, labels, scribbles, marks);
  const std::vector<uint16_t> number =
      number_parts(used_labels(of_pixel), scribbles, segmentation.parts);
  segmentation.labels = Image16(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < of_pixel.pixels.size(); ++i)
    segmentation.labels.pixels[i] = number[of_pixel.pixels[i]];
  measure_parts(segmentation);
  segmentation.bridges = find_bridges(segmentation.labels, basins.barrier, basins.line_width);
  segmentation.front = basins.front;
  add_notes(basins, scribbles, segmentation);
  return segmentation;
}

}  // namespace

Result<Segmentation> label_basins(const Basins& basins, const Scribbles& scribbles) {
  if (const Status valid = check_scribbles(scribbles); !valid) return valid.error();
  if (scribbles.parts.size() + static_cast<size_t>(basins.region_count) > most_parts)
    return Error{ErrorCode::limit, "the drawing has too many parts", ""};
  const bool counts = scribbles.count > 0 && scribbles.count != basins.region_count;
  Basins counted = counts ? basins : Basins();
  if (counts) count_regions(scribbles.count, counted);
  const Basins& proposed = counts ? counted : basins;
  const std::vector<StrokePixel> marks =
      stroke_pixels(scribbles, basins.index.width, basins.index.height);
  BasinVotes votes = count_votes(proposed, scribbles, marks);
  const bool split = needs_split(votes);
  const Basins divided = split ? split_basins(proposed, votes) : Basins();
  const Basins& used = split ? divided : proposed;
  Segmentation segmentation =
      assemble(used, choose_labels(used, votes, scribbles), scribbles, marks);
  if (segmentation.parts.size() > most_parts)
    return Error{ErrorCode::limit, "the drawing has too many parts", ""};
  if (segmentation.parts.empty())
    return Error{ErrorCode::bad_input,
                 "no lines of the drawing enclose an area: close the figure's outlines, or mark "
                 "each part with a hard stroke",
                 ""};
  return segmentation;
}

}  // namespace relievo::understanding
