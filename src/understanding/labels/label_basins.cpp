#include "understanding/labels/label_basins.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "kernel/image/watershed.h"
#include "understanding/areas/count_regions.h"
#include "understanding/areas/find_basins.h"
#include "understanding/labels/basin_labelling.h"
#include "understanding/labels/basin_votes.h"
#include "understanding/labels/figure_ink.h"
#include "understanding/labels/find_bridges.h"
#include "understanding/labels/keep_figure.h"
#include "understanding/labels/segment_drawing.h"
#include "understanding/labels/split_basins.h"

namespace relievo::understanding {
namespace {

/// Share of lines that bound no area, from which on it is said.
constexpr double much_unbounded = 0.2;
constexpr int many_parts = 40;
constexpr size_t most_parts = 65534;
constexpr int most_count = 1000;

Error bad_stroke(size_t number, const std::string& what) {
  const Culprit stroke{CulpritList::strokes, number};
  return {ErrorCode::bad_input, what, to_string(stroke), stroke};
}

Status check_scribbles(const Scribbles& scribbles) {
  std::set<std::string> ids;
  for (const std::string& id : scribbles.parts)
    if (id.empty() || !ids.insert(id).second)
      return Error{ErrorCode::bad_input, "part ids must be unique and not empty", id};
  const auto finite = [](Point2 p) { return std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6; };
  for (size_t k = 0; k < scribbles.strokes.size(); ++k) {
    const Scribble& stroke = scribbles.strokes[k];
    const bool for_part = stroke.kind == ScribbleKind::soft || stroke.kind == ScribbleKind::hard;
    if (for_part && (stroke.part < 0 || stroke.part >= static_cast<int>(scribbles.parts.size())))
      return bad_stroke(k, "the stroke belongs to no part");
    if (stroke.points.empty() || !std::all_of(stroke.points.begin(), stroke.points.end(), finite))
      return bad_stroke(k, "the stroke has no points or points far outside");
    if (!(stroke.width > 0 && stroke.width <= 1000))
      return bad_stroke(k, "the width of a stroke must lie in (0, 1000] px");
  }
  return Done{};
}

/// Names for proposed parts that no scribbled part has.
class FreshNames {
 public:
  explicit FreshNames(const std::vector<std::string>& taken) : taken_(taken.begin(), taken.end()) {}

  std::string next() {
    std::string name;
    do {
      name = "part" + std::to_string(++number_);
    } while (taken_.count(name) > 0);
    return name;
  }

