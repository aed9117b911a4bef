#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "rivals/front_probe.h"

namespace relievo {

/// What the front view of a model is like where parts join, and along the contour. All measures
/// look at the surface alone, so that they mean the same for every method.
struct Measures {
  /// Of the middle half of every join that is seen, degrees by which the slope across it jumps,
  /// sorted. Slopes are of parabolas through the heights within four edges on either side.
  std::vector<double> slope_jumps;
  /// Likewise, the jump of the height, px.
  std::vector<double> height_jumps;
  /// How high water stands within a quarter of a join's length around each of its ends, if it runs
  /// off at half of it and at the contour, / the length; sorted.
  std::vector<double> pits;
  double contour_iou = 0;  ///< of the model's silhouette and the drawing's
};

/// `joined` tells where the joins are and what the drawing covers; silhouettes are compared on
/// pixels, `longest` on the longer side. Errors: as FrontProbe::build.
Result<Measures> measure(const Model& model, const LayeredMesh& joined, int longest,
                         const RunContext& context = {});

/// Value below which `share` of the sorted values lie; 0 of none.
double quantile(const std::vector<double>& sorted, double share);

}  // namespace relievo
