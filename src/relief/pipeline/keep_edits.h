#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/corrections/corrections.h"
#include "relievo/scene.h"

namespace relievo {

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

}  // namespace relievo
