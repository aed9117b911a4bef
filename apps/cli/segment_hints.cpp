#include "apps/cli/segment_hints.h"

#include <algorithm>
#include <utility>

#include "api/inputs.h"
#include "io/files/paths.h"
#include "io/image/png.h"
#include "io/image/row_average.h"
#include "io/scribbles/scribble_image.h"
#include "io/scribbles/scribbles_json.h"
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

/// Takes the pixel in the middle of each square of an image as large as the drawing's file, since
/// colours and labels have no averages. Returns other images as they are.
template <class T>
Image<T> sampled(Image<T> image, const ReducedImage& drawing) {
  const int factor = drawing.factor;
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
Result<Image<T>> of_same_size(Image<T> image, const Image8& drawing, const std::string& name) {
  if (!has_size_of(image, drawing)) return wrong_size(drawing, name);
  return image;
}

Result<understanding::Scribbles> strokes_of(const Bytes& bytes, const ReducedImage& drawing) {
  if (is_png(bytes)) {
    auto picture = decode_png(bytes);
    if (!picture) return picture.error();
    return scribbles_from_image(sampled(std::move(*picture), drawing), drawing.rgba.width,
                                drawing.rgba.height);
  }
  auto scribbles = read_scribbles(text_of(bytes));
  if (!scribbles) return scribbles;
  for (understanding::Scribble& stroke : scribbles->strokes) {
    stroke.width /= drawing.factor;
    for (Point2& point : stroke.points) point = (1.0 / drawing.factor) * point;
  }
  return scribbles;
}

}  // namespace

Error wrong_size(const Image8& drawing, const std::string& name) {
  return {ErrorCode::bad_input,
          "must be as large as the drawing, " + std::to_string(drawing.width) + " x " +
              std::to_string(drawing.height) + " pixels",
          name};
}

Result<Image16> read_labels(const std::string& name, const ReducedImage& drawing) {
  auto labels = read_as(name, [](const Bytes& bytes) { return decode_png_values(bytes); });
  if (!labels) return labels.error();
  return of_same_size(sampled(std::move(*labels), drawing), drawing.rgba, name);
}

Result<Image8> read_mask(const std::string& name, const ReducedImage& drawing) {
  auto mask = read_as(name, [](const Bytes& bytes) { return decode_reduced(bytes); });
  if (!mask) return mask.error();
  return of_same_size(std::move(mask->rgba), drawing.rgba, name);
}

Result<understanding::Scribbles> read_strokes(const std::string& name,
                                              const ReducedImage& drawing) {
  return read_as(name, [&](const Bytes& bytes) { return strokes_of(bytes, drawing); });
}

}  // namespace relievo::cli
