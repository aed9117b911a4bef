#include "io/image/heif.h"

#include <libheif/heif.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "io/image/row_average.h"

namespace relievo {
namespace {

/// Number of bytes up to the end of a file's kind.
constexpr size_t brand_end = 12;

/// Frees what libheif hands out.
struct ReleaseHeif {
  void operator()(heif_context* context) const { heif_context_free(context); }
  void operator()(heif_image_handle* handle) const { heif_image_handle_release(handle); }
  void operator()(heif_image* image) const { heif_image_release(image); }
  void operator()(heif_decoding_options* options) const { heif_decoding_options_free(options); }
};

template <class T>
using OwnedHeif = std::unique_ptr<T, ReleaseHeif>;

bool begins(ByteView bytes, std::string_view brand) {
  const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  return bytes.size() >= brand_end && text.substr(4, brand.size()) == brand;
}

Error damaged_heif(ByteView bytes, const heif_error& error) {
  return damaged_image(is_avif(bytes) ? "AVIF" : "HEIC", error.message);
}

/// Undoes the multiplication of colours by their alpha.
void straighten(Bytes& row) {
  for (size_t i = 0; i < row.size(); i += 4) {
    const int alpha = row[i + 3];
    if (alpha == 0) continue;
    for (size_t c = i; c < i + 3; ++c)
      row[c] = static_cast<uint8_t>(std::min(255, (255 * row[c] + alpha / 2) / alpha));
  }
}

/// The main picture of an open file.
struct HeifFile {
  OwnedHeif<heif_context> context;
  OwnedHeif<heif_image_handle> picture;
  ImageSize size;
};

Result<HeifFile> open_heif(ByteView bytes, const ImageLimits& limits) {
  HeifFile file{OwnedHeif<heif_context>(heif_context_alloc()), nullptr, {}};
  heif_error error = heif_context_read_from_memory_without_copy(file.context.get(), bytes.data(),
                                                                bytes.size(), nullptr);
  if (error.code != heif_error_Ok) return damaged_heif(bytes, error);
  heif_image_handle* found = nullptr;
  error = heif_context_get_primary_image_handle(file.context.get(), &found);
  if (error.code != heif_error_Ok) return damaged_heif(bytes, error);
  file.picture.reset(found);
  file.size = {heif_image_handle_get_width(found), heif_image_handle_get_height(found)};
  const Status size = check_image_size(file.size.width, file.size.height, limits);
  if (!size) return size.error();
  return file;
}

/// Copies the decoded rows, or reduces them.
Image8 rows_of(const heif_image* decoded, bool premultiplied, int factor) {
  int stride = 0;
  const uint8_t* rows = heif_image_get_plane_readonly(decoded, heif_channel_interleaved, &stride);
  const int width = heif_image_get_width(decoded, heif_channel_interleaved);
  const int height = heif_image_get_height(decoded, heif_channel_interleaved);
  if (rows == nullptr || width <= 0 || height <= 0) return {};
  RowAverage average(width, height, factor);
  Bytes row(size_t{4} * static_cast<size_t>(width));
  for (int y = 0; y < height; ++y) {
    std::memcpy(row.data(), rows + static_cast<ptrdiff_t>(stride) * y, row.size());
    if (premultiplied) straighten(row);
    average.add(row.data());
  }
  return average.take();
}

}  // namespace

bool is_heif(ByteView bytes) {
  return begins(bytes, "ftyphe") || begins(bytes, "ftypmif1") || begins(bytes, "ftypmsf1") ||
         is_avif(bytes);
}

bool is_avif(ByteView bytes) { return begins(bytes, "ftypavi"); }

Result<ImageSize> heif_size(ByteView bytes, const ImageLimits& limits) {
  const auto file = open_heif(bytes, limits);
  if (!file) return file.error();
  return file->size;
}

Result<Image8> decode_heif(ByteView bytes, const ImageLimits& limits, int factor) {
  const auto file = open_heif(bytes, limits);
  if (!file) return file.error();
  const OwnedHeif<heif_decoding_options> options(heif_decoding_options_alloc());
  options->convert_hdr_to_8bit = 1;
  heif_image* decoded = nullptr;
  const heif_error error = heif_decode_image(file->picture.get(), &decoded, heif_colorspace_RGB,
                                             heif_chroma_interleaved_RGBA, options.get());
  if (error.code != heif_error_Ok) return damaged_heif(bytes, error);
  const OwnedHeif<heif_image> pixels(decoded);
  const bool premultiplied = heif_image_handle_is_premultiplied_alpha(file->picture.get()) != 0;
  Image8 image = rows_of(decoded, premultiplied, factor);
  if (image.empty()) return damaged_heif(bytes, {{}, {}, "it has no pixels"});
  return image;
}

}  // namespace relievo
