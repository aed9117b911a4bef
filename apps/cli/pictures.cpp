#include "apps/cli/pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/image/png.h"
#include "io/svg/render_svg.h"
#include "kernel/image/compose.h"
#include "kernel/image/image_size.h"
#include "relief/surface/assemble_model.h"
#include "relievo/render.h"

namespace relievo::cli {
namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180;

Point3 light_direction(double azimuth, double elevation) {
  const double a = radians_per_degree * azimuth;
  const double e = radians_per_degree * elevation;
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

RenderOptions options_of(const RenderArguments& arguments, const Model& model, bool has_drawing) {
  RenderOptions options = seen_from(arguments.view.value_or(View::front), {});
  const ImageSize size = fitted_size(model.width, model.height, arguments.size);
  options.width = size.width;
  options.height = size.height;
  options.yaw = arguments.yaw.value_or(options.yaw);
  options.pitch = arguments.pitch.value_or(options.pitch);
  options.shading = arguments.clay || !has_drawing ? Shading::clay : Shading::textured;
  if (!arguments.light.empty())
    options.light = light_direction(arguments.light[0], arguments.light[1]);
  if (!arguments.window.empty())
    options.window = RenderWindow{{arguments.window[0], arguments.window[1]}, arguments.window[2]};
  return options;
}

constexpr int cell_side = 480;  ///< longest side of one picture of the strip, px
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

Result<Image8> draw(const relief::Relief& relief, const relief::Inflation& inflation,
                    const relief::Ordering& ordering, const Scene& scene,
                    const RunContext& context) {
  ModelOptions options;
  options.visibility = Visibility::orbit;
  const auto model =
      relief::assemble_model({relief.layers, inflation, ordering, scene}, options, context);
  if (!model) return model.error();
  return render_model(*model, nullptr, cell_options(scene), context);
}

/// Minimum size of the picture, so that lines of small drawings stay distinct, px.
constexpr double overlay_side = 1200;

/// Enlarges the drawing and lays the overlay on it. The background is white, or grey for a drawing
/// with white lines.
Image8 composed(const Image8& drawing, const Image8& overlay) {
  const int background = is_light_on_nothing(drawing) ? 96 : 255;
  Image8 picture(overlay.width, overlay.height, 3);
  for (int y = 0; y < overlay.height; ++y)
    for (int x = 0; x < overlay.width; ++x) {
      const int sx = std::min(drawing.width - 1, x * drawing.width / overlay.width);
      const int sy = std::min(drawing.height - 1, y * drawing.height / overlay.height);
      for (int c = 0; c < 3; ++c) {
        const uint8_t seen = lay_over(drawing.at(sx, sy, c), background, drawing.at(sx, sy, 3));
        picture.at(x, y, c) = lay_over(overlay.at(x, y, c), seen, overlay.at(x, y, 3));
      }
    }
  return picture;
}

Image8 white_canvas(const Scene& scene) {
  const ImageSize size = fitted_size(scene.width, scene.height, overlay_side);
  return {size.width, size.height, 4, 255};
}

}  // namespace

Result<Bytes> draw_picture(const Model& model, const Drawing& drawing,
                           const RenderArguments& arguments, const RunContext& context) {
  const Drawing* texture = drawing.rgba.empty() ? nullptr : &drawing;
  const RenderOptions options = options_of(arguments, model, texture != nullptr);
  const auto picture = arguments.view ? render_model(model, texture, options, context)
                                      : render_contact_sheet(model, texture, options, context);
  if (!picture) return picture.error();
  return encode_png(*picture);
}

std::vector<int> convergence_steps(int last) {
  std::vector<int> steps;
  for (int step = 1, next = 2; step <= last; step = std::exchange(next, step + next))
    steps.push_back(step);
  return steps;
}

Result<Bytes> draw_convergence(const relief::Relief& relief, const Scene& scene,
                               const RunContext& context) {
  const size_t count = std::min(relief.snapshots.size(), max_cells - 1);
  std::vector<Image8> pictures;
  for (size_t k = 0; k < count; ++k) {
    const relief::NonlinearSnapshot& snapshot = relief.snapshots[k];
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

Result<Bytes> draw_overlay(const Scene& scene, const OverlayMarks& marks, const Image8& drawing) {
  if (drawing.pixels.empty()) return draw_overlay(scene, marks, white_canvas(scene));
  const double scale =
      std::max(1.0, std::round(overlay_side / std::max(drawing.width, drawing.height)));
  const understanding::PaintableSvg lines{overlay_svg(scene, marks), scene.width, scene.height};
  const auto overlay = render_svg(lines, static_cast<int>(drawing.width * scale),
                                  static_cast<int>(drawing.height * scale));
  if (!overlay) return overlay.error();
  return encode_png(composed(drawing, overlay->rgba));
}

}  // namespace relievo::cli
