#pragma once

#include <optional>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relievo/maps.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "render/ray_scene.h"

namespace relievo::research {

/// The surface of a model as the front view shows it, wherever it came from: what is nearest.
class FrontProbe {
 public:
  /// `model` must live as long. Errors: as RayScene::build.
  static Result<FrontProbe> build(const Model& model, const RunContext& context);

  /// Height over a point of the canvas, px; nothing where there is no surface.
  std::optional<double> height(Point2 canvas) const;

  /// Height and normal of every pixel, `longest` px on the longer side; part 0 where there is any
  /// surface. O(pixels log F).
  ReliefMaps maps(int longest) const;

 private:
  FrontProbe(const Model& model, RayScene rays, double top)
      : model_(&model), rays_(std::move(rays)), top_(top) {}

  std::optional<RayHit> hit(Point2 canvas) const;

  const Model* model_;
  RayScene rays_;
  double top_;  ///< above all of the model, px
};

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
Result<Measures> measure(const Model& model, const relief::LayeredMesh& joined, int longest,
                         const RunContext& context = {});

/// Value below which `share` of the sorted values lie; 0 of none.
double quantile(const std::vector<double>& sorted, double share);

}  // namespace relievo::research
