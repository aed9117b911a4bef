#include "kernel/base/text_rules.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace relievo {
namespace {

/// Returns the length of the UTF-8 sequence that begins with byte `lead`, or 0 where none does.
size_t sequence_length(uint8_t lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return 2;
  if (lead >= 0xe0 && lead < 0xf0) return 3;
  if (lead >= 0xf0 && lead < 0xf5) return 4;
  return 0;
}

/// Decodes one sequence of known length. Returns false where a continuation byte is invalid.
bool decode(std::string_view sequence, uint32_t& code) {
  const auto lead = static_cast<uint8_t>(sequence[0]);
  code = sequence.size() == 1 ? lead : lead & (0x7fU >> sequence.size());
  for (const char c : sequence.substr(1)) {
    const auto byte = static_cast<uint8_t>(c);
    if ((byte & 0xc0U) != 0x80U) return false;
    code = (code << 6U) | (byte & 0x3fU);
  }
  return true;
}

/// Returns whether `code`, encoded in `length` bytes, is neither a control character nor overlong,
/// a surrogate or out of range.
bool is_allowed(uint32_t code, size_t length) {
  if (code < 0x20 || (code >= 0x7f && code < 0xa0)) return false;
  if (length == 3 && (code < 0x800 || (code >= 0xd800 && code < 0xe000))) return false;
  return length != 4 || (code >= 0x10000 && code <= 0x10ffff);
}

}  // namespace

bool is_plain_utf8(std::string_view text) {
  while (!text.empty()) {
    const size_t length = sequence_length(static_cast<uint8_t>(text[0]));
    uint32_t code = 0;
    if (length == 0 || length > text.size()) return false;
    if (!decode(text.substr(0, length), code) || !is_allowed(code, length)) return false;
    text.remove_prefix(length);
  }
  return true;
}

bool is_sound_id(std::string_view id) {
  return !id.empty() && id.size() <= 200 && is_plain_utf8(id);
}

bool is_path_inside(std::string_view path) {
  if (path.size() > 1000 || !is_plain_utf8(path)) return false;
  if (path.find_first_of("\\:") != std::string_view::npos) return false;
  for (bool more = true; more;) {
    const size_t slash = path.find('/');
    const std::string_view segment = path.substr(0, slash);
    if (segment.empty() || segment == "." || segment == "..") return false;
    more = slash != std::string_view::npos;
    if (more) path.remove_prefix(slash + 1);
  }
  return true;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string_view after_prolog(std::string_view xml) {
  const auto skip = [&](std::string_view start, std::string_view end) {
    if (!xml.starts_with(start)) return false;
    const size_t found = xml.find(end, start.size());
    xml.remove_prefix(found == std::string_view::npos ? xml.size() : found + end.size());
    return true;
  };
  do {
    xml.remove_prefix(std::min(xml.find_first_not_of(" \t\r\n"), xml.size()));
  } while (skip("<!--", "-->") || skip("<?", "?>"));
  return xml;
}

}  // namespace relievo
