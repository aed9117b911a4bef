#include "io/image/heif.h"

#include <libheif/heif.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

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
void straighten(Image8& image) {
  for (size_t i = 0; i < image.pixels.size(); i += 4) {
    const int alpha = image.pixels[i + 3];
    if (alpha == 0) continue;
    for (size_t c = i; c < i + 3; ++c)
      image.pixels[c] =
          static_cast<uint8_t>(std::min(255, (255 * image.pixels[c] + alpha / 2) / alpha));
  }
}

}  // namespace

bool is_heif(ByteView bytes) {
  return begins(bytes, "ftyphe") || begins(bytes, "ftypmif1") || begins(bytes, "ftypmsf1") ||
         is_avif(bytes);
}

bool is_avif(ByteView bytes) { return begins(bytes, "ftypavi"); }

Result<Image8> decode_heif(ByteView bytes, const ImageLimits& limits) {
  const OwnedHeif<heif_context> context(heif_context_alloc());
  heif_error error = heif_context_read_from_memory_without_copy(context.get(), bytes.data(),
                                                                bytes.size(), nullptr);
  if (error.code != heif_error_Ok) return damaged_heif(bytes, error);
  heif_image_handle* found = nullptr;
  error = heif_context_get_primary_image_handle(context.get(), &found);
  if (error.code != heif_error_Ok) return damaged_heif(bytes, error);
  const OwnedHeif<heif_image_handle> handle(found);
  const Status size = check_image_size(heif_image_handle_get_width(found),
                                       heif_image_handle_get_height(found), limits);
  if (!size) return size.error();
  const OwnedHeif<heif_decoding_options> options(heif_decoding_options_alloc());
  options->convert_hdr_to_8bit = 1;
  heif_image* decoded = nullptr;
  error = heif_decode_image(found, &decoded, heif_colorspace_RGB, heif_chroma_interleaved_RGBA,
                            options.get());
  if (error.code != heif_error_Ok) return damaged_heif(bytes, error);
  const OwnedHeif<heif_image> pixels(decoded);
  int stride = 0;
  const uint8_t* rows = heif_image_get_plane_readonly(decoded, heif_channel_interleaved, &stride);
  Image8 image(heif_image_get_width(decoded, heif_channel_interleaved),
               heif_image_get_height(decoded, heif_channel_interleaved), 4);
  if (rows == nullptr || image.empty()) return damaged_heif(bytes, {{}, {}, "it has no pixels"});
  for (int y = 0; y < image.height; ++y)
    std::memcpy(&image.at(0, y), rows + static_cast<ptrdiff_t>(stride) * y,
                size_t{4} * image.width);
  if (heif_image_handle_is_premultiplied_alpha(found) != 0) straighten(image);
  return image;
}

}  // namespace relievo
