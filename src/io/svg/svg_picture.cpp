#include "io/svg/svg_picture.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "io/image/jpeg_header.h"
#include "io/image/png.h"
#include "io/layered/raster_layer.h"
#include "io/svg/svg_values.h"
#include "kernel/image/compose.h"

namespace relievo {
namespace {

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

Bytes decoded_base64(std::string_view text) {
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3);
  uint32_t bits = 0;
  int filled = 0;
  for (const char c : text) {
    if (c == '=') break;
    const int value = base64_value(c);
    if (value < 0) continue;
    bits = bits << 6 | static_cast<uint32_t>(value);
    filled += 6;
    if (filled < 8) continue;
    filled -= 8;
    bytes.push_back(static_cast<uint8_t>(bits >> filled & 255));
  }
  return bytes;
}

pugi::xml_attribute href_of(const pugi::xml_node& image) {
  for (const pugi::xml_attribute& attribute : image.attributes())
    if (local_name(attribute.name()) == "href") return attribute;
  return {};
}

/// Returns the base64 text of a data: reference; empty where it is none.
std::string_view embedded_text(const pugi::xml_node& image) {
  const std::string_view href = trimmed_svg(href_of(image).value());
  const size_t comma = href.find(',');
  if (!href.starts_with("data:") || comma == std::string_view::npos) return {};
  if (!href.substr(0, comma).ends_with(";base64")) return {};
  return href.substr(comma + 1);
}

/// Returns the first bytes of the embedded file, which hold its size: the header of a JPEG file may
/// follow a thumbnail, that of a PNG file is at its front.
Bytes front_of(const pugi::xml_node& image) {
  constexpr size_t front = size_t{1} << 18;
  return decoded_base64(embedded_text(image).substr(0, front));
}

Result<ImageSize> size_of(ByteView bytes) {
  if (is_png(bytes)) return png_size(bytes, embedded_limits);
  if (is_jpeg(bytes)) return jpeg_size(bytes, embedded_limits);
  return Error{ErrorCode::bad_input, "embeds neither a PNG nor a JPEG picture", ""};
}

SvgPicture rectangle(ImageSize size) {
  const double width = size.width;
  const double height = size.height;
  return {size, {{{0, 0}, {width, 0}, {width, height}, {0, height}}}, {0.5, 0.5, 0.5, 1}};
}

}  // namespace

Result<ImageSize> embedded_size(const pugi::xml_node& image) { return size_of(front_of(image)); }

void state_media_type(pugi::xml_node image) {
  const std::string stated =
      is_png(front_of(image)) ? "data:image/png;base64," : "data:image/jpeg;base64,";
  pugi::xml_attribute href = href_of(image);
  if (trimmed_svg(href.value()).starts_with(stated)) return;
  href.set_value((stated + std::string(embedded_text(image))).c_str());
}

Result<SvgPicture> embedded_picture(const pugi::xml_node& image) {
  const Bytes bytes = decoded_base64(embedded_text(image));
  const auto size = size_of(bytes);
  if (!size) return size.error();
  if (!is_png(bytes)) return rectangle(*size);
  RasterLayer layer;
  auto pixels = decode_png(bytes, embedded_limits);
  if (!pixels) return pixels.error();
  layer.rgba = std::move(*pixels);
  SvgPicture picture = rectangle(*size);
  const auto mark = opaque_mark(layer);
  picture.has_holes = least_alpha(layer.rgba) < 128;
  if (picture.has_holes) picture.opaque = mark ? mark->region : Region();
  if (mark) {
    picture.color = mark->color;
    picture.outlined = mark->outlined && picture.has_holes;
  }
  return picture;
}

}  // namespace relievo
