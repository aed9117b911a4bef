#include "understanding/scene/keep_edits.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

#include "kernel/base/text_rules.h"

namespace relievo::understanding {
namespace {

constexpr int nowhere = -1;

bool is_drawn(const EditedScene& edited, const Part& part) {
  return edited.label_of.count(part.id) == 0;
}

std::set<PartLabel> removed_labels(const EditedScene& edited) {
  std::set<std::string> there = edited.scribbled;
  for (const Part& part : edited.scene.parts) there.insert(part.id);
  std::set<PartLabel> removed;
  for (const auto& [id, label] : edited.label_of)
    if (there.count(id) == 0) removed.insert(label);
  return removed;
}

/// Where a part of the merged scene comes from: an index in one of the two scenes.
struct Source {
  int proposed = nowhere;
  int drawn = nowhere;
};

/// Merges the parts of a proposal and those of an edited scene that were drawn by hand.
class Merger {
 public:
  Merger(const Scene& proposed, const std::vector<PartLabel>& labels, const EditedScene& edited)
      : proposed_(proposed), edited_(edited) {
    const std::set<PartLabel> removed = removed_labels(edited);
    std::map<PartLabel, int> proposed_of;
    for (size_t k = 0; k < labels.size(); ++k) {
      if (removed.count(labels[k]) > 0) continue;
      sources_.push_back({static_cast<int>(k), nowhere});
      proposed_of[labels[k]] = static_cast<int>(k);
    }
    insert_drawn(proposed_of);
    number_parts(proposed_of);
  }

  Scene scene() const {
    Scene merged = proposed_;
    merged.parts.clear();
    for (const Source& source : sources_)
      merged.parts.push_back(source.drawn == nowhere ? proposed_.parts[source.proposed]
                                                     : edited_.scene.parts[source.drawn]);
    merged.joins = connections(proposed_.joins, edited_.scene.joins);
    merged.relations = connections(proposed_.relations, edited_.scene.relations);
    merged.robin = connections(proposed_.robin, edited_.scene.robin);
    merged.cues = cues();
    return merged;
  }

 private:
  /// Each drawn part comes right after those below which it does not lie.
  void insert_drawn(const std::map<PartLabel, int>& proposed_of) {
    size_t at = 0;
    for (size_t k = 0; k < edited_.scene.parts.size(); ++k) {
      const Part& part = edited_.scene.parts[k];
      if (is_drawn(edited_, part)) {
        sources_.insert(sources_.begin() + static_cast<std::ptrdiff_t>(at++),
                        {nowhere, static_cast<int>(k)});
        continue;
      }
      const auto found = proposed_of.find(edited_.label_of.at(part.id));
      if (found == proposed_of.end()) continue;
      const auto same = [&](const Source& source) { return source.proposed == found->second; };
      const auto place = std::find_if(sources_.begin(), sources_.end(), same) - sources_.begin();
      at = std::max(at, static_cast<size_t>(place) + 1);
    }
  }

  void number_parts(const std::map<PartLabel, int>& proposed_of) {
    of_proposed_.assign(proposed_.parts.size(), nowhere);
    of_edited_.assign(edited_.scene.parts.size(), nowhere);
    for (size_t place = 0; place < sources_.size(); ++place) {
      const Source& source = sources_[place];
      (source.drawn == nowhere ? of_proposed_[source.proposed] : of_edited_[source.drawn]) =
          static_cast<int>(place);
    }
    for (size_t k = 0; k < edited_.scene.parts.size(); ++k) {
      const auto label = edited_.label_of.find(edited_.scene.parts[k].id);
      if (label == edited_.label_of.end()) continue;
      const auto found = proposed_of.find(label->second);
      if (found != proposed_of.end()) of_edited_[k] = of_proposed_[found->second];
    }
  }

  /// Those that were proposed, and those of drawn parts.
  template <class Item>
  std::vector<Item> connections(const std::vector<Item>& proposed,
                                const std::vector<Item>& edited) const {
    std::vector<Item> kept;
    const auto keep = [&](Item item, const std::vector<int>& place_of) {
      item.upper = place_of[item.upper];
      item.lower = place_of[item.lower];
      if (item.lower != nowhere && item.upper > item.lower) kept.push_back(std::move(item));
    };
    for (const Item& item : proposed) keep(item, of_proposed_);
    const std::vector<Part>& parts = edited_.scene.parts;
    for (const Item& item : edited)
      if (is_drawn(edited_, parts[item.upper]) || is_drawn(edited_, parts[item.lower]))
        keep(item, of_edited_);
    return kept;
  }

  /// Those of proposed parts that are left, and those of drawn parts.
  std::vector<Cue> cues() const {
    std::vector<Cue> kept;
    const auto keep = [&](Cue cue, const std::vector<int>& place_of) {
      cue.part = place_of[cue.part];
      if (cue.part != nowhere) kept.push_back(std::move(cue));
    };
    for (const Cue& cue : proposed_.cues) keep(cue, of_proposed_);
    for (const Cue& cue : edited_.scene.cues)
      if (is_drawn(edited_, edited_.scene.parts[cue.part])) keep(cue, of_edited_);
    return kept;
  }

