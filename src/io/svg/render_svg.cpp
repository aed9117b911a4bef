#include "io/svg/render_svg.h"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "io/svg/paint_apart.h"

namespace relievo {
namespace {

constexpr int max_side = 16384;
constexpr int64_t max_pixels = 100000000;

struct Release {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(GError* error) const { g_error_free(error); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

Error render_error(GError* cause) {
  const Owned<GError> owned(cause);
  const std::string message = cause ? cause->message : "unknown";
  const bool for_memory = message.find("emory") != std::string::npos;
  return {for_memory ? ErrorCode::limit : ErrorCode::bad_input,
          "the drawing cannot be rendered: " + message, "svg"};
}

/// Premultiplied native-endian ARGB to straight RGBA.
void straight_rgba(cairo_surface_t* surface, Image8& image) {
  const int width = image.width;
  const int height = image.height;
  cairo_surface_flush(surface);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < height; ++y) {
    const auto* row = reinterpret_cast<const uint32_t*>(data + static_cast<size_t>(y) * stride);
    for (int x = 0; x < width; ++x) {
      const uint32_t alpha = row[x] >> 24;
      const auto channel = [&](int shift) {
        const uint32_t value = row[x] >> shift & 255;
        return static_cast<uint8_t>(alpha ? std::min(255u, (value * 255 + alpha / 2) / alpha) : 0);
      };
      image.at(x, y, 0) = channel(16);
      image.at(x, y, 1) = channel(8);
      image.at(x, y, 2) = channel(0);
      image.at(x, y, 3) = static_cast<uint8_t>(alpha);
    }
  }
}

Status rasterize(const PaintableSvg& svg, Image8& image) {
  GError* error = nullptr;
  const Owned<RsvgHandle> handle(rsvg_handle_new_from_data(
      reinterpret_cast<const guint8*>(svg.text.data()), svg.text.size(), &error));
  if (!handle) return render_error(error);
  const Owned<cairo_surface_t> surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    return Error{ErrorCode::limit, "not enough memory for the texture", "svg"};
  }
  const Owned<cairo_t> context(cairo_create(surface.get()));
  cairo_scale(context.get(), image.width / svg.width, image.height / svg.height);
  const RsvgRectangle viewport{0, 0, svg.width, svg.height};
  if (!rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error)) {
    return render_error(error);
  }
  straight_rgba(surface.get(), image);
  return Done{};
}

}  // namespace

Result<Drawing> render_svg(const PaintableSvg& svg, int width, int height) {
  if (width < 1 || height < 1 || width > max_side || height > max_side ||
      static_cast<int64_t>(width) * height > max_pixels) {
    return Error{ErrorCode::limit,
                 "texture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " px is not in the limits",
                 "svg"};
  }
  PaintLimits limits;
  limits.fonts =
      svg.text.find("<text") != std::string::npos || svg.text.find(":text") != std::string::npos;
  auto image =
      paint_apart(width, height, limits, [&](Image8& pixels) { return rasterize(svg, pixels); });
  if (!image) return image.error();
  return Drawing{std::move(*image)};
}

Result<Drawing> render_svg(std::string_view bytes, int width, int height,
                           const SvgOptions& options) {
  const auto paintable = paintable_svg(bytes, options);
  if (!paintable) return paintable.error();
  return render_svg(*paintable, width, height);
}

}  // namespace relievo
