#include "io/svg/embedded_image.h"

#include <string>
#include <string_view>

#include "io/svg/scanner.h"
#include "io/svg/stylesheet.h"

namespace relievo {
namespace {

constexpr size_t header_size = 24;

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

/// The first bytes that the base64 text stands for.
std::string decoded_front(std::string_view text, size_t count) {
  std::string bytes;
  uint32_t bits = 0;
  int filled = 0;
  for (const char c : text) {
    const int value = base64_value(c);
    if (value < 0 && (c == '=' || bytes.size() == count)) break;
    if (value < 0) continue;
    bits = bits << 6 | static_cast<uint32_t>(value);
    filled += 6;
    if (filled < 8) continue;
    filled -= 8;
    bytes.push_back(static_cast<char>(bits >> filled & 255));
    if (bytes.size() == count) break;
  }
  return bytes;
}

uint32_t big_endian(std::string_view bytes) {
  uint32_t value = 0;
  for (const char c : bytes) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

}  // namespace

std::optional<EmbeddedSize> embedded_png_size(const pugi::xml_node& image) {
  for (const pugi::xml_attribute& attribute : image.attributes()) {
    if (local_name(attribute.name()) != "href") continue;
    const std::string_view href = trimmed_svg(attribute.value());
    constexpr std::string_view prefix = "data:image/png;base64,";
    if (href.substr(0, prefix.size()) != prefix) return std::nullopt;
    const std::string header = decoded_front(href.substr(prefix.size()), header_size);
    const std::string_view view = header;
    if (view.size() < header_size || view.substr(1, 3) != "PNG" || view.substr(12, 4) != "IHDR") {
      return std::nullopt;
    }
    return EmbeddedSize{big_endian(view.substr(16, 4)), big_endian(view.substr(20, 4))};
  }
  return std::nullopt;
}

}  // namespace relievo
