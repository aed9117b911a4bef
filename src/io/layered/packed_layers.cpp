#include "io/layered/packed_layers.h"

#include <algorithm>
#include <utility>

#include "io/image/png_decode.h"
#include "kernel/image/image_size.h"

namespace relievo {
namespace {

Error in_layer(Error error, const LayerFile& packed) {
  error.where = packed.file;
  return error;
}

/// Returns the smallest canvas, from the origin, that holds every layer to the right and below.
Result<ImageSize> least_canvas(const std::vector<LayerFile>& layers, const ImageLimits& limits) {
  int64_t width = 1;
  int64_t height = 1;
  for (const LayerFile& packed : layers) {
    const auto size = png_size(packed.png, limits);
    if (!size) return in_layer(size.error(), packed);
    width = std::max(width, int64_t{packed.layer.x} + size->width);
    height = std::max(height, int64_t{packed.layer.y} + size->height);
  }
  if (Status status = check_image_size(width, height, limits); !status) return status.error();
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

/// Checks the pixels of all layers together, which the time of reading is proportional to.
Status check_total(const std::vector<LayerFile>& layers, const ImageLimits& limits) {
  int64_t total = 0;
  for (const LayerFile& packed : layers) {
    const auto size = png_size(packed.png, limits);
    if (!size) return in_layer(size.error(), packed);
    total += int64_t{size->width} * size->height;
    if (total > limits.max_total)
      return Error{ErrorCode::limit,
                   "the layers up to this one have more than " + std::to_string(limits.max_total) +
                       " pixels together; crop layers to what is on them, or make them smaller",
                   packed.file};
  }
  return Done{};
}

}  // namespace

Result<understanding::LayeredDrawing> unpack_layers(const std::vector<LayerFile>& layers,
                                                    ImageSize canvas, const ImageLimits& limits) {
  if (Status status = check_total(layers, limits); !status) return status.error();
  const bool open = canvas.width == 0 || canvas.height == 0;
  const auto size = open ? least_canvas(layers, limits) : Result<ImageSize>(canvas);
  if (!size) return size.error();
  understanding::LayeredDrawing drawing = empty_drawing(size->width, size->height);
  for (const LayerFile& packed : layers) {
    auto pixels = decode_png(packed.png, limits);
    if (!pixels) return in_layer(pixels.error(), packed);
    RasterLayer layer = packed.layer;
    layer.rgba = std::move(*pixels);
    put_layer(drawing, layer);
  }
  return drawing;
}

}  // namespace relievo
