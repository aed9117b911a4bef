#include "io/image/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/image/image_limits.h"
#include "io/image/orientation.h"
#include "io/image/row_average.h"

namespace relievo {
namespace {

/// The first bytes of every PNG file.
constexpr std::array<uint8_t, 8> png_signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

constexpr size_t header_end = 33;
/// Deflate cannot pack its input tighter than this.
constexpr uint64_t max_deflate_ratio = 1032;

int64_t big_endian(const uint8_t* at) {
  return int64_t{at[0]} << 24 | int64_t{at[1]} << 16 | int64_t{at[2]} << 8 | int64_t{at[3]};
}

/// Keeps the message in the string that the reader or writer gives libpng, and jumps.
[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

/// State that must survive a jump, by which libpng reports failures.
struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ByteView rest;
  std::string message;
  uint64_t packed_row_bytes = 0;

  PngReader() = default;
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void on_read(png_structp png, png_bytep out, size_t count) {
  auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
  if (reader->rest.size() < count) png_error(png, "it ends early");
  std::memcpy(out, reader->rest.data(), count);
  reader->rest = reader->rest.subspan(count);
}

/// The kind of values in the rows.
enum class Samples {
  rgba,    ///< 8-bit RGBA
  values,  ///< grey values or palette indices as they are, 8 or 16 bits
};

void convert(PngReader& reader, Samples samples) {
  if (samples == Samples::values) {
    png_set_packing(reader.png);
    png_set_strip_alpha(reader.png);
  } else {
    png_set_expand(reader.png);
    png_set_scale_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 0xff, PNG_FILLER_AFTER);
  }
}

bool read_header(PngReader& reader, const ImageLimits& limits, Samples samples) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  const auto max_side = static_cast<png_uint_32>(limits.max_side);
  png_set_user_limits(reader.png, max_side, max_side);
  png_set_chunk_malloc_max(reader.png, png_alloc_size_t{8} << 20);
  png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_read_fn(reader.png, &reader, on_read);
  png_read_info(reader.png, reader.info);
  reader.packed_row_bytes = png_get_rowbytes(reader.png, reader.info);
  convert(reader, samples);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

bool read_pixels(PngReader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

bool read_pixels(PngReader& reader, Bytes& row, int height, RowAverage& average) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  for (int y = 0; y < height; ++y) {
    png_read_row(reader.png, row.data(), nullptr);
    average.add(row.data());
  }
  png_read_end(reader.png, nullptr);
  return true;
}

/// Returns the content of the first chunk with this name; empty where there is none.
ByteView chunk_of(ByteView bytes, std::string_view name) {
  constexpr size_t around = 12;  // bytes of a chunk's length, name and checksum
  if (bytes.size() < png_signature.size()) return {};
  ByteView rest = bytes.subspan(png_signature.size());
  while (rest.size() >= around) {
    const auto size = static_cast<size_t>(big_endian(rest.data()));
    if (size > rest.size() - around) return {};
    if (std::memcmp(rest.data() + 4, name.data(), 4) == 0) return rest.subspan(8, size);
    rest = rest.subspan(around + size);
  }
  return {};
}

constexpr size_t least_alike = 5;
constexpr size_t first_line_end = 4;
constexpr size_t bit_depth_at = 24;
constexpr size_t color_type_at = 25;
constexpr size_t interlacing_at = 28;

/// The bit depths of the colour types that exist.
const std::map<int, std::vector<int>> bit_depths = {
    {0, {1, 2, 4, 8, 16}}, {2, {8, 16}}, {3, {1, 2, 4, 8}}, {4, {8, 16}}, {6, {8, 16}}};

size_t equal_bytes(ByteView bytes) {
  size_t count = 0;
  for (size_t i = 0; i < std::min(bytes.size(), png_signature.size()); ++i)
    count += bytes[i] == png_signature[i] ? 1 : 0;
  return count;
}

/// Returns whether the signature's line ends are all of one other kind, as after a transfer as
/// text.
bool has_other_line_ends(ByteView bytes) {
  const auto is_line_end = [](uint8_t byte) { return byte == '\r' || byte == '\n'; };
  if (bytes.size() < png_signature.size() ||
      equal_bytes(bytes.first(first_line_end)) < first_line_end)
    return false;
  return is_line_end(bytes[4]) && is_line_end(bytes[5]) && (bytes[6] == 0x1a || bytes[7] == 0x1a);
}

std::string header_defect(ByteView bytes) {
  const int color_type = bytes[color_type_at];
  const int depth = bytes[bit_depth_at];
  const auto known = bit_depths.find(color_type);
  if (known == bit_depths.end()) return "there is no colour type " + std::to_string(color_type);
  if (std::find(known->second.begin(), known->second.end(), depth) == known->second.end())
    return "colour type " + std::to_string(color_type) + " has no bit depth of " +
           std::to_string(depth);
  return "its header (IHDR) holds values that do not exist";
}

/// Returns the common name of a chunk.
std::string chunk_in_words(const std::string& name) {
  if (name == "IHDR") return "header (IHDR)";
  if (name == "IDAT") return "pixels (IDAT)";
  if (name == "PLTE") return "palette (PLTE)";
  return name + " chunk";
}

/// Returns the defect of a wrong signature.
std::string signature_defect(ByteView bytes) {
  if (has_other_line_ends(bytes))
    return "the line ends in its signature were changed, as by a transfer as text";
  if (!is_nearly_png(bytes)) return "it does not begin with the PNG signature";
  size_t at = 0;
  while (at < png_signature.size() && bytes[at] == png_signature[at]) ++at;
  return "byte " + std::to_string(at + 1) + " of its signature is wrong";
}

/// Returns the defect that libpng's message reports, with the part of the file. Precondition:
/// `bytes` hold a whole header.
std::string png_defect(ByteView bytes, const std::string& message) {
  if (message == "Invalid IHDR data") return header_defect(bytes);
  if (message == "IEND: out of place") return "it has no pixels (IDAT)";
  const size_t colon = message.find(": CRC error");
  if (colon != std::string::npos)
    return "the checksum of its " + chunk_in_words(message.substr(0, colon)) + " is wrong";
  return message;
}

/// Reads the header of a file of checked size.
Status start(PngReader& reader, ByteView bytes, const ImageSize& size, const ImageLimits& limits,
             Samples samples) {
  reader.rest = bytes;
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader.message, on_error, on_warning);
  if (reader.png != nullptr) reader.info = png_create_info_struct(reader.png);
  if (reader.info == nullptr) return Error{ErrorCode::internal, "libpng cannot be started", ""};
  if (!read_header(reader, limits, samples))
    return damaged_image("PNG", png_defect(bytes, reader.message));
  const uint64_t packed = reader.packed_row_bytes * static_cast<uint64_t>(size.height);
  if (packed / max_deflate_ratio > bytes.size()) return damaged_image("PNG", "it ends early");
  return Done{};
}

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
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer.message, on_error, on_warning);
  if (writer.png != nullptr) writer.info = png_create_info_struct(writer.png);
  if (writer.info == nullptr || !write_all(writer, notes, rows))
    return Error{ErrorCode::internal, "the image cannot be written as PNG: " + writer.message, ""};
  return std::move(writer.bytes);
}

}  // namespace

