#include "io/image/decode_image.h"

// libjpeg's headers need these before them.
// clang-format off
#include <cstddef>
#include <cstdio>
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <string>
#include <vector>

#include "io/files/file_kind.h"
#include "io/image/gif.h"
#include "io/image/heif.h"
#include "io/image/jpeg_header.h"
#include "io/image/orientation.h"
#include "io/image/png.h"
#include "io/image/row_average.h"
#include "io/image/webp.h"
#include "kernel/image/enlarge.h"

namespace relievo {
namespace {

constexpr int max_scans = 100;

/// State that must survive a jump, by which libjpeg reports failures.
struct JpegReader {
  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg_progress_mgr progress = {};
  std::jmp_buf jump = {};
  std::array<char, JMSG_LENGTH_MAX> message = {};

  JpegReader() = default;
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
};

[[noreturn]] void on_error(j_common_ptr common) {
  auto* reader = static_cast<JpegReader*>(common->client_data);
  common->err->format_message(common, reader->message.data());
  std::longjmp(reader->jump, 1);
}

bool loses_pixels(int message_code) {
  return message_code == JWRN_JPEG_EOF || message_code == JWRN_HIT_MARKER ||
         message_code == JWRN_HUFF_BAD_CODE || message_code == JWRN_MUST_RESYNC;
}

void on_message(j_common_ptr common, int level) {
  if (level < 0 && loses_pixels(common->err->msg_code)) on_error(common);
}

/// A file of a few kB can ask for thousands of passes over the whole image.
void on_progress(j_common_ptr common) {
  auto* reader = static_cast<JpegReader*>(common->client_data);
  if (reader->jpeg.input_scan_number <= max_scans) return;
  std::snprintf(reader->message.data(), reader->message.size(), "it has too many scans");
  std::longjmp(reader->jump, 1);
}

bool read_header(JpegReader& reader, ByteView bytes) {
  reader.jpeg.err = jpeg_std_error(&reader.errors);
  reader.errors.error_exit = on_error;
  reader.errors.emit_message = on_message;
  reader.jpeg.client_data = &reader;
  if (setjmp(reader.jump) != 0) return false;
  jpeg_create_decompress(&reader.jpeg);
  reader.progress.progress_monitor = on_progress;
  reader.jpeg.progress = &reader.progress;
  jpeg_mem_src(&reader.jpeg, bytes.data(), bytes.size());
  jpeg_save_markers(&reader.jpeg, JPEG_APP0 + 1, 0xffff);
  jpeg_read_header(&reader.jpeg, TRUE);
  return true;
}

bool is_cmyk(const JpegReader& reader) {
  return reader.jpeg.jpeg_color_space == JCS_CMYK || reader.jpeg.jpeg_color_space == JCS_YCCK;
}

/// Turns ink amounts into light, in place. Adobe's files store 255 - ink.
void cmyk_to_rgba(Bytes& row, bool inverted) {
  for (size_t i = 0; i < row.size(); i += 4) {
    uint8_t* pixel = &row[i];
    if (!inverted)
      for (int c = 0; c < 4; ++c) pixel[c] = static_cast<uint8_t>(255 - pixel[c]);
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<uint8_t>((pixel[c] * pixel[3] + 127) / 255);
    pixel[3] = 255;
  }
}

bool read_pixels(JpegReader& reader, Bytes& row, RowAverage& average) {
  if (setjmp(reader.jump) != 0) return false;
  reader.jpeg.out_color_space = is_cmyk(reader) ? JCS_CMYK : JCS_EXT_RGBA;
  jpeg_start_decompress(&reader.jpeg);
  while (reader.jpeg.output_scanline < reader.jpeg.output_height) {
    JSAMPROW target = row.data();
    jpeg_read_scanlines(&reader.jpeg, &target, 1);
    if (is_cmyk(reader)) cmyk_to_rgba(row, reader.jpeg.saw_Adobe_marker == TRUE);
    average.add(row.data());
  }
  jpeg_finish_decompress(&reader.jpeg);
  return true;
}

/// Returns the largest divisor of `factor` by which libjpeg reduces each block while it decodes it.
int divisor_in_blocks(int factor) {
  int divisor = 8;
  while (factor % divisor != 0) divisor /= 2;
  return divisor;
}

int orientation_of(const JpegReader& reader) {
  for (const jpeg_marker_struct* marker = reader.jpeg.marker_list; marker; marker = marker->next)
    if (const int value = exif_orientation({marker->data, marker->data_length}); value != 1)
      return value;
  return 1;
}

/// Every 8 x 8 block takes at least one bit in a Huffman-coded file.
bool too_short(const JpegReader& reader, size_t byte_count) {
  const uint64_t blocks = uint64_t{reader.jpeg.image_width / 8} * (reader.jpeg.image_height / 8);
  return reader.jpeg.arith_code == FALSE && blocks / 8 > byte_count;
}

Result<Image8> decode(ByteView bytes, const ImageLimits& limits, int factor) {
  if (is_png(bytes)) {
    auto image = decode_png(bytes, limits, factor);
    if (!image) return image;
    return upright(std::move(*image), png_orientation(bytes));
  }
  if (is_jpeg(bytes)) return decode_jpeg(bytes, limits, factor);
  if (is_gif(bytes)) {
    auto image = decode_gif(bytes, limits);
    if (!image) return image;
    return averaged(std::move(*image), factor);
  }
  if (is_webp(bytes)) return decode_webp(bytes, limits, factor);
  if (is_heif(bytes)) return decode_heif(bytes, limits, factor);
  if (is_nearly_png(bytes)) return decode_png(bytes, limits);  // which names the defect
  return refused_file(bytes);
}

/// Reads a picture's size in its header.
Result<ImageSize> size_in_header(ByteView bytes, const ImageLimits& limits) {
  if (is_png(bytes)) return png_size(bytes, streamed(limits));
  if (is_jpeg(bytes)) return jpeg_size(bytes, streamed(limits));
  if (is_gif(bytes)) return gif_size(bytes, limits);
  if (is_webp(bytes)) return webp_size(bytes, limits);
  if (is_heif(bytes)) return heif_size(bytes, limits);
  return refused_file(bytes);
}

}  // namespace

Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits) {
  return decode(bytes, limits, 1);
}

