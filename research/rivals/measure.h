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

/// The nearest surface of a model in the front view, for models of any method.
class FrontProbe {
 public:
  /// `model` must outlive the probe. Errors: as RayScene::build.
  static Result<FrontProbe> build(const Model& model, const RunContext& context);

  /// Returns the height over a point of the canvas, px; nothing if there is no surface.
  std::optional<double> height(Point2 canvas) const;

  /// Returns the height and normal of every pixel, `longest` px on the longer side. The part is 0
  /// wherever there is a surface. O(pixels log F).
  ReliefMaps maps(int longest) const;

 private:
  FrontProbe(const Model& model, RayScene rays, double top)
      : model_(&model), rays_(std::move(rays)), top_(top) {}

  std::optional<RayHit> hit(Point2 canvas) const;

  const Model* model_;
  RayScene rays_;
  double top_;  ///< a height above the model, px
};

/// Measures of the front view of a model at its joins and its contour. They depend on the surface
/// alone, so they mean the same for every method.
struct Measures {
  /// Jumps of the slope across joins, degrees, sorted: at all nodes of the middle half of every
  /// visible join. Slopes are those of parabolas through the heights within four edges on either
  /// side.
  std::vector<double> slope_jumps;
  /// Jumps of the height at the same nodes, px, sorted.
  std::vector<double> height_jumps;
  /// Depths of pits at the ends of joins / the length of the join, sorted: of water that would
  /// stand within a quarter of the length around each end, if it ran off at half of the length and
  /// at the contour.
  std::vector<double> pits;
  double contour_iou = 0;  ///< of the model's silhouette and the drawing's
};

/// Measures a model. `joined` gives the joins and the silhouette of the drawing. Compares
/// silhouettes on pixels, `longest` on the longer side. Errors: as FrontProbe::build.
Result<Measures> measure(const Model& model, const relief::LayeredMesh& joined, int longest,
                         const RunContext& context = {});

/// Returns the value below which a `share` of the sorted values lies; 0 for none.
double quantile(const std::vector<double>& sorted, double share);

}  // namespace relievo::research
