#include "apps/cli/convergence.h"

#include <algorithm>
#include <utility>

#include "io/image/png_encode.h"
#include "kernel/image/image_size.h"
#include "kernel/image/paste.h"
#include "relievo/render.h"

namespace relievo::cli {
namespace {

constexpr int cell_side = 480;  ///< longest side of one picture, px
constexpr size_t max_cells = 7;

RenderOptions cell_options(const Scene& scene) {
  const ImageSize size = fitted_size(scene.width, scene.height, cell_side);
  RenderOptions options;
  options.width = size.width;
  options.height = size.height;
  options.yaw = -20;
  options.pitch = 8;
  options.window = RenderWindow{{scene.width / 2, scene.height / 2}, scene.width};
  return options;
}

Result<Image8> draw(const Relief& relief, const Inflation& inflation, const Ordering& ordering,
                    const Scene& scene, const RunContext& context) {
  ModelOptions options;
  options.visibility = Visibility::orbit;
  const auto model = assemble_model(relief.layers, inflation, ordering, scene, options, context);
  if (!model) return model.error();
  return render_model(*model, nullptr, cell_options(scene), context);
}

}  // namespace

std::vector<int> convergence_steps(int last) {
  std::vector<int> steps;
  for (int step = 1, next = 2; step <= last; step = std::exchange(next, step + next))
    steps.push_back(step);
  return steps;
}

Result<Bytes> draw_convergence(const Relief& relief, const Scene& scene,
                               const RunContext& context) {
  const size_t count = std::min(relief.snapshots.size(), max_cells - 1);
  std::vector<Image8> pictures;
  for (size_t k = 0; k < count; ++k) {
    const JointSnapshot& snapshot = relief.snapshots[k];
    auto picture = draw(relief, snapshot.inflation, snapshot.ordering, scene, context);
    if (!picture) return picture.error();
    pictures.push_back(std::move(*picture));
  }
  auto last = draw(relief, relief.inflation, relief.ordering, scene, context);
  if (!last) return last.error();
  pictures.push_back(std::move(*last));
  const int width = pictures[0].width;
  Image8 strip(width * static_cast<int>(pictures.size()), pictures[0].height, 4);
  for (size_t k = 0; k < pictures.size(); ++k)
    paste(strip, static_cast<int>(k) * width, 0, pictures[k]);
  return encode_png(strip);
}

}  // namespace relievo::cli
