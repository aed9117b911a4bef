#include "apps/cli/segment_hints.h"

#include <algorithm>
#include <utility>

#include "api/inputs.h"
#include "io/files/paths.h"
#include "io/image/png.h"
#include "io/image/row_average.h"
#include "io/scribbles/scribble_image.h"
#include "io/scribbles/scribbles_json.h"
#include "kernel/image/enlarge.h"
#include "relievo/files.h"

namespace relievo::cli {
namespace {

/// Returns what `decode` makes of the content of a file.
template <class Decode>
auto read_as(const std::string& name, Decode decode) -> decltype(decode(Bytes())) {
  const auto bytes = read_file(name);
  if (!bytes) return bytes.error();
  auto content = decode(*bytes);
  return content ? std::move(content) : in_file(content.error(), name);
}

template <class T>
bool has_size_of(const Image<T>& image, const Image8& drawing) {
  return image.width == drawing.width && image.height == drawing.height;
}

/// Fits an image as large as the drawing's file as the drawing was fitted. Where that was reduced,
/// takes the pixel in the middle of each square, since colours and labels have no averages. Returns
/// other images as they are.
template <class T>
Image<T> sampled(Image<T> image, const FittedImage& drawing) {
  const int factor = drawing.factor;
  const bool is_small = drawing.times > 1 && drawing.times * image.width == drawing.rgba.width &&
                        drawing.times * image.height == drawing.rgba.height;
  if (is_small) return enlarged(std::move(image), drawing.times);
  if (has_size_of(image, drawing.rgba) || reduced_side(image.width, factor) != drawing.rgba.width ||
      reduced_side(image.height, factor) != drawing.rgba.height)
    return image;
  Image<T> samples(drawing.rgba.width, drawing.rgba.height, image.channels);
  for (int y = 0; y < samples.height; ++y)
    for (int x = 0; x < samples.width; ++x)
      for (int c = 0; c < image.channels; ++c)
        samples.at(x, y, c) = image.at(std::min(x * factor + factor / 2, image.width - 1),
                                       std::min(y * factor + factor / 2, image.height - 1), c);
  return samples;
}

/// Returns the image, or an error where it is not as large as the drawing.
template <class T>
Result<Image<T>> of_same_size(Image<T> image, const FittedImage& drawing, const std::string& name) {
  if (!has_size_of(image, drawing.rgba)) return wrong_size(drawing, name);
  return image;
}

Result<understanding::Scribbles> strokes_of(const Bytes& bytes, const FittedImage& drawing) {
  if (is_png(bytes)) {
    auto picture = decode_png(bytes);
    if (!picture) return picture.error();
    return scribbles_from_image(sampled(std::move(*picture), drawing), drawing.rgba.width,
                                drawing.rgba.height);
  }
  auto scribbles = read_scribbles(text_of(bytes));
  if (!scribbles) return scribbles;
  const double scale = static_cast<double>(drawing.times) / drawing.factor;
  for (understanding::Scribble& stroke : scribbles->strokes) {
    stroke.width *= scale;
    for (Point2& point : stroke.points) point = scale * point;
  }
  return scribbles;
}

}  // namespace

Error wrong_size(const FittedImage& drawing, const std::string& name) {
  return {ErrorCode::bad_input,
          "must be as large as the drawing, " + std::to_string(drawing.rgba.width / drawing.times) +
              " x " + std::to_string(drawing.rgba.height / drawing.times) + " pixels",
          name};
}

Result<Image16> read_labels(const std::string& name, const FittedImage& drawing) {
  auto labels = read_as(name, [](const Bytes& bytes) { return decode_png_values(bytes); });
  if (!labels) return labels.error();
  return of_same_size(sampled(std::move(*labels), drawing), drawing, name);
}

Result<Image8> read_mask(const std::string& name, const FittedImage& drawing) {
  auto mask = read_as(name, [](const Bytes& bytes) { return decode_fitted(bytes); });
  if (!mask) return mask.error();
  return of_same_size(std::move(mask->rgba), drawing, name);
}

Result<understanding::Scribbles> read_strokes(const std::string& name, const FittedImage& drawing) {
  return read_as(name, [&](const Bytes& bytes) { return strokes_of(bytes, drawing); });
}

}  // namespace relievo::cli
