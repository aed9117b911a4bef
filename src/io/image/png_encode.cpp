#include "io/image/png_encode.h"

#include <png.h>

#include <string>

namespace relievo {
namespace {

int colour_type(int channels) {
  if (channels == 1) return PNG_COLOR_TYPE_GRAY;
  return channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA;
}

struct PngWriter {
  png_structp png = nullptr;
  png_infop info = nullptr;
  png_uint_32 width;
  png_uint_32 height;
  int bit_depth;
  int colours;
  Bytes bytes = {};
  std::string message = {};

  PngWriter(int image_width, int image_height, int depth, int channels)
      : width(static_cast<png_uint_32>(image_width)),
        height(static_cast<png_uint_32>(image_height)),
        bit_depth(depth),
        colours(colour_type(channels)) {}
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

[[noreturn]] void on_write_error(png_structp png, png_const_charp message) {
  static_cast<PngWriter*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

void on_write_warning(png_structp, png_const_charp) {}

void on_write(png_structp png, png_bytep data, size_t count) {
  Bytes& bytes = static_cast<PngWriter*>(png_get_io_ptr(png))->bytes;
  bytes.insert(bytes.end(), data, data + count);
}

void on_flush(png_structp) {}

bool write_all(PngWriter& writer, std::vector<png_text>& notes, std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
  png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_write_fn(writer.png, &writer, on_write, on_flush);
  png_set_compression_level(writer.png, 4);
  png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP | PNG_FILTER_AVG);
  png_set_IHDR(writer.png, writer.info, writer.width, writer.height, writer.bit_depth,
               writer.colours, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (!notes.empty())
    png_set_text(writer.png, writer.info, notes.data(), static_cast<int>(notes.size()));
  png_write_info(writer.png, writer.info);
  png_write_image(writer.png, rows.data());
  png_write_end(writer.png, writer.info);
  return true;
}

Result<Bytes> encode(PngWriter& writer, std::vector<png_bytep> rows,
                     const std::vector<PngText>& texts) {
  if (rows.empty() || writer.width == 0)
    return Error{ErrorCode::bad_input, "an image without pixels cannot be written", ""};
  std::vector<png_text> notes;
  for (const PngText& text : texts) {
    png_text note = {};
    note.compression = PNG_TEXT_COMPRESSION_NONE;
    note.key = const_cast<png_charp>(text.keyword.c_str());
    note.text = const_cast<png_charp>(text.text.c_str());
    note.text_length = text.text.size();
    notes.push_back(note);
  }
  writer.png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, on_write_error, on_write_warning);
  if (writer.png != nullptr) writer.info = png_create_info_struct(writer.png);
  if (writer.info == nullptr || !write_all(writer, notes, rows))
    return Error{ErrorCode::internal, "the image cannot be written as PNG: " + writer.message, ""};
  return std::move(writer.bytes);
}

}  // namespace

Result<Bytes> encode_png(const Image8& image, const std::vector<PngText>& texts) {
  if (image.channels != 1 && image.channels != 3 && image.channels != 4)
    return Error{ErrorCode::bad_input, "only 1, 3 or 4 channels can be written as PNG", ""};
  std::vector<png_bytep> rows;
  if (!image.empty())
    for (int y = 0; y < image.height; ++y) rows.push_back(const_cast<png_bytep>(&image.at(0, y)));
  PngWriter writer(image.width, image.height, 8, image.channels);
  return encode(writer, rows, texts);
}

Result<Bytes> encode_png(const Image16& image, const std::vector<PngText>& texts) {
  if (image.channels != 1)
    return Error{ErrorCode::bad_input, "only 1 channel of 16 bits can be written as PNG", ""};
  std::vector<uint8_t> big_endian;
  big_endian.reserve(image.pixels.size() * 2);
  for (const uint16_t sample : image.pixels) {
    big_endian.push_back(static_cast<uint8_t>(sample >> 8));
    big_endian.push_back(static_cast<uint8_t>(sample & 0xff));
  }
  std::vector<png_bytep> rows;
  if (!image.empty())
    for (int y = 0; y < image.height; ++y)
      rows.push_back(big_endian.data() + size_t{2} * image.width * y);
  PngWriter writer(image.width, image.height, 16, 1);
  return encode(writer, rows, texts);
}

}  // namespace relievo
