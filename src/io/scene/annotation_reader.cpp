#include "io/scene/annotation_reader.h"

namespace relievo {

Join AnnotationReader::join(const Json& json, const JsonPath& path) {
  Join join;
  if (!keys(json, path, {"upper", "lower", "line"}, {})) return join;
  pair(json, path, join);
  join.line = points(json["line"], path.member("line"));
  return join;
}

Relation AnnotationReader::relation(const Json& json, const JsonPath& path) {
  Relation relation;
  if (!keys(json, path, {"upper", "lower", "relation"}, {"range"})) return relation;
  pair(json, path, relation);
  relation.kind = relation_kind(json["relation"], path.member("relation"));
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

RobinRange AnnotationReader::robin(const Json& json, const JsonPath& path) {
  RobinRange range;
  if (!keys(json, path, {"upper", "lower", "from", "to"}, {"alpha0", "rho"})) return range;
  pair(json, path, range);
  range.from = point(json["from"], path.member("from"));
  range.to = point(json["to"], path.member("to"));
  if (json.contains("alpha0")) range.alpha0 = number(json["alpha0"], path.member("alpha0"));
  if (json.contains("rho")) range.rho = number(json["rho"], path.member("rho"));
  return range;
}

Cue AnnotationReader::cue(const Json& json, const JsonPath& path) {
  Cue cue;
  if (!keys(json, path, {"part", "kind", "line", "value"}, {})) return cue;
  cue.part = part_reference(json["part"], path.member("part"));
  cue.kind = cue_kind(json["kind"], path.member("kind"));
  cue.line = points(json["line"], path.member("line"));
  cue.value = number(json["value"], path.member("value"));
  return cue;
}

}  // namespace relievo
