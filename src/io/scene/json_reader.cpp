#include "io/scene/json_reader.h"

#include <algorithm>
#include <iterator>

namespace relievo {

std::string to_string(const JsonPath& path) {
  if (path.parent == nullptr) return "";
  const std::string before = to_string(*path.parent);
  if (path.key.empty()) return before + "[" + std::to_string(path.index) + "]";
  return before + (before.empty() ? "" : ".") + std::string(path.key);
}

namespace {

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

double JsonReader::number(const Json& json, const JsonPath& path) {
  if (!json.is_number()) {
    fail(path, "must be a number");
    return 0;
  }
  return json.get<double>();
}

std::string JsonReader::text(const Json& json, const JsonPath& path) {
  if (json.is_string()) return json.get<std::string>();
  fail(path, "must be a text in quotes");
  return "";
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

RelationKind JsonReader::relation_kind(const Json& json, const JsonPath& path) {
  for (const RelationKind kind : {RelationKind::equal, RelationKind::above, RelationKind::free,
                                  RelationKind::below, RelationKind::joined})
    if (json == name(kind)) return kind;
  fail(path, "must be \"equal\", \"above\", \"free\", \"below\" or \"joined\"");
  return RelationKind::above;
}

CueKind JsonReader::cue_kind(const Json& json, const JsonPath& path) {
  for (const CueKind kind : {CueKind::slope, CueKind::crease})
    if (json == name(kind)) return kind;
  if (json != "bulge") fail(path, "must be \"bulge\", \"slope\" or \"crease\"");
  return CueKind::bulge;
}

}  // namespace relievo
