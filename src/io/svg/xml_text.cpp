#include "io/svg/xml_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

using std::string_view_literals::operator""sv;

void append_utf8(uint32_t code, std::string& text) {
  const auto put = [&](uint32_t byte) { text.push_back(static_cast<char>(byte)); };
  const auto more = [&](int shift) { put(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xc0 | code >> 6);
  } else {
    if (code < 0x10000) {
      put(0xe0 | code >> 12);
    } else {
      put(0xf0 | code >> 18);
      more(12);
    }
    more(6);
  }
  more(0);
}

constexpr uint32_t replacement = 0xfffd;  ///< stands for what is no character

std::string text_of_utf16(std::string_view bytes, bool little_endian) {
  std::string text;
  text.reserve(bytes.size());
  const auto unit = [&](size_t i) -> uint32_t {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return little_endian ? first | second << 8 : first << 8 | second;
  };
  for (size_t i = 0; i + 1 < bytes.size(); i += 2) {
    uint32_t code = unit(i);
    if (code >= 0xd800 && code < 0xe000) {
      const bool paired = code < 0xdc00 && i + 3 < bytes.size() && unit(i + 2) >> 10 == 0x37;
      if (paired) i += 2;
      code = paired ? 0x10000 + ((code & 0x3ff) << 10 | (unit(i) & 0x3ff)) : replacement;
    }
    append_utf8(code, text);
  }
  return text;
}

std::string text_of_latin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (const char c : bytes) append_utf8(static_cast<unsigned char>(c), text);
  return text;
}

/// Returns the encoding that the XML declaration states, in lower case; may be empty.
std::string declared_encoding(std::string_view bytes) {
  if (!bytes.starts_with("<?xml")) return "";
  const std::string_view declaration = bytes.substr(0, bytes.find("?>"));
  const size_t name = declaration.find("encoding");
  const size_t open = declaration.find_first_of("\"'", std::min(name, declaration.size()));
  if (open == std::string_view::npos) return "";
  const std::string_view value = declaration.substr(open + 1);
  return lower_case(value.substr(0, value.find(declaration[open])));
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

constexpr std::string_view white = " \t\r\n";

/// Returns the position of the first of `ends` outside quotes; the size where there is none.
size_t find_unquoted(std::string_view text, std::string_view ends) {
  char quote = '\0';
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote == '\0' && ends.find(c) != std::string_view::npos) return i;
    if (quote == '\0' && (c == '"' || c == '\''))
      quote = c;
    else if (c == quote)
      quote = '\0';
  }
  return text.size();
}

std::string_view take_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(white), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(white));
  text.remove_prefix(word.size());
  text.remove_prefix(std::min(text.find_first_not_of(white), text.size()));
  return word;
}

/// Returns the character of "#233" or "#xe9"; nothing for any other text.
std::optional<uint32_t> numbered_character(std::string_view name) {
  if (!name.starts_with("#")) return std::nullopt;
  const bool hex = name.size() > 1 && name[1] == 'x';
  const std::string_view digits = name.substr(hex ? 2 : 1);
  uint32_t code = 0;
  const auto [end, fault] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, hex ? 16 : 10);
  if (fault != std::errc() || end != digits.data() + digits.size() || code > 0x10ffff)
    return std::nullopt;
  return code;
}

/// Returns the name in "&name;" at the front of `text`; empty where there is none.
std::string_view reference_at(std::string_view text) {
  constexpr size_t longest = 200;
  const size_t end = text.substr(0, longest).find_first_of(";<>&\"' \t\r\n", 1);
  if (end == std::string_view::npos || text[end] != ';') return {};
  return text.substr(1, end - 1);
}

/// Replaces the numbered characters in the literal value of an entity, as its declaration demands.
std::string value_of_literal(std::string_view literal) {
  std::string value;
  for (size_t i = 0; i < literal.size(); ++i) {
    const std::string_view name = literal[i] == '&' ? reference_at(literal.substr(i)) : ""sv;
    const auto code = numbered_character(name);
    if (!code) {
      value.push_back(literal[i]);
      continue;
    }
    append_utf8(*code, value);
    i += name.size() + 1;
  }
  return value;
}

using Entities = std::map<std::string, std::string, std::less<>>;

/// Takes `ENTITY name "value"`; parameter entities and external ones are left out.
void add_entity(std::string_view declaration, Entities& entities) {
  take_word(declaration);
  const std::string_view name = take_word(declaration);
  if (declaration.empty() || (declaration[0] != '"' && declaration[0] != '\'')) return;
  const std::string_view literal = declaration.substr(1, declaration.find(declaration[0], 1) - 1);
  entities.emplace(name, value_of_literal(literal));
}

/// The document type of a file.
struct DocumentType {
  size_t begin = 0;  ///< in the text
  size_t end = 0;
  Entities entities;
};

