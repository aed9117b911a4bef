#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"
#include "understanding/labels/segmentation.h"
#include "understanding/scene/corrections.h"

namespace relievo::understanding {

/// A scene that was proposed for a segmented drawing and edited since.
struct EditedScene {
  Scene scene;
  /// Of all parts that were proposed, by id: those that the scene does not have were removed, and
  /// parts of the scene that are not here were drawn by hand.
  std::map<std::string, PartLabel> label_of;
  std::set<std::string> scribbled;  ///< ids of parts with strokes, which are never removed
};

/// Gives proposed parts that are called as one that was drawn by hand another name.
void avoid_drawn_names(const EditedScene& edited, Scene& proposed);

/// The proposed scene with what was done to the parts of the edited one: removed parts stay away,
/// and those that were drawn by hand stay, between the parts between which they lay, with what
/// connects them to others. `labels` are those of the proposed parts. Indices follow the parts;
/// what connects two parts that have changed places is left out. O(parts^2 + connections).
Scene keep_edits(const Scene& proposed, const std::vector<PartLabel>& labels,
                 const EditedScene& edited);

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

}  // namespace relievo::understanding
