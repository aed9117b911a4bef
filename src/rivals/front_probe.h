#pragma once

#include <optional>

#include "relievo/maps.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "render/ray_scene.h"

namespace relievo {

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

}  // namespace relievo
