#include "relief/pipeline/keep_labels.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

namespace relievo {
namespace {

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

}  // namespace relievo
