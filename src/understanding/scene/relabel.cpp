#include "understanding/scene/relabel.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace relievo::understanding {
namespace {

constexpr size_t possible_labels = size_t{std::numeric_limits<PartLabel>::max()} + 1;

using LabelPair = std::pair<PartLabel, PartLabel>;

/// Pairs of a new and a known label, the ones with most pixels in common first.
std::vector<LabelPair> shared_labels(const Image16& now, const Image16& before) {
  if (before.pixels.size() != now.pixels.size()) return {};
  std::map<LabelPair, int64_t> pixels;
  for (size_t begin = 0, end = 0; begin < now.pixels.size(); begin = end) {
    const LabelPair pair{now.pixels[begin], before.pixels[begin]};
    while (end < now.pixels.size() && LabelPair(now.pixels[end], before.pixels[end]) == pair) ++end;
    if (pair.first != 0 && pair.second != 0) pixels[pair] += static_cast<int64_t>(end - begin);
  }
  std::vector<LabelPair> pairs;
  for (const auto& [pair, count] : pixels) pairs.push_back(pair);
  std::stable_sort(pairs.begin(), pairs.end(), [&](const LabelPair& a, const LabelPair& b) {
    return pixels.at(a) > pixels.at(b);
  });
  return pairs;
}

PartLabel unused_label(PartLabel& highest, const std::set<PartLabel>& taken) {
  if (highest < std::numeric_limits<PartLabel>::max()) return ++highest;
  PartLabel label = 1;
  while (taken.count(label) > 0) ++label;
  return label;
}

/// Per label of a segmentation, the part's label in the record.
std::vector<PartLabel> new_labels(const Segmentation& found, const SegmentationRecord& record) {
  std::map<std::string, PartLabel> known;
  PartLabel highest = 0;
  for (const PartRecord& part : record.parts) {
    known[part.id] = part.label;
    highest = std::max(highest, part.label);
  }
  for (const PartLabel label : record.labels.pixels) highest = std::max(highest, label);
  std::vector<PartLabel> label_of(possible_labels, 0);
  std::set<PartLabel> taken;
  const auto take = [&](PartLabel from, PartLabel to) {
    if (label_of[from] == 0 && taken.insert(to).second) label_of[from] = to;
  };
  std::vector<uint8_t> proposed(possible_labels, 0);
  for (const SegmentedPart& part : found.parts) {
    proposed[part.label] = part.proposed ? 1 : 0;
    const auto same = known.find(part.id);
    if (!part.proposed && same != known.end()) take(part.label, same->second);
  }
  for (const auto& [from, to] : shared_labels(found.labels, record.labels))
    if (proposed[from] != 0) take(from, to);
  for (const SegmentedPart& part : found.parts)
    if (label_of[part.label] == 0) take(part.label, unused_label(highest, taken));
  return label_of;
}

/// Drops corrections of parts that are absent, and of pairs with such a part.
void drop_lost(const Image16& labels, Corrections& corrections) {
  std::vector<int64_t> pixels(possible_labels, 0);
  for (const PartLabel label : labels.pixels) ++pixels[label];
  const auto absent = [&](int label) {
    return label <= 0 || label >= static_cast<int>(possible_labels) ||
           pixels[label] < least_part_pixels;
  };
  const auto lost_item = [&](const auto& item) { return absent(item.upper) || absent(item.lower); };
  const auto lost_pair = [&](const LabelPair& p) { return absent(p.first) || absent(p.second); };
  std::erase_if(corrections.parts, [&](const auto& part) { return absent(part.first); });
  std::erase_if(corrections.order, lost_pair);
  std::erase_if(corrections.joins, lost_item);
  std::erase_if(corrections.no_joins, lost_pair);
  std::erase_if(corrections.relations, lost_item);
  std::erase_if(corrections.robin, lost_item);
  std::erase_if(corrections.cues, [&](const Cue& cue) { return absent(cue.part); });
}

}  // namespace

void relabel(Segmentation& found, SegmentationRecord& record) {
  const std::vector<PartLabel> label_of = new_labels(found, record);
  for (PartLabel& label : found.labels.pixels) label = label_of[label];
  for (SegmentedPart& part : found.parts) {
    part.label = label_of[part.label];
    if (!part.proposed) record.corrections.parts[part.label].id = part.id;
  }
  for (Bridge& bridge : found.bridges) {
    bridge.label_a = label_of[bridge.label_a];
    bridge.label_b = label_of[bridge.label_b];
  }
  record.labels = found.labels;
  drop_lost(record.labels, record.corrections);
}

}  // namespace relievo::understanding
