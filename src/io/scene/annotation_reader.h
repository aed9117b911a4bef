#pragma once

#include "io/scene/json_reader.h"

namespace relievo {

/// Reads what scenes and projects say alike: lists, and annotations of an upper and a lower part.
class AnnotationReader : public JsonReader {
 public:
  using JsonReader::JsonReader;

 protected:
  ~AnnotationReader() = default;

  /// The part that a value names: its index, id or label, as the file has it.
  virtual int part_reference(const Json& json, const JsonPath& path) = 0;

  /// Reads every element of the list under `key`, where there is one.
  template <class Reader, class Item>
  void list(const Json& json, const JsonPath& parent, const char* key, std::vector<Item>& items,
            Item (Reader::*read)(const Json&, const JsonPath&)) {
    if (error() || !json.contains(key)) return;
    const JsonPath path = parent.member(key);
    if (!is_list(json[key], path, "objects")) return;
    for (size_t i = 0; i < json[key].size() && !error(); ++i)
      items.push_back((static_cast<Reader*>(this)->*read)(json[key][i], path.element(i)));
  }

  /// The two parts of an annotation, which differ.
  template <class Item>
  void pair(const Json& json, const JsonPath& path, Item& item) {
    using Index = decltype(item.upper);
    item.upper = static_cast<Index>(part_reference(json["upper"], path.member("upper")));
    item.lower = static_cast<Index>(part_reference(json["lower"], path.member("lower")));
    if (!error() && item.upper == item.lower) fail(path, "upper and lower are the same part");
  }

  Join join(const Json& json, const JsonPath& path);
  Relation relation(const Json& json, const JsonPath& path);
  RobinRange robin(const Json& json, const JsonPath& path);
  Cue cue(const Json& json, const JsonPath& path);
};

}  // namespace relievo
