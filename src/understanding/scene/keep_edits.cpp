#include "understanding/scene/keep_edits.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kernel/base/text_rules.h"

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

std::map<std::string, PartLabel> labels_by_id(const SegmentationRecord& record) {
  std::map<std::string, PartLabel> label_of;
  for (const PartRecord& part : record.parts) label_of[part.id] = part.label;
  return label_of;
}

/// Merges the parts of a proposal with the parts of an edited scene that the user drew.
class Merger {
 public:
  Merger(const Scene& proposed, const std::vector<PartLabel>& labels, const Scene& edited,
         const SegmentationRecord& known)
      : proposed_(proposed), edited_(edited), label_of_(labels_by_id(known)) {
    const std::vector<std::string>& scribbled = known.scribbles.parts;
    std::set<std::string> kept(scribbled.begin(), scribbled.end());
    for (const Part& part : edited.parts) kept.insert(part.id);
    std::set<PartLabel> removed;
    for (const auto& [id, label] : label_of_)
      if (kept.count(id) == 0) removed.insert(label);
    std::map<PartLabel, const Part*> proposed_of;
    for (size_t k = 0; k < labels.size(); ++k) {
      if (removed.count(labels[k]) > 0) continue;
      merged_.push_back(&proposed.parts[k]);
      proposed_of[labels[k]] = merged_.back();
    }
    merge(proposed_of);
  }

  Scene scene() const {
    Scene result = proposed_;
    result.parts.clear();
    for (const Part* part : merged_) result.parts.push_back(*part);
    result.joins = connections(proposed_.joins, edited_.joins);
    result.relations = connections(proposed_.relations, edited_.relations);
    result.robin = connections(proposed_.robin, edited_.robin);
    result.cues = cues();
    return result;
  }

 private:
  bool is_drawn(const Part& part) const { return label_of_.count(part.id) == 0; }

  /// Inserts each drawn part right in front of the last of the parts that were behind it, and
  /// numbers all parts.
  void merge(const std::map<PartLabel, const Part*>& proposed_of) {
    std::map<const Part*, const Part*> source_of;  // of parts in either scene
    auto at = merged_.begin();
    for (const Part& part : edited_.parts) {
      if (is_drawn(part)) {
        source_of[&part] = &part;
        at = merged_.insert(at, &part) + 1;
        continue;
      }
      const auto found = proposed_of.find(label_of_.at(part.id));
      if (found == proposed_of.end()) continue;
      source_of[&part] = found->second;
      at = std::max(at, std::find(merged_.begin(), merged_.end(), found->second) + 1);
    }
    std::map<const Part*, int> index;
    for (const Part* part : merged_) index[part] = static_cast<int>(index.size());
    index_of_ = index;
    for (const auto& [part, source] : source_of) index_of_[part] = index.at(source);
  }

  /// The index in the result of a part of either scene, -1 where it is not there.
  int index_of(const Part& part) const {
    const auto found = index_of_.find(&part);
    return found == index_of_.end() ? -1 : found->second;
  }

  /// The proposed connections, and those of drawn parts.
  template <class Item>
  std::vector<Item> connections(const std::vector<Item>& proposed,
                                const std::vector<Item>& edited) const {
    std::vector<Item> kept;
    const auto keep = [&](Item item, const Part& upper, const Part& lower) {
      item.upper = index_of(upper);
      item.lower = index_of(lower);
      if (item.lower >= 0 && item.upper > item.lower) kept.push_back(std::move(item));
    };
    for (const Item& item : proposed)
      keep(item, proposed_.parts[item.upper], proposed_.parts[item.lower]);
    for (const Item& item : edited) {
      const Part& upper = edited_.parts[item.upper];
      const Part& lower = edited_.parts[item.lower];
      if (is_drawn(upper) || is_drawn(lower)) keep(item, upper, lower);
    }
    return kept;
  }

  /// The cues of proposed parts that are left, and those of drawn parts.
  std::vector<Cue> cues() const {
    std::vector<Cue> kept;
    const auto keep = [&](Cue cue, const Part& part) {
      cue.part = index_of(part);
      if (cue.part >= 0) kept.push_back(std::move(cue));
    };
    for (const Cue& cue : proposed_.cues) keep(cue, proposed_.parts[cue.part]);
    for (const Cue& cue : edited_.cues)
      if (is_drawn(edited_.parts[cue.part])) keep(cue, edited_.parts[cue.part]);
    return kept;
  }

  const Scene& proposed_;
  const Scene& edited_;
  std::map<std::string, PartLabel> label_of_;  ///< of the parts that were proposed before, by id
  std::vector<const Part*> merged_;            ///< back to front, from either scene
  std::map<const Part*, int> index_of_;        ///< of parts of either scene, in `merged_`
};

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

void avoid_drawn_names(const Scene& edited, const SegmentationRecord& known, Scene& proposed) {
  const std::map<std::string, PartLabel> label_of = labels_by_id(known);
  std::set<std::string> taken;
  for (const Part& part : proposed.parts) taken.insert(part.id);
  std::set<std::string> drawn;
  for (const Part& part : edited.parts)
    if (label_of.count(part.id) == 0) drawn.insert(part.id);
  for (Part& part : proposed.parts) {
    if (drawn.count(part.id) == 0) continue;
    part.id = free_name(
        part.id, [&](const std::string& id) { return taken.count(id) + drawn.count(id) > 0; });
    taken.insert(part.id);
  }
}

Scene keep_edits(const Scene& proposed, const std::vector<PartLabel>& labels, const Scene& edited,
                 const SegmentationRecord& known) {
  return Merger(proposed, labels, edited, known).scene();
}

}  // namespace relievo::understanding
