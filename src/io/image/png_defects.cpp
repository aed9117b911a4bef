#include "io/image/png_defects.h"

#include <algorithm>
#include <vector>

namespace relievo {
namespace {

constexpr size_t least_alike = 5;
constexpr size_t first_line_end = 4;
constexpr size_t bit_depth_at = 24;
constexpr size_t color_type_at = 25;

/// The bit depths of a colour type; none where there is no such type.
std::vector<int> bit_depths(int color_type) {
  switch (color_type) {
    case 0:
      return {1, 2, 4, 8, 16};
    case 3:
      return {1, 2, 4, 8};
    case 2:
    case 4:
    case 6:
      return {8, 16};
    default:
      return {};
  }
}

size_t equal_bytes(ByteView bytes) {
  size_t count = 0;
  for (size_t i = 0; i < std::min(bytes.size(), png_signature.size()); ++i)
    count += bytes[i] == png_signature[i] ? 1 : 0;
  return count;
}

/// Whether the signature's line ends are all of one other kind, as a transfer as text leaves them.
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
  const std::vector<int> depths = bit_depths(color_type);
  if (depths.empty()) return "there is no colour type " + std::to_string(color_type);
  if (std::find(depths.begin(), depths.end(), depth) == depths.end())
    return "colour type " + std::to_string(color_type) + " has no bit depth of " +
           std::to_string(depth);
  return "its header (IHDR) holds values that do not exist";
}

/// Chunks as people call them.
std::string chunk_in_words(const std::string& name) {
  if (name == "IHDR") return "header (IHDR)";
  if (name == "IDAT") return "pixels (IDAT)";
  if (name == "PLTE") return "palette (PLTE)";
  return name + " chunk";
}

}  // namespace

bool is_nearly_png(ByteView bytes) {
  return bytes.size() >= png_signature.size() && equal_bytes(bytes) >= least_alike;
}

std::string signature_defect(ByteView bytes) {
  if (has_other_line_ends(bytes))
    return "the line ends in its signature were changed, as by a transfer as text";
  if (!is_nearly_png(bytes)) return "it does not begin with the PNG signature";
  size_t at = 0;
  while (at < png_signature.size() && bytes[at] == png_signature[at]) ++at;
  return "byte " + std::to_string(at + 1) + " of its signature is wrong";
}

std::string png_defect(ByteView bytes, const std::string& message) {
  if (message == "Invalid IHDR data") return header_defect(bytes);
  if (message == "IEND: out of place") return "it has no pixels (IDAT)";
  const size_t colon = message.find(": CRC error");
  if (colon != std::string::npos)
    return "the checksum of its " + chunk_in_words(message.substr(0, colon)) + " is wrong";
  return message;
}

}  // namespace relievo
