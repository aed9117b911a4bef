#pragma once

#include <cstdint>
#include <string>

#include "relievo/result.h"

namespace relievo {

/// Limits of an image file, checked from its header before its pixels take memory.
struct ImageLimits {
  int64_t max_pixels = 100'000'000;
  int64_t max_side = 32'767;
  int64_t max_total = 600'000'000;     ///< pixels of all layers of a drawing together
  int64_t max_streamed = 200'000'000;  ///< pixels of a picture that is reduced row by row
};

/// Returns the limits of a picture of which few rows are held at a time.
inline ImageLimits streamed(ImageLimits limits) {
  limits.max_pixels = limits.max_streamed;
  return limits;
}

/// Returns a number of pixels in words: "12.5 megapixels".
inline std::string megapixels(int64_t pixels) {
  const int64_t tenths = (pixels + 50'000) / 100'000;
  const std::string rest = tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10);
  return std::to_string(tenths / 10) + rest + " megapixels";
}

/// Errors: `limit` where width x height exceeds `limits`, `bad_input` where one of them is 0.
inline Status check_image_size(int64_t width, int64_t height, const ImageLimits& limits) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width <= 0 || height <= 0) return Error{ErrorCode::bad_input, "image of " + size, ""};
  const char* remedy = "; make it smaller, for example to 4 megapixels";
  if (width > limits.max_side || height > limits.max_side)
    return Error{ErrorCode::limit,
                 "image of " + size + " is over the limit of " + std::to_string(limits.max_side) +
                     " pixels a side" + remedy,
                 ""};
  if (width > limits.max_pixels / height)
    return Error{ErrorCode::limit,
                 "image of " + size + " (" + megapixels(width * height) +
                     ") is over the limit of " + megapixels(limits.max_pixels) + remedy,
                 ""};
  return Done{};
}

/// Adds a layer's pixels to `total`, those of the layers before it. Error: `limit`, at `where`.
inline Status add_layer_pixels(int64_t width, int64_t height, const ImageLimits& limits,
                               const std::string& where, int64_t& total) {
  total += width * height;
  if (total <= limits.max_total) return Done{};
  return Error{ErrorCode::limit,
               "the layers up to this one have more than " + std::to_string(limits.max_total) +
                   " pixels together; crop layers to what is on them, or make them smaller",
               where};
}

/// Returns an error on a file of a format ("PNG") with the reason.
inline Error damaged_image(const std::string& format, const std::string& reason) {
  return {ErrorCode::bad_input, "the " + format + " file is damaged: " + reason, ""};
}

}  // namespace relievo
