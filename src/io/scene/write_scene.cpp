#include "io/scene/write_scene.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace relievo {
namespace {

/// Shortest text that reads back as the same number; whole numbers without a fraction.
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

/// A list with one item a line.
template <class Item, class Write>
std::string lines(const std::vector<Item>& items, const std::string& indent, Write write) {
  if (items.empty()) return "[]";
  std::string text = "[";
  for (size_t i = 0; i < items.size(); ++i)
    text += (i > 0 ? ",\n" : "\n") + indent + "  " + write(items[i]);
  return text + "\n" + indent + "]";
}

class Writer {
 public:
  explicit Writer(const Scene& scene) : scene_(scene) {}

  std::string part(const Part& part) const {
    const std::string flat = part.flat != 0 ? ", \"flat\": " + number(part.flat) : "";
    const std::string lean = part.lean != Point2{} ? ", \"lean\": " + point(part.lean) : "";
    return "{ \"id\": " + quoted(part.id) + ", \"c\": " + number(part.c) +
           ", \"d\": " + number(part.d) + flat + lean +
           ", \"outline\": " + lines(part.outline, "    ", points) + " }";
  }

  std::string join(const Join& join) const {
    return "{ " + pair(join.upper, join.lower) + ", \"line\": " + points(join.line) + " }";
  }

  std::string relation(const Relation& relation) const {
    std::string text = "{ " + pair(relation.upper, relation.lower) + ", \"relation\": \"" +
                       name(relation.kind) + "\"";
    if (relation.range)
      text += ", \"range\": " + points({relation.range->first, relation.range->second});
    return text + " }";
  }

  std::string robin(const RobinRange& range) const {
    std::string text = "{ " + pair(range.upper, range.lower) + ", \"from\": " + point(range.from) +
                       ", \"to\": " + point(range.to);
    if (range.alpha0) text += ", \"alpha0\": " + number(*range.alpha0);
    if (range.rho) text += ", \"rho\": " + number(*range.rho);
    return text + " }";
  }

  std::string cue(const Cue& cue) const {
    return "{ \"part\": " + quoted(scene_.parts[cue.part].id) + ", \"kind\": \"" + name(cue.kind) +
           "\", \"line\": " + points(cue.line) + ", \"value\": " + number(cue.value) + " }";
  }

 private:
  std::string pair(int upper, int lower) const {
    return "\"upper\": " + quoted(scene_.parts[upper].id) +
           ", \"lower\": " + quoted(scene_.parts[lower].id);
  }

  const Scene& scene_;
};

}  // namespace

Result<std::string> write_scene(const Scene& scene) {
  if (Status status = validate(scene); !status) return status.error();
  const Writer writer(scene);
  std::string text =
      "{\n  \"format\": \"relievo-scene\",\n  \"version\": 1,\n  \"canvas\": { \"width\": " +
      number(scene.width) + ", \"height\": " + number(scene.height) + " },\n";
  if (!scene.drawing.empty()) text += "  \"drawing\": " + quoted(scene.drawing) + ",\n";
  text += "  \"parts\": " +
          lines(scene.parts, "  ", [&](const Part& part) { return writer.part(part); });
  text += ",\n  \"joins\": " +
          lines(scene.joins, "  ", [&](const Join& join) { return writer.join(join); });
  text += ",\n  \"relations\": " +
          lines(scene.relations, "  ", [&](const Relation& r) { return writer.relation(r); });
  text += ",\n  \"robin\": " +
          lines(scene.robin, "  ", [&](const RobinRange& range) { return writer.robin(range); });
  if (!scene.cues.empty())
    text += ",\n  \"cues\": " +
            lines(scene.cues, "  ", [&](const Cue& cue) { return writer.cue(cue); });
  return text + "\n}\n";
}

}  // namespace relievo