  const Scene& proposed_;
  const EditedScene& edited_;
  std::vector<Source> sources_;   ///< back to front
  std::vector<int> of_proposed_;  ///< places in the merged scene
  std::vector<int> of_edited_;
};

constexpr int last_label = std::numeric_limits<PartLabel>::max();

/// So many pixels of a part had this label.
struct Share {
  int64_t pixels = 0;
  size_t part = 0;
  PartLabel label = 0;
};

/// Shares of all parts, the largest first.
std::vector<Share> shares_of(const Segmentation& segmentation, const Image16& before) {
  const std::vector<uint16_t>& now = segmentation.labels.pixels;
  std::vector<Share> shares;
  if (before.pixels.size() != now.size()) return shares;
  std::map<std::pair<uint16_t, uint16_t>, int64_t> pixels;
  for (size_t begin = 0, end = 0; begin < now.size(); begin = end) {
    while (end < now.size() && now[end] == now[begin] && before.pixels[end] == before.pixels[begin])
      ++end;
    if (now[begin] != 0 && before.pixels[begin] != 0)
      pixels[{now[begin], before.pixels[begin]}] += static_cast<int64_t>(end - begin);
  }
  for (const auto& [pair, count] : pixels)
    shares.push_back({count, static_cast<size_t>(pair.first) - 1, pair.second});
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& a, const Share& b) { return a.pixels > b.pixels; });
  return shares;
}

/// Hands out each label once.
class Numbering {
 public:
  Numbering(const Segmentation& segmentation, const KnownParts& known)
      : parts_(segmentation.parts), label_of_(segmentation.parts.size(), 0) {
    for (const uint16_t label : known.labels.pixels) highest_ = std::max(highest_, label);
    for (const auto& [id, label] : known.label_of) highest_ = std::max(highest_, label);
    for (size_t part = 0; part < parts_.size(); ++part) {
      const auto found = known.label_of.find(parts_[part].id);
      if (!parts_[part].proposed && found != known.label_of.end()) take(part, found->second);
    }
    for (const Share& share : shares_of(segmentation, known.labels))
      if (parts_[share.part].proposed) take(share.part, share.label);
    for (size_t part = 0; part < parts_.size(); ++part)
      if (label_of_[part] == 0) take(part, unused());
  }

  std::vector<PartLabel> labels() && { return std::move(label_of_); }

 private:
  void take(size_t part, PartLabel label) {
    if (label_of_[part] == 0 && taken_.insert(label).second) label_of_[part] = label;
  }

  PartLabel unused() {
    if (highest_ < last_label) return ++highest_;
    PartLabel label = 1;
    while (taken_.count(label) > 0) ++label;
    return label;
  }

  const std::vector<SegmentedPart>& parts_;
  std::vector<PartLabel> label_of_;
  std::set<PartLabel> taken_;
  PartLabel highest_ = 0;
};

/// Labels with enough pixels.
std::set<int> present_labels(const Image16& labels, int min_pixels) {
  std::vector<int64_t> pixels(static_cast<size_t>(last_label) + 1, 0);
  for (const uint16_t label : labels.pixels) ++pixels[label];
  std::set<int> present;
  for (int label = 1; label <= last_label; ++label)
    if (pixels[label] >= min_pixels) present.insert(label);
  return present;
}

}  // namespace

void avoid_drawn_names(const EditedScene& edited, Scene& proposed) {
  std::set<std::string> taken;
  for (const Part& part : proposed.parts) taken.insert(part.id);
  std::set<std::string> drawn;
  for (const Part& part : edited.scene.parts)
    if (is_drawn(edited, part)) drawn.insert(part.id);
  for (Part& part : proposed.parts) {
    if (drawn.count(part.id) == 0) continue;
    part.id = free_name(
        part.id, [&](const std::string& id) { return taken.count(id) + drawn.count(id) > 0; });
    taken.insert(part.id);
  }
}

Scene keep_edits(const Scene& proposed, const std::vector<PartLabel>& labels,
                 const EditedScene& edited) {
  return Merger(proposed, labels, edited).scene();
}

KeptLabels keep_labels(const Segmentation& segmentation, const KnownParts& known) {
  KeptLabels kept{segmentation.labels, Numbering(segmentation, known).labels()};
  for (uint16_t& label : kept.labels.pixels)
    if (label != 0) label = kept.label_of[label - 1];
  return kept;
}

void name_scribbled(const Segmentation& segmentation, const KeptLabels& kept,
                    Corrections& corrections) {
  for (size_t k = 0; k < segmentation.parts.size(); ++k)
    if (!segmentation.parts[k].proposed)
      corrections.parts[kept.label_of[k]].id = segmentation.parts[k].id;
}

Corrections corrections_of(const Image16& labels, const Corrections& corrections, int min_pixels) {
  const std::set<int> present = present_labels(labels, min_pixels);
  const auto absent = [&](int label) { return present.count(label) == 0; };
  const auto keep_items = [&](auto& items) {
    const auto lost = [&](const auto& item) { return absent(item.upper) || absent(item.lower); };
    items.erase(std::remove_if(items.begin(), items.end(), lost), items.end());
  };
  const auto keep_pairs = [&](auto& pairs) {
    const auto lost = [&](const auto& pair) { return absent(pair.first) || absent(pair.second); };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), lost), pairs.end());
  };
  Corrections kept = corrections;
  for (const auto& [label, part] : corrections.parts)
    if (absent(label)) kept.parts.erase(label);
  keep_pairs(kept.order);
  keep_items(kept.joining.joins);
  keep_pairs(kept.joining.no_joins);
  keep_items(kept.joining.relations);
  keep_items(kept.joining.robin);
  const auto lost = [&](const Cue& cue) { return absent(cue.part); };
  kept.cues.erase(std::remove_if(kept.cues.begin(), kept.cues.end(), lost), kept.cues.end());
  return kept;
}

}  // namespace relievo::understanding
