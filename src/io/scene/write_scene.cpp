#include "io/scene/write_scene.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace relievo {
namespace {

/// Returns the shortest text that reads back as the same number; whole numbers have no fraction.
std::string number(double value) {
  const bool whole = std::abs(value) < 1e15 && value == std::floor(value) && !std::signbit(value);
  if (whole) return std::to_string(static_cast<long long>(value));
  return nlohmann::json(value).dump();
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string point(Point2 p) { return "[" + number(p.x) + "," + number(p.y) + "]"; }

std::string points(const std::vector<Point2>& list) {
  std::string text = "[";
  for (size_t i = 0; i < list.size(); ++i) text += (i > 0 ? "," : "") + point(list[i]);
  return text + "]";
}

/// Returns a list with one item a line.
template <class Item, class Write>
std::string lines(const std::vector<Item>& items, const std::string& indent, Write write) {
  if (items.empty()) return "[]";
  std::string text = "[";
  for (size_t i = 0; i < items.size(); ++i)
    text += (i > 0 ? ",\n" : "\n") + indent + "  " + write(items[i]);
  return text + "\n" + indent + "]";
}

std::string part_text(const Part& part) {
  const std::string flat = part.flat != 0 ? ", \"flat\": " + number(part.flat) : "";
  const std::string lean = part.lean != Point2{} ? ", \"lean\": " + point(part.lean) : "";
  return "{ \"id\": " + quoted(part.id) + ", \"c\": " + number(part.c) +
         ", \"d\": " + number(part.d) + flat + lean +
         ", \"outline\": " + lines(part.outline, "    ", points) + " }";
}

/// Opens the object of an annotation of two parts.
template <class Item>
std::string pair_text(const Scene& scene, const Item& item) {
  return "{ \"upper\": " + quoted(scene.parts[item.upper].id) +
         ", \"lower\": " + quoted(scene.parts[item.lower].id);
}

std::string join_text(const Scene& scene, const Join& join) {
  return pair_text(scene, join) + ", \"line\": " + points(join.line) + " }";
}

std::string relation_text(const Scene& scene, const Relation& relation) {
  std::string text = pair_text(scene, relation) + ", \"relation\": \"" + name(relation.kind) + "\"";
  if (relation.range)
    text += ", \"range\": " + points({relation.range->first, relation.range->second});
  return text + " }";
}

std::string robin_text(const Scene& scene, const RobinRange& range) {
  std::string text =
      pair_text(scene, range) + ", \"from\": " + point(range.from) + ", \"to\": " + point(range.to);
  if (range.alpha0) text += ", \"alpha0\": " + number(*range.alpha0);
  if (range.rho) text += ", \"rho\": " + number(*range.rho);
  return text + " }";
}

std::string cue_text(const Scene& scene, const Cue& cue) {
  return "{ \"part\": " + quoted(scene.parts[cue.part].id) + ", \"kind\": \"" + name(cue.kind) +
         "\", \"line\": " + points(cue.line) + ", \"value\": " + number(cue.value) + " }";
}

}  // namespace

Result<std::string> write_scene(const Scene& scene) {
  if (Status status = validate(scene); !status) return status.error();
  const auto in_scene = [&](auto write) {
    return [&scene, write](const auto& item) { return write(scene, item); };
  };
  std::string text =
      "{\n  \"format\": \"relievo-scene\",\n  \"version\": 1,\n  \"canvas\": { \"width\": " +
      number(scene.width) + ", \"height\": " + number(scene.height) + " },\n";
  if (!scene.drawing.empty()) text += "  \"drawing\": " + quoted(scene.drawing) + ",\n";
  text += "  \"parts\": " + lines(scene.parts, "  ", part_text);
  text += ",\n  \"joins\": " + lines(scene.joins, "  ", in_scene(join_text));
  text += ",\n  \"relations\": " + lines(scene.relations, "  ", in_scene(relation_text));
  text += ",\n  \"robin\": " + lines(scene.robin, "  ", in_scene(robin_text));
  if (!scene.cues.empty()) text += ",\n  \"cues\": " + lines(scene.cues, "  ", in_scene(cue_text));
  return text + "\n}\n";
}

}  // namespace relievo
