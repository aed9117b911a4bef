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
  const auto kinds = {RelationKind::equal, RelationKind::above, RelationKind::free,
                      RelationKind::below, RelationKind::joined};
  const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                 [&](RelationKind one) { return json["relation"] == name(one); });
  if (kind == kinds.end())
    fail(path.member("relation"),
         "must be \"equal\", \"above\", \"free\", \"below\" or \"joined\"");
  relation.kind = kind == kinds.end() ? RelationKind::above : *kind;
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
  const auto kinds = {CueKind::bulge, CueKind::slope, CueKind::crease};
  const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                 [&](CueKind one) { return json["kind"] == name(one); });
  if (kind == kinds.end())
    fail(path.member("kind"), "must be \"bulge\", \"slope\" or \"crease\"");
  else
    cue.kind = *kind;
  set(json, path, "line", cue.line, &JsonReader::points);
  set(json, path, "value", cue.value, &JsonReader::number);
  return cue;
}

}  // namespace relievo
