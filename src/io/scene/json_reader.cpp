#include "io/scene/json_reader.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace relievo {
namespace {

using Json = nlohmann::json;

std::string line_and_column(std::string_view text, size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const size_t last_break = before.rfind('\n');
  const size_t column =
      last_break == std::string_view::npos ? before.size() + 1 : before.size() - last_break;
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Returns the reason in a message of the parser, which follows its prefix and position.
std::string reason(const std::string& message) {
  const size_t colon = message.find(": ");
  return colon == std::string::npos ? message : message.substr(colon + 2);
}

/// Receives the parser's events and builds the value. Every event returns whether parsing goes on.
class Builder {
 public:
  Builder(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}

  bool null() { return add(nullptr) != nullptr; }
  bool boolean(bool value) { return add(value) != nullptr; }
  bool number_integer(Json::number_integer_t value) { return add(value) != nullptr; }
  bool number_unsigned(Json::number_unsigned_t value) { return add(value) != nullptr; }
  bool number_float(Json::number_float_t value, const std::string&) {
    return add(value) != nullptr;
  }
  bool string(std::string& value) { return add(std::move(value)) != nullptr; }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(size_t) { return open(Json::object()); }
  bool start_array(size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    Frame& frame = open_.back();
    frame.key = std::move(name);
    if (!frame.container->contains(frame.key)) return true;
    error_ = Error{ErrorCode::bad_input, "the key is given twice; remove one of them", path()};
    return false;
  }

  bool parse_error(size_t offset, const std::string&, const Json::exception& exception) {
    error_ = Error{ErrorCode::bad_input, "malformed JSON: " + reason(exception.what()),
                   line_and_column(text_, offset)};
    return false;
  }

  const std::optional<Error>& error() const { return error_; }
  Json take() { return std::move(root_); }

 private:
  struct Frame {
    Json* container;
    std::string key;  ///< of the member being read, in an object
  };

  std::string path() const {
    std::string path;
    for (const Frame& frame : open_) {
      if (frame.container->is_array())
        path += "[" + std::to_string(frame.container->size() - 1) + "]";
      else
        path += (path.empty() ? "" : ".") + frame.key;
    }
    return path;
  }

  Json* add(Json value) {
    if (++values_ > limits_.max_values) {
      error_ = Error{ErrorCode::limit,
                     "holds more than " + std::to_string(limits_.max_values) + " values", ""};
      return nullptr;
    }
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Frame& frame = open_.back();
    if (frame.container->is_object()) return &((*frame.container)[frame.key] = std::move(value));
    frame.container->push_back(std::move(value));
    return &frame.container->back();
  }

  bool open(Json container) {
    if (open_.size() >= limits_.max_depth) {
      error_ = Error{ErrorCode::limit,
                     "is nested deeper than " + std::to_string(limits_.max_depth) + " levels", ""};
      return false;
    }
    Json* added = add(std::move(container));
    if (added == nullptr) return false;
    open_.push_back({added, {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const JsonLimits& limits_;
  Json root_;
  std::vector<Frame> open_;
  size_t values_ = 0;
  std::optional<Error> error_;
};

/// The item of a list of the scene that a value belongs to.
Culprit culprit_of(const JsonPath& path) {
  if (path.parent == nullptr) return {};
  const JsonPath& list = *path.parent;
  const bool is_item = path.key.empty() && list.parent != nullptr && list.parent->parent == nullptr;
  if (!is_item) return culprit_of(list);
  const auto begin = std::begin(culprit_list_names);
  const auto name = std::find(begin, std::end(culprit_list_names), list.key);
  if (name == std::end(culprit_list_names)) return {};
  return {static_cast<CulpritList>(name - begin), path.index};
}

}  // namespace

Result<nlohmann::json> parse_json(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.max_bytes)
    return Error{ErrorCode::limit,
                 "is larger than " + std::to_string(limits.max_bytes >> 20U) + " MB", ""};
  // The parser takes a zero byte for the end of the text and would not look beyond it.
  if (const size_t zero = text.find('\0'); zero != std::string_view::npos)
    return Error{ErrorCode::bad_input, "malformed JSON: a zero byte", line_and_column(text, zero)};
  Builder builder(text, limits);
  const bool complete = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  if (builder.error()) return *builder.error();
  if (!complete) return Error{ErrorCode::internal, "the JSON reader stopped without a reason", ""};
  return builder.take();
}

std::string to_string(const JsonPath& path) {
  if (path.parent == nullptr) return "";
  const std::string before = to_string(*path.parent);
  if (path.key.empty()) return before + "[" + std::to_string(path.index) + "]";
  return before + (before.empty() ? "" : ".") + std::string(path.key);
}

void JsonReader::fail(const JsonPath& path, std::string message, ErrorCode code) {
  fail({code, std::move(message), to_string(path), culprit_of(path)});
}

void JsonReader::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

bool JsonReader::keys(const Json& json, const JsonPath& path,
                      std::initializer_list<const char*> required,
                      std::initializer_list<const char*> optional) {
  if (!json.is_object()) {
    fail(path, "must be an object { ... }");
    return false;
  }
  for (const char* key : required)
    if (!json.contains(key)) fail(path.member(key), "is missing");
  for (const auto& item : json.items()) {
    const auto is = [&](const char* key) { return item.key() == key; };
    if (!std::any_of(required.begin(), required.end(), is) &&
        !std::any_of(optional.begin(), optional.end(), is))
      fail(path.member(item.key().empty() ? "\"\"" : item.key()),
           "is not a known key; remove it or correct its name");
  }
  return !error_;
}

bool JsonReader::is_list(const Json& json, const JsonPath& path, const char* what) {
  if (!json.is_array()) fail(path, std::string("must be a list of ") + what);
  return json.is_array();
}

bool JsonReader::is_file(const Json& json, const std::string& kind, int newest) {
  const JsonPath root;
  if (!json.is_object()) {
    fail(root, "is not a " + kind + " file, which holds one JSON object { ... }");
    return false;
  }
  const std::string format = "relievo-" + kind;
  const auto found = json.find("format");
  if (found == json.end() || *found != format)
    fail(root.member("format"), "is not a " + kind + " file: the key must say \"" + format + "\"");
  const auto version = json.find("version");
  if (version == json.end() || !version->is_number_integer() || *version < 1 || *version > newest)
    fail(root.member("version"), "this program reads version " + std::to_string(newest) +
                                     " only; a newer file needs a newer program");
  return !error_;
}

double JsonReader::number(const Json& json, const JsonPath& path) {
  if (!json.is_number()) {
    fail(path, "must be a number");
    return 0;
  }
  return json.get<double>();
}

int JsonReader::whole_number(const Json& json, const JsonPath& path, int most) {
  const bool sound = json.is_number_integer() && json >= 1 && json <= most;
  if (!sound) fail(path, "must be a whole number from 1 to " + std::to_string(most));
  return sound ? json.get<int>() : 1;
}

bool JsonReader::flag(const Json& json, const JsonPath& path) {
  if (!json.is_boolean()) fail(path, "must be true or false");
  return json == true;
}

std::string JsonReader::text(const Json& json, const JsonPath& path) {
  if (json.is_string()) return json.get<std::string>();
  fail(path, "must be a text in quotes");
  return "";
}

size_t JsonReader::choice(const Json& json, const JsonPath& path,
                          const std::vector<const char*>& names) {
  std::string known;
  for (size_t k = 0; k < names.size(); ++k) {
    if (json == names[k]) return k;
    known += (k == 0                 ? "\""
              : k + 1 < names.size() ? ", \""
                                     : " or \"") +
             std::string(names[k]) + "\"";
  }
  fail(path, "must be " + known);
  return 0;
}

Point2 JsonReader::point(const Json& json, const JsonPath& path) {
  if (!json.is_array() || json.size() != 2) {
    fail(path, "must be a point [x, y]");
    return {};
  }
  return {number(json[0], path.element(0)), number(json[1], path.element(1))};
}

std::vector<Point2> JsonReader::points(const Json& json, const JsonPath& path) {
  std::vector<Point2> list;
  if (!is_list(json, path, "points [[x, y], ...]")) return list;
  point_count_ += json.size();
  if (point_count_ > max_points_) {
    fail(path, "there are more than " + std::to_string(max_points_) + " points", ErrorCode::limit);
    return list;
  }
  list.reserve(json.size());
  for (size_t i = 0; i < json.size() && !error_; ++i)
    list.push_back(point(json[i], path.element(i)));
  return list;
}

Outline JsonReader::outline(const Json& json, const JsonPath& path) {
  Outline outline;
  if (!is_list(json, path, "rings [[[x, y], ...], ...]")) return outline;
  for (size_t r = 0; r < json.size() && !error_; ++r)
    outline.push_back(points(json[r], path.element(r)));
  return outline;
}

Join JsonReader::join(const Json& json, const JsonPath& path) {
  Join join;
  if (!keys(json, path, {"upper", "lower", "line"}, {})) return join;
  pair(json, path, join);
  join.line = points(json["line"], path.member("line"));
  return join;
}

Relation JsonReader::relation(const Json& json, const JsonPath& path) {
  Relation relation;
  if (!keys(json, path, {"upper", "lower", "relation"}, {"range"})) return relation;
  pair(json, path, relation);
  relation.kind = kind(json["relation"], path.member("relation"),
                       {RelationKind::equal, RelationKind::above, RelationKind::free,
                        RelationKind::below, RelationKind::joined});
  if (!json.contains("range")) {
    if (relation.kind == RelationKind::below)
      fail(path.member("range"),
           "\"below\" needs a range; where it holds everywhere, swap the parts");
    return relation;
  }
  const std::vector<Point2> ends = points(json["range"], path.member("range"));
  if (ends.size() == 2)
    relation.range = {ends[0], ends[1]};
  else
    fail(path.member("range"), "must be two points [[x, y], [x, y]]");
  return relation;
}

RobinRange JsonReader::robin(const Json& json, const JsonPath& path) {
  RobinRange range;
  if (!keys(json, path, {"upper", "lower", "from", "to"}, {"alpha0", "rho"})) return range;
  pair(json, path, range);
  set(json, path, "from", range.from, &JsonReader::point);
  set(json, path, "to", range.to, &JsonReader::point);
  set(json, path, "alpha0", range.alpha0, &JsonReader::number);
  set(json, path, "rho", range.rho, &JsonReader::number);
  return range;
}

Cue JsonReader::cue(const Json& json, const JsonPath& path) {
  Cue cue;
  if (!keys(json, path, {"part", "kind", "line", "value"}, {})) return cue;
  cue.part = part_reference(json["part"], path.member("part"));
  cue.kind =
      kind(json["kind"], path.member("kind"), {CueKind::bulge, CueKind::slope, CueKind::crease});
  set(json, path, "line", cue.line, &JsonReader::points);
  set(json, path, "value", cue.value, &JsonReader::number);
  return cue;
}

}  // namespace relievo