FittedImage fitted(Image8 rgba) {
  const int factor = reduction_factor(rgba.width, rgba.height);
  const int times = enlargement(rgba.width, rgba.height);
  return {enlarged(averaged(std::move(rgba), factor), times), factor, times};
}

Result<FittedImage> decode_fitted(ByteView bytes, const ImageLimits& limits) {
  const auto size = size_in_header(bytes, limits);
  if (!size && size.error().code == ErrorCode::limit) return size.error();
  // The decoder says what is wrong with a header.
  const int factor = size ? reduction_factor(size->width, size->height) : 1;
  auto image = decode(bytes, limits, factor);
  if (!image) return image.error();
  const int times = enlargement(image->width, image->height);
  return FittedImage{enlarged(std::move(*image), times), factor, times};
}

Result<Image8> decode_jpeg(ByteView bytes, const ImageLimits& limits, int factor) {
  if (!is_jpeg(bytes)) return damaged_image("JPEG", "it does not begin with the JPEG signature");
  JpegReader reader;
  if (!read_header(reader, bytes)) return damaged_image("JPEG", reader.message.data());
  const bool by_rows = factor > 1 && jpeg_has_multiple_scans(&reader.jpeg) == FALSE;
  const Status size = check_image_size(reader.jpeg.image_width, reader.jpeg.image_height,
                                       by_rows ? streamed(limits) : limits);
  if (!size) return size.error();
  if (too_short(reader, bytes.size())) return damaged_image("JPEG", "it ends early");
  const int orientation = orientation_of(reader);

  const int divisor = divisor_in_blocks(factor);
  const int width = reduced_side(static_cast<int>(reader.jpeg.image_width), divisor);
  const int height = reduced_side(static_cast<int>(reader.jpeg.image_height), divisor);
  reader.jpeg.scale_denom = static_cast<unsigned>(divisor);
  RowAverage average(width, height, factor / divisor);
  Bytes row(size_t{4} * static_cast<size_t>(width));
  if (!read_pixels(reader, row, average)) return damaged_image("JPEG", reader.message.data());
  return upright(average.take(), orientation);
}

}  // namespace relievo
