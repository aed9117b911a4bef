#include "apps/cli/pictures.h"

#include <algorithm>
#include <cmath>

#include "io/image/png_encode.h"
#include "kernel/image/image_size.h"
#include "relievo/render.h"

namespace relievo::cli {
namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180;

View named_view(const std::string& name) {
  if (name == "front") return View::front;
  return name == "side" ? View::side : View::three_quarter;
}

Point3 light_direction(double azimuth, double elevation) {
  const double a = radians_per_degree * azimuth;
  const double e = radians_per_degree * elevation;
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

RenderOptions options_of(const RenderArguments& arguments, const Model& model, bool has_drawing) {
  RenderOptions options = seen_from(named_view(arguments.view), {});
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

}  // namespace

Result<Bytes> draw_picture(const Model& model, const Drawing& drawing,
                           const RenderArguments& arguments, const RunContext& context) {
  const Drawing* texture = drawing.rgba.empty() ? nullptr : &drawing;
  const RenderOptions options = options_of(arguments, model, texture != nullptr);
  const auto picture = arguments.view == "sheet"
                           ? render_contact_sheet(model, texture, options, context)
                           : render_model(model, texture, options, context);
  if (!picture) return picture.error();
  return encode_png(*picture);
}

}  // namespace relievo::cli
