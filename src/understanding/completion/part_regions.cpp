#include "understanding/completion/part_regions.h"

#include <algorithm>
#include <limits>

namespace relievo::understanding {
namespace {

constexpr size_t possible_labels = size_t{std::numeric_limits<uint16_t>::max()} + 1;

struct Box {
  int left = std::numeric_limits<int>::max();
  int top = std::numeric_limits<int>::max();
  int right = 0;
  int bottom = 0;
};

std::vector<Box> label_boxes(const Image16& labels) {
  std::vector<Box> boxes(possible_labels);
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) {
      Box& box = boxes[labels.at(x, y)];
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
             std::max(box.bottom, y + 1)};
    }
  return boxes;
}

}  // namespace

PartRegions find_regions(const Image16& labels) {
  PartRegions regions;
  regions.map = labels;
  regions.part_of_label.assign(possible_labels, -1);
  const std::vector<Box> boxes = label_boxes(labels);
  for (size_t label = 1; label < possible_labels; ++label) {
    const Box& box = boxes[label];
    if (box.right <= box.left) continue;
    regions.part_of_label[label] = regions.count();
    regions.labels.push_back(static_cast<uint16_t>(label));
    regions.visible.push_back(empty_mask(box.left, box.top, box.right, box.bottom));
  }
  regions.rings.resize(regions.labels.size());
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) {
      const int part = regions.part_of(labels.at(x, y));
      if (part < 0) continue;
      regions.visible[part].add(x, y);
    }
  for (LabelRing& ring : trace_label_rings(labels))
    regions.rings[regions.part_of(ring.label)].push_back(std::move(ring));
  return regions;
}

std::map<int, int> shared_sides(const PartRegions& regions, int part) {
  std::map<int, int> sides;
  for (const LabelRing& ring : regions.rings[part])
    for (const uint16_t label : ring.beyond)
      if (label != 0) ++sides[regions.part_of(label)];
  return sides;
}

std::vector<std::vector<int>> neighbours(const PartRegions& regions, int min_sides) {
  std::vector<std::vector<int>> result(regions.labels.size());
  for (int part = 0; part < regions.count(); ++part)
    for (const auto& [other, count] : shared_sides(regions, part))
      if (count >= min_sides) result[part].push_back(other);
  return result;
}

}  // namespace relievo::understanding
