#include "io/scribbles/read_scribbles.h"

#include "io/scene/json_parse.h"

namespace relievo {

Result<Scribbles> read_scribbles(std::string_view json, const ScribbleLimits& limits) {
  JsonLimits json_limits;
  json_limits.max_bytes = limits.max_bytes;
  const auto parsed = parse_json(json, json_limits);
  if (!parsed) return parsed.error();
  ScribblesReader reader(limits);
  Scribbles scribbles = reader.file(*parsed);
  if (reader.error()) return *reader.error();
  return scribbles;
}

}  // namespace relievo
