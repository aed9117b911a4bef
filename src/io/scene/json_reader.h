#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// Where a value is, as a list towards the root; written out only for an error.
struct JsonPath {
  const JsonPath* parent = nullptr;
  std::string_view key;  ///< empty: an element
  size_t index = 0;

  JsonPath member(std::string_view name) const { return {this, name, 0}; }
  JsonPath element(size_t i) const { return {this, {}, i}; }
};

/// The path as "parts[2].outline[0]".
std::string to_string(const JsonPath& path);

/// Turns JSON values into ours and keeps the first failure, with the path of the key. After one,
/// whatever is returned is of no use and is thrown away by the caller.
class JsonReader {
 public:
  /// `max_points`: of all lists of points together.
  explicit JsonReader(size_t max_points) : max_points_(max_points) {}

  const std::optional<Error>& error() const { return error_; }

 protected:
  using Json = nlohmann::json;

  void fail(const JsonPath& path, std::string message, ErrorCode code = ErrorCode::bad_input);
  void fail(Error error);

  /// The keys of an object: all of `required`, any of `optional`, nothing else.
  bool keys(const Json& json, const JsonPath& path, std::initializer_list<const char*> required,
            std::initializer_list<const char*> optional);

  bool is_list(const Json& json, const JsonPath& path, const char* what);
  double number(const Json& json, const JsonPath& path);
  std::string text(const Json& json, const JsonPath& path);
  Point2 point(const Json& json, const JsonPath& path);
  std::vector<Point2> points(const Json& json, const JsonPath& path);
  Outline outline(const Json& json, const JsonPath& path);
  RelationKind relation_kind(const Json& json, const JsonPath& path);
  CueKind cue_kind(const Json& json, const JsonPath& path);

 private:
  std::optional<Error> error_;
  size_t max_points_;
  size_t point_count_ = 0;
};

}  // namespace relievo
