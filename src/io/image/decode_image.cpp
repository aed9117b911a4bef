#include "io/image/decode_image.h"

// libjpeg's headers need these before them.
// clang-format off
#include <cstddef>
#include <cstdio>
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <string>
#include <vector>

#include "io/image/png.h"

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

bool read_pixels(JpegReader& reader, Image8& image) {
  if (setjmp(reader.jump) != 0) return false;
  reader.jpeg.out_color_space = is_cmyk(reader) ? JCS_CMYK : JCS_EXT_RGBA;
  jpeg_start_decompress(&reader.jpeg);
  while (reader.jpeg.output_scanline < reader.jpeg.output_height) {
    JSAMPROW row = &image.at(0, static_cast<int>(reader.jpeg.output_scanline));
    jpeg_read_scanlines(&reader.jpeg, &row, 1);
  }
  jpeg_finish_decompress(&reader.jpeg);
  return true;
}

/// Turns ink amounts into light, in place. Adobe's files store 255 - ink.
void cmyk_to_rgba(Image8& image, bool inverted) {
  for (size_t i = 0; i < image.pixels.size(); i += 4) {
    uint8_t* pixel = &image.pixels[i];
    if (!inverted)
      for (int c = 0; c < 4; ++c) pixel[c] = static_cast<uint8_t>(255 - pixel[c]);
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<uint8_t>((pixel[c] * pixel[3] + 127) / 255);
    pixel[3] = 255;
  }
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

constexpr uint32_t orientation_tag = 0x0112;
constexpr uint32_t type_short = 3;

/// Reads numbers of a TIFF block; those beyond its end are 0.
struct TiffView {
  ByteView bytes;
  bool big_endian = false;

  uint32_t byte(size_t at) const { return at < bytes.size() ? bytes[at] : 0; }
  uint32_t u16(size_t at) const {
    return big_endian ? byte(at) << 8 | byte(at + 1) : byte(at + 1) << 8 | byte(at);
  }
  uint32_t u32(size_t at) const {
    return big_endian ? u16(at) << 16 | u16(at + 2) : u16(at + 2) << 16 | u16(at);
  }
};

/// A code of 12 bits stands for at most 4096 pixels: 4096 / 1.5.
constexpr int64_t most_pixels_per_byte = 2731;

int read_bytes(GifFileType* gif, GifByteType* out, int count) {
  auto* rest = static_cast<ByteView*>(gif->UserData);
  const size_t available = std::min(rest->size(), static_cast<size_t>(count));
  std::memcpy(out, rest->data(), available);
  *rest = rest->subspan(available);
  return static_cast<int>(available);
}

class GifReader {
 public:
  explicit GifReader(ByteView bytes) : rest_(bytes), size_(static_cast<int64_t>(bytes.size())) {
    gif_ = DGifOpen(&rest_, read_bytes, &error_);
  }
  GifReader(const GifReader&) = delete;
  GifReader& operator=(const GifReader&) = delete;
  ~GifReader() {
    if (gif_ != nullptr) DGifCloseFile(gif_, &error_);
  }

  Result<Image8> read(const ImageLimits& limits) {
    if (gif_ == nullptr) return damaged_image("GIF", reason());
    if (Status size = check_image_size(gif_->SWidth, gif_->SHeight, limits); !size)
      return size.error();
    if (int64_t{gif_->SWidth} * gif_->SHeight / most_pixels_per_byte > size_)
      return damaged_image("GIF", "it ends early");
    for (;;) {
      GifRecordType record = UNDEFINED_RECORD_TYPE;
      if (DGifGetRecordType(gif_, &record) == GIF_ERROR) return damaged_image("GIF", reason());
      if (record == TERMINATE_RECORD_TYPE) return damaged_image("GIF", "it holds no picture");
      if (record == IMAGE_DESC_RECORD_TYPE) return read_picture();
      if (record == EXTENSION_RECORD_TYPE && !read_extension())
        return damaged_image("GIF", reason());
    }
  }

 private:
  std::string reason() const {
    const char* text = GifErrorString(gif_ != nullptr ? gif_->Error : error_);
    return text != nullptr ? text : "it ends early";
  }

  bool read_extension() {
    int code = 0;
    GifByteType* block = nullptr;
    if (DGifGetExtension(gif_, &code, &block) == GIF_ERROR) return false;
    while (block != nullptr) {
      GraphicsControlBlock control;
      if (code == GRAPHICS_EXT_FUNC_CODE &&
          DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK)
        transparent_ = control.TransparentColor;
      if (DGifGetExtensionNext(gif_, &block) == GIF_ERROR) return false;
    }
    return true;
  }

  Result<Image8> read_picture() {
    if (DGifGetImageDesc(gif_) == GIF_ERROR) return damaged_image("GIF", reason());
    const GifImageDesc& at = gif_->Image;
    const ColorMapObject* colors = at.ColorMap != nullptr ? at.ColorMap : gif_->SColorMap;
    if (colors == nullptr) return damaged_image("GIF", "it has no colours");
    if (at.Left < 0 || at.Top < 0 || at.Width <= 0 || at.Height <= 0 ||
        at.Left + at.Width > gif_->SWidth || at.Top + at.Height > gif_->SHeight)
      return damaged_image("GIF", "its picture lies outside its canvas");
    Image8 image(gif_->SWidth, gif_->SHeight, 4);
    std::vector<GifPixelType> line(static_cast<size_t>(at.Width));
    for (const int y : row_order(at)) {
      if (DGifGetLine(gif_, line.data(), at.Width) == GIF_ERROR)
        return damaged_image("GIF", reason());
      if (!paint(line, *colors, &image.at(at.Left, at.Top + y)))
        return damaged_image("GIF", "a pixel has no colour");
    }
    return image;
  }

  static std::vector<int> row_order(const GifImageDesc& at) {
    constexpr std::array<std::array<int, 2>, 4> passes = {{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
    std::vector<int> rows;
    if (at.Interlace)
      for (const auto& [first, step] : passes)
        for (int y = first; y < at.Height; y += step) rows.push_back(y);
    else
      for (int y = 0; y < at.Height; ++y) rows.push_back(y);
    return rows;
  }

  bool paint(const std::vector<GifPixelType>& line, const ColorMapObject& colors,
             uint8_t* out) const {
    for (const GifPixelType index : line) {
      if (index >= colors.ColorCount) return false;
      const GifColorType& color = colors.Colors[index];
      const uint8_t alpha = index == transparent_ ? 0 : 255;
      for (const uint8_t value : {color.Red, color.Green, color.Blue, alpha}) *out++ = value;
    }
    return true;
  }

  ByteView rest_;
  int64_t size_;
  int error_ = 0;
  GifFileType* gif_ = nullptr;
  int transparent_ = NO_TRANSPARENT_COLOR;
};

}  // namespace

Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits) {
  if (is_png(bytes)) return decode_png(bytes, limits);
  if (is_jpeg(bytes)) return decode_jpeg(bytes, limits);
  if (is_gif(bytes)) return decode_gif(bytes, limits);
  if (is_nearly_png(bytes)) return decode_png(bytes, limits);  // which names the defect
  return Error{ErrorCode::bad_input, "is neither a PNG nor a JPEG nor a GIF picture", ""};
}

bool is_jpeg(ByteView bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

Result<Image8> decode_jpeg(ByteView bytes, const ImageLimits& limits) {
  if (!is_jpeg(bytes)) return damaged_image("JPEG", "it does not begin with the JPEG signature");
  JpegReader reader;
  if (!read_header(reader, bytes)) return damaged_image("JPEG", reader.message.data());
  const Status size = check_image_size(reader.jpeg.image_width, reader.jpeg.image_height, limits);
  if (!size) return size.error();
  if (too_short(reader, bytes.size())) return damaged_image("JPEG", "it ends early");
  const int orientation = orientation_of(reader);

  Image8 image(static_cast<int>(reader.jpeg.image_width),
               static_cast<int>(reader.jpeg.image_height), 4);
  if (!read_pixels(reader, image)) return damaged_image("JPEG", reader.message.data());
  if (is_cmyk(reader)) cmyk_to_rgba(image, reader.jpeg.saw_Adobe_marker == TRUE);
  return orientation == 1 ? image : upright(image, orientation);
}

int exif_orientation(ByteView exif) {
  if (exif.size() < 14 || std::memcmp(exif.data(), "Exif\0\0", 6) != 0) return 1;
  const TiffView tiff{exif.subspan(6), exif[6] == 'M'};
  if (tiff.u16(2) != 42) return 1;
  const size_t directory = tiff.u32(4);
  const uint32_t count = tiff.u16(directory);
  for (uint32_t i = 0; i < count; ++i) {
    const size_t entry = directory + 2 + size_t{12} * i;
    if (entry >= tiff.bytes.size()) break;
    if (tiff.u16(entry) != orientation_tag || tiff.u16(entry + 2) != type_short) continue;
    const uint32_t value = tiff.u16(entry + 8);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

Image8 upright(const Image8& image, int orientation) {
  const bool transposed = orientation >= 5;
  const bool mirrored_x =
      orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool mirrored_y =
      orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Image8 result(transposed ? image.height : image.width, transposed ? image.width : image.height,
                image.channels);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      int from_x = transposed ? y : x;
      int from_y = transposed ? x : y;
      if (mirrored_x) from_x = image.width - 1 - from_x;
      if (mirrored_y) from_y = image.height - 1 - from_y;
      for (int c = 0; c < image.channels; ++c) result.at(x, y, c) = image.at(from_x, from_y, c);
    }
  return result;
}

bool is_gif(ByteView bytes) {
  return bytes.size() >= 6 && std::memcmp(bytes.data(), "GIF8", 4) == 0 &&
         (bytes[4] == '7' || bytes[4] == '9') && bytes[5] == 'a';
}

Result<Image8> decode_gif(ByteView bytes, const ImageLimits& limits) {
  if (!is_gif(bytes)) return damaged_image("GIF", "it does not begin with the GIF signature");
  return GifReader(bytes).read(limits);
}

}  // namespace relievo
