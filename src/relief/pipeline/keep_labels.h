#pragma once

#include <map>
#include <string>
#include <vector>

#include "relief/corrections/corrections.h"
#include "relief/drawing/segmentation.h"

namespace relievo {

/// What the parts of a drawing were called before its strokes changed.
struct KnownParts {
  Image16 labels;                             ///< [drawing size]; empty where nothing is known
  std::map<std::string, PartLabel> label_of;  ///< by id
};

/// A segmentation whose labels stay those of the same parts.
struct KeptLabels {
  Image16 labels;                   ///< [drawing size] a pixel's part, 0 background
  std::vector<PartLabel> label_of;  ///< [parts of the segmentation]
};

/// Numbers parts as they were before, so that corrections stay with them: a scribbled part has the
/// label of its id, a proposed one that of the known part with which it shares most pixels. All
/// others get new labels, above those that are known. Linear in pixels.
KeptLabels keep_labels(const Segmentation& segmentation, const KnownParts& known);

/// Scribbled parts are called by their ids, whatever their labels.
void name_scribbled(const Segmentation& segmentation, const KeptLabels& kept,
                    Corrections& corrections);

/// The corrections of parts that have at least `min_pixels` pixels, and of pairs of such.
Corrections corrections_of(const Image16& labels, const Corrections& corrections, int min_pixels);

}  // namespace relievo
