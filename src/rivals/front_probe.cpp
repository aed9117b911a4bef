#include "rivals/front_probe.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "kernel/base/workers.h"
#include "kernel/image/image_size.h"

namespace relievo {
namespace {

template <class T>
T blend(const std::vector<T>& values, const std::array<int, 3>& corners, const RayHit& hit) {
  return (1 - hit.u - hit.v) * values[corners[0]] + hit.u * values[corners[1]] +
         hit.v * values[corners[2]];
}

}  // namespace

Result<FrontProbe> FrontProbe::build(const Model& model, const RunContext& context) {
  auto rays = RayScene::build(model, context);
  if (!rays) return rays.error();
  double top = 0;
  for (const Point3 p : model.positions) top = std::max(top, p.z);
  return FrontProbe(model, std::move(*rays), top + 1);
}

std::optional<RayHit> FrontProbe::hit(Point2 canvas) const {
  return rays_.first_hit({canvas.x, model_->height - canvas.y, top_}, {0, 0, -1});
}

std::optional<double> FrontProbe::height(Point2 canvas) const {
  const auto found = hit(canvas);
  if (!found) return std::nullopt;
  return blend(model_->positions, model_->triangles[found->triangle], *found).z;
}

ReliefMaps FrontProbe::maps(int longest) const {
  const ImageSize size = fitted_size(model_->width, model_->height, longest);
  const double pixel = model_->width / size.width;
  ReliefMaps maps{ImageF(size.width, size.height, 1, std::numeric_limits<float>::quiet_NaN()),
                  ImageF(size.width, size.height, 3, 0.0F),
                  Image<int32_t>(size.width, size.height, 1, -1)};
  run_ranges(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < size.width; ++x) {
        const auto found = hit({(x + 0.5) * pixel, (y + 0.5) * pixel});
        Point3 normal{0, 0, 1};
        if (found) {
          const auto& corners = model_->triangles[found->triangle];
          normal = normalized(blend(model_->normals, corners, *found));
          maps.height.at(x, y) = static_cast<float>(blend(model_->positions, corners, *found).z);
          maps.part.at(x, y) = 0;
        }
        maps.normal.at(x, y, 0) = static_cast<float>(normal.x);
        maps.normal.at(x, y, 1) = static_cast<float>(normal.y);
        maps.normal.at(x, y, 2) = static_cast<float>(normal.z);
      }
  });
  return maps;
}

}  // namespace relievo