DocumentType document_type(std::string_view text) {
  std::string_view rest = after_prolog(text);
  DocumentType type;
  type.begin = type.end = text.size() - rest.size();
  if (!rest.starts_with("<!DOCTYPE")) return type;
  rest.remove_prefix(find_unquoted(rest, "[>"));
  if (rest.starts_with("[")) {
    rest.remove_prefix(1);
    for (rest = after_prolog(rest); !rest.empty() && rest[0] != ']'; rest = after_prolog(rest)) {
      const size_t end = find_unquoted(rest, rest[0] == '%' ? ";" : ">");
      const std::string_view declaration = rest.substr(0, end);
      if (declaration.starts_with("<!ENTITY")) add_entity(declaration, type.entities);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    rest.remove_prefix(find_unquoted(rest, ">"));
  }
  rest.remove_prefix(std::min<size_t>(1, rest.size()));
  type.end = text.size() - rest.size();
  return type;
}

constexpr std::array<std::string_view, 5> predefined = {"lt", "gt", "amp", "quot", "apos"};
constexpr size_t max_references = 1'000'000;
constexpr int max_nesting = 40;

/// Copies a text and replaces its references.
struct Replacer {
  const Entities& entities;
  size_t max_bytes;
  std::string result = {};
  std::string unknown = {};  ///< name of an entity that has no value
  size_t references = 0;
  std::optional<Error> error = {};

  void fail(ErrorCode code, const std::string& message) {
    if (!error) error = Error{code, message, "svg"};
  }

  /// Appends the value of a reference; `quoted` in an attribute, where no quote ends the value.
  void append_value(std::string_view value, bool quoted, int depth) {
    if (depth > max_nesting) return fail(ErrorCode::bad_input, "has an entity that names itself");
    if (++references > max_references || result.size() + value.size() > max_bytes)
      return fail(ErrorCode::limit, "has entities that grow too large (limit " +
                                        std::to_string(max_bytes) + " bytes)");
    for (size_t i = 0; i < value.size() && !error; ++i) {
      const char c = value[i];
      if (c == '&') {
        i += append_reference(value.substr(i), quoted, depth);
      } else if (quoted && (c == '"' || c == '\'' || c == '<')) {
        result.append(c == '<' ? "&lt;" : c == '"' ? "&quot;" : "&apos;");
      } else {
        result.push_back(c);
      }
    }
  }

  /// Appends what the reference at the front of `text` stands for, and returns how many more
  /// characters than one it takes.
  size_t append_reference(std::string_view text, bool quoted, int depth) {
    const std::string_view name = reference_at(text);
    const auto found = entities.find(name);
    const bool is_predefined =
        std::find(predefined.begin(), predefined.end(), name) != predefined.end();
    if (found != entities.end() && !is_predefined) {
      append_value(found->second, quoted, depth + 1);
    } else {
      result.append(text.substr(0, name.empty() ? 1 : name.size() + 2));
      if (!name.empty() && name[0] != '#' && !is_predefined && unknown.empty()) unknown = name;
    }
    return name.empty() ? 0 : name.size() + 1;
  }

  void append_document(std::string_view text) {
    char quote = '\0';
    bool in_tag = false;
    for (size_t i = 0; i < text.size() && !error; ++i) {
      const std::string_view here = text.substr(i);
      const char c = here[0];
      const std::string_view end = in_tag                          ? ""sv
                                   : here.starts_with("<![CDATA[") ? "]]>"sv
                                   : here.starts_with("<!--")      ? "-->"sv
                                                                   : ""sv;
      if (!end.empty()) {
        const size_t length = std::min(here.find(end), here.size());
        result.append(here.substr(0, length));
        i += length - 1;
        continue;
      }
      if (c == '&') {
        i += append_reference(here, in_tag, 0);
        continue;
      }
      if (in_tag && quote == '\0' && (c == '"' || c == '\''))
        quote = c;
      else if (c == quote)
        quote = '\0';
      else if (quote == '\0' && (c == '<' || c == '>'))
        in_tag = c == '<';
      result.push_back(c);
    }
  }
};

}  // namespace

std::string utf8_text(std::string_view bytes, std::vector<std::string>& warnings) {
  if (bytes.starts_with("\xff\xfe"sv)) return text_of_utf16(bytes.substr(2), true);
  if (bytes.starts_with("\xfe\xff"sv)) return text_of_utf16(bytes.substr(2), false);
  if (bytes.starts_with("<\0"sv)) return text_of_utf16(bytes, true);
  if (bytes.starts_with("\0<"sv)) return text_of_utf16(bytes, false);
  if (bytes.starts_with("\xef\xbb\xbf")) return std::string(bytes.substr(3));
  const std::string encoding = declared_encoding(bytes);
  const bool one_byte =
      !encoding.empty() && !encoding.starts_with("utf") && !encoding.starts_with("ucs");
  if (!one_byte || is_ascii(bytes)) return std::string(bytes);
  if (encoding != "iso-8859-1" && encoding != "latin1" && encoding != "windows-1252" &&
      encoding != "us-ascii")
    warnings.push_back("the encoding " + encoding +
                       " is read as Latin-1, so names may look wrong; save the drawing as UTF-8");
  return text_of_latin1(bytes);
}

Result<std::string> without_entities(std::string text, size_t max_bytes,
                                     std::vector<std::string>& warnings) {
  const DocumentType type = document_type(text);
  if (type.end == type.begin) return text;
  Replacer replacer{type.entities, max_bytes};
  replacer.result = text.substr(0, type.begin);
  const auto type_end = text.begin() + static_cast<std::ptrdiff_t>(type.end);
  replacer.result.append(
      static_cast<size_t>(
          std::count(text.begin() + static_cast<std::ptrdiff_t>(type.begin), type_end, '\n')),
      '\n');
  replacer.append_document(std::string_view(text).substr(type.end));
  if (replacer.error) return *replacer.error;
  if (!replacer.unknown.empty())
    warnings.push_back("the entity &" + replacer.unknown +
                       "; has no value in the file and is left as it is");
  return std::move(replacer.result);
}

}  // namespace relievo
