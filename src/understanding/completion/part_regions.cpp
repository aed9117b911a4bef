#include "understanding/completion/part_regions.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "kernel/image/distance_transform.h"

namespace relievo::understanding {
namespace {

constexpr size_t possible_labels = size_t{std::numeric_limits<PartLabel>::max()} + 1;

/// The squared distance of every pixel to the nearest whose index `is_target` accepts, px^2.
template <class IsTarget>
Image<int32_t> distance_to(const Image16& labels, IsTarget is_target) {
  Image8 target(labels.width, labels.height, 1);
  for (size_t i = 0; i < labels.pixels.size(); ++i) target.pixels[i] = is_target(i) ? 1 : 0;
  return squared_distance_to(target);
}

/// Sets the rim of the labels to background, except where it lies farther than `rim` from the
/// core, in parts that are too narrow to have one. Every label keeps at least one pixel.
Image16 without_rim(const Image16& labels, double rim) {
  if (rim < 1) return labels;
  const Image<int32_t> to_background =
      distance_to(labels, [&](size_t i) { return labels.pixels[i] == 0; });
  const auto in_core = [&](size_t i) { return to_background.pixels[i] > rim * rim; };
  const Image<int32_t> to_core = distance_to(labels, in_core);
  const double reach = rim + 1.5;
  Image16 inner = labels;
  std::vector<uint8_t> remains(possible_labels, 0);
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    if (!in_core(i) && to_core.pixels[i] <= reach * reach)
      inner.pixels[i] = 0;
    else
      remains[labels.pixels[i]] = 1;
  for (size_t i = 0; i < labels.pixels.size(); ++i)
    if (remains[labels.pixels[i]] == 0) inner.pixels[i] = labels.pixels[i];
  return inner;
}

/// The pixels of each of `count` parts.
std::vector<Mask> masks_of(const Image16& labels, const std::vector<int>& part_of, size_t count) {
  const int none = std::numeric_limits<int>::max();
  std::vector<int> left(count, none);
  std::vector<int> top(count, none);
  std::vector<int> right(count, 0);
  std::vector<int> bottom(count, 0);
  const auto for_each_part = [&](const auto& visit) {
    for (int y = 0; y < labels.height; ++y)
      for (int x = 0; x < labels.width; ++x)
        if (const int part = part_of[labels.at(x, y)]; part >= 0) visit(part, x, y);
  };
  for_each_part([&](int part, int x, int y) {
    left[part] = std::min(left[part], x);
    top[part] = std::min(top[part], y);
    right[part] = std::max(right[part], x + 1);
    bottom[part] = std::max(bottom[part], y + 1);
  });
  std::vector<Mask> masks;
  for (size_t part = 0; part < count; ++part)
    masks.push_back(empty_mask(left[part], top[part], right[part], bottom[part]));
  for_each_part([&](int part, int x, int y) { masks[part].add(x, y); });
  return masks;
}

}  // namespace

std::vector<int> PartRegions::by_label() const {
  std::vector<int> parts(labels.size());
  std::iota(parts.begin(), parts.end(), 0);
  std::sort(parts.begin(), parts.end(), [&](int a, int b) { return labels[a] < labels[b]; });
  return parts;
}

PartRegions find_regions(const Image16& labels, double rim) {
  PartRegions regions;
  regions.map = without_rim(labels, rim);
  regions.inked_map = labels;
  regions.part_of_label.assign(possible_labels, -1);
  std::vector<uint8_t> occurs(possible_labels, 0);
  for (const PartLabel label : labels.pixels) occurs[label] = 1;
  for (size_t label = 1; label < possible_labels; ++label) {
    if (occurs[label] == 0) continue;
    regions.part_of_label[label] = regions.count();
    regions.labels.push_back(static_cast<PartLabel>(label));
  }
  regions.visible = masks_of(regions.map, regions.part_of_label, regions.labels.size());
  regions.inked =
      rim < 1 ? regions.visible : masks_of(labels, regions.part_of_label, regions.labels.size());
  regions.rings.resize(regions.labels.size());
  for (LabelRing& ring : trace_label_rings(regions.map))
    regions.rings[regions.part_of(ring.label)].push_back(std::move(ring));
  return regions;
}

void sort_regions(const std::vector<PartLabel>& order, PartRegions& regions) {
  PartRegions sorted = std::move(regions);
  regions = {
      std::move(sorted.map), std::move(sorted.inked_map), order, sorted.part_of_label, {}, {}, {}};
  for (int part = 0; part < regions.count(); ++part) {
    const int from = sorted.part_of(order[part]);
    regions.part_of_label[order[part]] = part;
    regions.visible.push_back(std::move(sorted.visible[from]));
    regions.inked.push_back(std::move(sorted.inked[from]));
    regions.rings.push_back(std::move(sorted.rings[from]));
  }
}

std::map<int, int> shared_sides(const PartRegions& regions, int part) {
  std::map<int, int> sides;
  for (const LabelRing& ring : regions.rings[part])
    for (const PartLabel label : ring.beyond)
      if (label != 0) ++sides[regions.part_of(label)];
  return sides;
}

bool touches_background(const PartRegions& regions, int part) {
  return std::any_of(
      regions.rings[part].begin(), regions.rings[part].end(), [](const LabelRing& ring) {
        return std::find(ring.beyond.begin(), ring.beyond.end(), 0) != ring.beyond.end();
      });
}

}  // namespace relievo::understanding
