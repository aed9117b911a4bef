#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/scene/json_limits.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// Parses strict JSON (RFC 8259; a byte order mark is skipped). Beyond the grammar, it refuses a
/// key that its object already has, and numbers that overflow a double. It does not recurse.
/// Errors: `bad_input` ("malformed JSON ...", with line and column in `where`), `limit`.
Result<nlohmann::json> parse_json(std::string_view text, const JsonLimits& limits = {});

/// The path of a value, as a list towards the root; it becomes text only for an error.
struct JsonPath {
  const JsonPath* parent = nullptr;
  std::string_view key;  ///< empty: an element
  size_t index = 0;

  JsonPath member(std::string_view name) const { return {this, name, 0}; }
  JsonPath element(size_t i) const { return {this, {}, i}; }
};

/// Returns the path as "parts[2].outline[0]".
std::string to_string(const JsonPath& path);

/// Turns JSON values into ours and keeps the first error, with the path of its key. After an error
/// all further results are meaningless, and the caller drops them. Readers of files derive from it.
class JsonReader {
 public:
  /// `max_points`: of all lists of points together.
  explicit JsonReader(size_t max_points) : max_points_(max_points) {}

  const std::optional<Error>& error() const { return error_; }

 protected:
  using Json = nlohmann::json;

  ~JsonReader() = default;

  /// Returns the part that a value names, by the names that the file uses: ids or labels.
  virtual int part_reference(const Json& json, const JsonPath& path) = 0;

  void fail(const JsonPath& path, std::string message, ErrorCode code = ErrorCode::bad_input);
  void fail(Error error);

  /// Checks that a file is an object whose key "format" is "relievo-<kind>" and whose key "version"
  /// is at most `newest`.
  bool is_file(const Json& json, const std::string& kind, int newest);

  /// Checks the keys of an object: all of `required`, any of `optional`, no others.
  bool keys(const Json& json, const JsonPath& path, std::initializer_list<const char*> required,
            std::initializer_list<const char*> optional);

  bool is_list(const Json& json, const JsonPath& path, const char* what);
  double number(const Json& json, const JsonPath& path);
  int whole_number(const Json& json, const JsonPath& path, int most);  ///< from 1
  bool flag(const Json& json, const JsonPath& path);
  std::string text(const Json& json, const JsonPath& path);
  /// Reads a text that is one of `names`; returns its index.
  size_t choice(const Json& json, const JsonPath& path, const std::vector<const char*>& names);
  Point2 point(const Json& json, const JsonPath& path);
  std::vector<Point2> points(const Json& json, const JsonPath& path);
  Outline outline(const Json& json, const JsonPath& path);

  Join join(const Json& json, const JsonPath& path);
  Relation relation(const Json& json, const JsonPath& path);
  RobinRange robin(const Json& json, const JsonPath& path);
  Cue cue(const Json& json, const JsonPath& path);

  /// Reads the name of one of the kinds.
  template <class Kind>
  Kind kind(const Json& json, const JsonPath& path, std::initializer_list<Kind> kinds) {
    std::vector<const char*> names;
    for (const Kind one : kinds) names.push_back(name(one));
    return kinds.begin()[choice(json, path, names)];
  }

  /// Reads the values that scenes and corrections have of a part, where there are any: id, outline,
  /// c, d, flat, lean.
  template <class Item>
  void part_values(const Json& json, const JsonPath& path, Item& item) {
    set(json, path, "id", item.id, &JsonReader::text);
    set(json, path, "c", item.c, &JsonReader::number);
    set(json, path, "d", item.d, &JsonReader::number);
    set(json, path, "flat", item.flat, &JsonReader::number);
    set(json, path, "lean", item.lean, &JsonReader::point);
    set(json, path, "outline", item.outline, &JsonReader::outline);
  }

  /// Reads the member `key` into `value`, where there is one.
  template <class Value, class Read>
  void set(const Json& json, const JsonPath& path, const char* key, Value& value,
           Read (JsonReader::*read)(const Json&, const JsonPath&)) {
    if (json.contains(key)) value = (this->*read)(json[key], path.member(key));
  }

  /// Appends every element of the list under `key`, where there is one.
  template <class Reader, class Item>
  void list(const Json& json, const JsonPath& parent, const char* key, std::vector<Item>& items,
            Item (Reader::*read)(const Json&, const JsonPath&)) {
    if (error_ || !json.contains(key)) return;
    const JsonPath path = parent.member(key);
    if (!is_list(json[key], path, "objects")) return;
    for (size_t i = 0; i < json[key].size() && !error_; ++i)
      items.push_back((static_cast<Reader*>(this)->*read)(json[key][i], path.element(i)));
  }

  /// Reads the two parts of an annotation, which differ.
  template <class Item>
  void pair(const Json& json, const JsonPath& path, Item& item) {
    using Index = decltype(item.upper);
    item.upper = static_cast<Index>(part_reference(json["upper"], path.member("upper")));
    item.lower = static_cast<Index>(part_reference(json["lower"], path.member("lower")));
    if (!error_ && item.upper == item.lower) fail(path, "upper and lower are the same part");
  }

 private:
  std::optional<Error> error_;
  size_t max_points_;
  size_t point_count_ = 0;
};

}  // namespace relievo