 private:
  std::set<std::string> taken_;
  int number_ = 0;
};

/// Numbers the labels that have pixels, scribbled parts first, and lists them as parts.
std::vector<uint16_t> number_parts(const std::vector<int>& used, const Scribbles& scribbles,
                                   std::vector<SegmentedPart>& parts) {
  const auto scribbled = static_cast<int>(scribbles.parts.size());
  std::vector<uint16_t> number(used.empty() ? 1 : static_cast<size_t>(used.back()) + 1, 0);
  FreshNames names(scribbles.parts);
  for (const int label : used) {
    if (label == 0) continue;
    const bool proposed = label > scribbled;
    parts.push_back({proposed ? names.next() : scribbles.parts[label - 1], proposed, 0, {}});
    number[label] = static_cast<uint16_t>(parts.size());
  }
  return number;
}

std::vector<int> used_labels(const Image<int32_t>& labels) {
  std::vector<int> used;
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    if (i == 0 || labels.pixels[i] != labels.pixels[i - 1]) used.push_back(labels.pixels[i]);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

/// Gives what belongs to proposed parts to the nearest part with strokes.
void give_to_scribbled(int parts, Image<int32_t>& pixels) {
  const auto is_scribbled = [parts](int32_t label) { return label > 0 && label <= parts; };
  if (std::none_of(pixels.pixels.begin(), pixels.pixels.end(), is_scribbled)) return;
  Image<int32_t> nearest = pixels;
  for (int32_t& label : nearest.pixels) label = is_scribbled(label) ? label : 0;
  flood_from_seeds(Image8(pixels.width, pixels.height, 1), nearest);
  for (size_t i = 0; i < pixels.pixels.size(); ++i)
    if (pixels.pixels[i] > parts) pixels.pixels[i] = nearest.pixels[i];
}

/// The labels of all pixels, those of ink among them.
Image<int32_t> label_pixels(const Basins& basins, const std::vector<int>& labels,
                            const Scribbles& scribbles) {
  Image<int32_t> pixels(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < pixels.pixels.size(); ++i)
    pixels.pixels[i] = labels[basins.index.pixels[i]];
  InkVotes votes{mark_pixels(scribbles, pixels.width, pixels.height), {}};
  for (const Scribble& stroke : scribbles.strokes) {
    const bool for_part = stroke.kind == ScribbleKind::soft || stroke.kind == ScribbleKind::hard;
    votes.label_of_stroke.push_back(for_part ? stroke.part + 1 : 0);
  }
  const auto parts = static_cast<int>(scribbles.parts.size());
  take_ink(basins, votes, parts + basins.region_count, pixels);
  const int last = *std::max_element(pixels.pixels.begin(), pixels.pixels.end());
  keep_figure(basins, labels, std::max(last, parts + basins.region_count), pixels);
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

void add_notes(const Basins& basins, const Scribbles& scribbles, Segmentation& segmentation) {
  std::set<std::string> present;
  for (const SegmentedPart& part : segmentation.parts) present.insert(part.id);
  for (const std::string& id : scribbles.parts)
    if (present.count(id) == 0)
      segmentation.notes.push_back("no area is left for the part \"" + id +
                                   "\": draw a hard stroke inside it");
  if (!scribbles.strokes.empty()) return;
  if (basins.unbounded_ink > much_unbounded)
    segmentation.notes.push_back(
        "a good part of the lines bounds no area: they became tubes; where they are outlines with "
        "wide gaps, mark each part with a stroke");
  if (segmentation.parts.size() > many_parts)
    segmentation.notes.push_back(
        "more areas were found than a character has parts: mark each part with a stroke");
}

Segmentation assemble(const Basins& basins, const std::vector<int>& labels,
                      const Scribbles& scribbles) {
  Segmentation segmentation;
  const Image<int32_t> of_pixel = label_pixels(basins, labels, scribbles);
  const std::vector<uint16_t> number =
      number_parts(used_labels(of_pixel), scribbles, segmentation.parts);
  segmentation.labels = Image16(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < of_pixel.pixels.size(); ++i)
    segmentation.labels.pixels[i] = number[of_pixel.pixels[i]];
  measure_parts(segmentation);
  segmentation.bridges = find_bridges(segmentation.labels, basins.barrier, basins.line_width);
  add_notes(basins, scribbles, segmentation);
  return segmentation;
}

}  // namespace

Result<Segmentation> label_basins(const Basins& basins, const Scribbles& scribbles) {
  if (const Status valid = check_scribbles(scribbles); !valid) return valid.error();
  if (scribbles.count < 0 || scribbles.count > most_count)
    return Error{ErrorCode::bad_input, "the number of parts must lie in [1, 1000]", ""};
  if (scribbles.parts.size() + static_cast<size_t>(basins.region_count) > most_parts)
    return Error{ErrorCode::limit, "the drawing has too many parts", ""};
  const bool counts = scribbles.count > 0 && scribbles.count != basins.region_count;
  Basins counted = counts ? basins : Basins();
  if (counts) count_regions(scribbles.count, counted);
  const Basins& proposed = counts ? counted : basins;
  BasinVotes votes = count_votes(proposed, scribbles);
  const bool split = needs_split(votes);
  const Basins divided = split ? split_basins(proposed, votes) : Basins();
  const Basins& used = split ? divided : proposed;
  Segmentation segmentation = assemble(used, choose_labels(used, votes, scribbles), scribbles);
  if (segmentation.parts.size() > most_parts)
    return Error{ErrorCode::limit, "the drawing has too many parts", ""};
  if (segmentation.parts.empty())
    return Error{ErrorCode::bad_input,
                 "no line of the drawing bounds an area: give the figure closed outlines, or mark "
                 "each part with a hard stroke",
                 ""};
  return segmentation;
}

}  // namespace relievo::understanding