bool is_png(ByteView bytes) {
  return bytes.size() >= png_signature.size() &&
         std::equal(png_signature.begin(), png_signature.end(), bytes.begin());
}

Result<ImageSize> png_size(ByteView bytes, const ImageLimits& limits) {
  if (!is_png(bytes)) return damaged_image("PNG", signature_defect(bytes));
  if (bytes.size() < header_end) return damaged_image("PNG", "it ends early");
  if (std::memcmp(bytes.data() + 12, "IHDR", 4) != 0)
    return damaged_image("PNG", "it has no header");
  const int64_t width = big_endian(bytes.data() + 16);
  const int64_t height = big_endian(bytes.data() + 20);
  if (Status size = check_image_size(width, height, limits); !size) return size.error();
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

Result<Image8> decode_png(ByteView bytes, const ImageLimits& limits, int factor) {
  const bool by_rows =
      factor > 1 && bytes.size() > interlacing_at && bytes[interlacing_at] == PNG_INTERLACE_NONE;
  const auto size = png_size(bytes, by_rows ? streamed(limits) : limits);
  if (!size) return size.error();
  PngReader reader;
  if (Status s = start(reader, bytes, *size, limits, Samples::rgba); !s) return s.error();
  if (by_rows) {
    RowAverage average(size->width, size->height, factor);
    Bytes row(size_t{4} * static_cast<size_t>(size->width));
    if (!read_pixels(reader, row, size->height, average))
      return damaged_image("PNG", png_defect(bytes, reader.message));
    return average.take();
  }
  Image8 image(size->width, size->height, 4);
  std::vector<png_bytep> rows(static_cast<size_t>(size->height));
  for (int y = 0; y < image.height; ++y) rows[static_cast<size_t>(y)] = &image.at(0, y);
  if (!read_pixels(reader, rows.data()))
    return damaged_image("PNG", png_defect(bytes, reader.message));
  return averaged(std::move(image), factor);
}

Result<Image16> decode_png_values(ByteView bytes, const ImageLimits& limits) {
  const auto size = png_size(bytes, limits);
  if (!size) return size.error();
  PngReader reader;
  if (Status s = start(reader, bytes, *size, limits, Samples::values); !s) return s.error();
  if (png_get_channels(reader.png, reader.info) != 1)
    return Error{ErrorCode::bad_input, "holds colours where grey values or a palette are needed",
                 ""};
  const size_t bytes_each = png_get_bit_depth(reader.png, reader.info) == 16 ? 2 : 1;
  const auto width = static_cast<size_t>(size->width);
  const auto height = static_cast<size_t>(size->height);
  Bytes samples(width * height * bytes_each);
  std::vector<png_bytep> rows(height);
  for (size_t y = 0; y < height; ++y) rows[y] = &samples[y * width * bytes_each];
  if (!read_pixels(reader, rows.data()))
    return damaged_image("PNG", png_defect(bytes, reader.message));
  Image16 image(size->width, size->height, 1);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = bytes_each == 1
                          ? uint16_t{samples[i]}
                          : static_cast<uint16_t>(samples[2 * i] << 8U | samples[2 * i + 1]);
  return image;
}

int png_orientation(ByteView bytes) { return exif_orientation(chunk_of(bytes, "eXIf")); }

size_t png_frame_count(ByteView bytes) {
  const ByteView control = chunk_of(bytes, "acTL");
  return control.size() < 8 ? 1 : static_cast<size_t>(big_endian(control.data()));
}

bool is_nearly_png(ByteView bytes) {
  return bytes.size() >= png_signature.size() && equal_bytes(bytes) >= least_alike;
}

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
