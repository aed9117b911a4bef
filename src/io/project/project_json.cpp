#include "io/project/project_json.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/scene/json_reader.h"
#include "io/scribbles/scribbles_json.h"

namespace relievo {
namespace {

constexpr std::array own_keys = {"format", "version", "name", "drawing", "segmentation"};

/// Reads the values of project.json.
class ProjectReader final : public JsonReader {
 public:
  ProjectReader() : JsonReader(JsonLimits().max_points) {}

  Project project(const Json& json) {
    Project project;
    const JsonPath root;
    if (!is_file(json, "project", project_version)) return project;
    set(json, root, "name", project.name, &ProjectReader::text);
    if (json.contains("drawing") && !json["drawing"].is_null())
      project.drawing = drawing(json["drawing"], root.member("drawing"));
    if (json.contains("segmentation"))
      project.segmentation = segmentation(json["segmentation"], root.member("segmentation"));
    for (const auto& [key, value] : json.items())
      if (std::find(own_keys.begin(), own_keys.end(), key) == own_keys.end())
        project.other_keys[key] = value.dump();
    return project;
  }

 private:
  ProjectDrawing drawing(const Json& json, const JsonPath& path) {
    ProjectDrawing drawing;
    if (!keys(json, path, {"name", "kind", "mime"}, {"paintable"})) return drawing;
    set(json, path, "name", drawing.name, &ProjectReader::text);
    set(json, path, "kind", drawing.kind, &ProjectReader::text);
    set(json, path, "mime", drawing.mime, &ProjectReader::text);
    if (drawing.kind != "svg" && drawing.kind != "image")
      fail(path.member("kind"), "must be \"image\" or \"svg\"");
    return drawing;
  }

  understanding::SegmentationRecord segmentation(const Json& json, const JsonPath& path) {
    understanding::SegmentationRecord record;
    if (!keys(json, path, {"parts", "order", "joins", "scribbles", "corrections"}, {}))
      return record;
    list(json, path, "parts", record.parts, &ProjectReader::part);
    list(json, path, "order", record.order, &ProjectReader::arrow);
    list(json, path, "joins", record.joins, &ProjectReader::join_record);
    record.scribbles = scribbles(json["scribbles"], path.member("scribbles"));
    record.corrections = corrections(json["corrections"], path.member("corrections"));
    return record;
  }

  understanding::PartLabel label(const Json& json, const JsonPath& path) {
    return static_cast<understanding::PartLabel>(
        whole_number(json, path, std::numeric_limits<understanding::PartLabel>::max()));
  }

  int part_reference(const Json& json, const JsonPath& path) override { return label(json, path); }

  understanding::CompletionKind completion(const Json& json, const JsonPath& path) {
    const auto& names = understanding::completion_names;
    return static_cast<understanding::CompletionKind>(
        choice(json, path, {names.begin(), names.end()}));
  }

  double share(const Json& json, const JsonPath& path) {
    const double value = number(json, path);
    if (!error() && !(value >= 0 && value <= 1)) fail(path, "must lie between 0 and 1");
    return value;
  }

  understanding::PartRecord part(const Json& json, const JsonPath& path) {
    if (!keys(json, path, {"label", "id", "completion"}, {})) return {};
    return {label(json["label"], path.member("label")), text(json["id"], path.member("id")),
            completion(json["completion"], path.member("completion"))};
  }

  understanding::OrderArrow arrow(const Json& json, const JsonPath& path) {
    understanding::OrderArrow arrow;
    if (!keys(json, path, {"upper", "lower", "confidence", "user", "kept"}, {})) return arrow;
    pair(json, path, arrow);
    arrow.confidence = share(json["confidence"], path.member("confidence"));
    arrow.user = flag(json["user"], path.member("user"));
    arrow.kept = flag(json["kept"], path.member("kept"));
    return arrow;
  }

  understanding::JoinRecord join_record(const Json& json, const JsonPath& path) {
    understanding::JoinRecord join;
    if (!keys(json, path, {"upper", "lower", "confidence"}, {})) return join;
    pair(json, path, join);
    join.confidence = share(json["confidence"], path.member("confidence"));
    return join;
  }

  understanding::Scribbles scribbles(const Json& json, const JsonPath& path) {
    auto scribbles = scribbles_of(json, path);
    if (scribbles) return std::move(*scribbles);
    fail(scribbles.error());
    return {};
  }

  understanding::Corrections corrections(const Json& json, const JsonPath& path) {
    understanding::Corrections corrections;
    if (!keys(json, path, {},
              {"parts", "order", "joins", "no_joins", "relations", "robin", "cues"}))
      return corrections;
    std::vector<std::pair<understanding::PartLabel, understanding::PartCorrection>> parts;
    list(json, path, "parts", parts, &ProjectReader::part_correction);
    corrections.parts.insert(parts.begin(), parts.end());
    list(json, path, "order", corrections.order, &ProjectReader::label_pair);
    list(json, path, "joins", corrections.joins, &ProjectReader::join);
    list(json, path, "no_joins", corrections.no_joins, &ProjectReader::label_pair);
    list(json, path, "relations", corrections.relations, &ProjectReader::relation);
    list(json, path, "robin", corrections.robin, &ProjectReader::robin);
    list(json, path, "cues", corrections.cues, &ProjectReader::cue);
    return corrections;
  }

  std::pair<understanding::PartLabel, understanding::PartCorrection> part_correction(
      const Json& json, const JsonPath& path) {
    understanding::PartCorrection correction;
    if (!keys(json, path, {"label"}, {"id", "outline", "c", "d", "flat", "lean"})) return {};
    part_values(json, path, correction);
    return {label(json["label"], path.member("label")), std::move(correction)};
  }

  std::pair<understanding::PartLabel, understanding::PartLabel> label_pair(const Json& json,
                                                                           const JsonPath& path) {
    understanding::JoinRecord pair_record;
    if (!keys(json, path, {"upper", "lower"}, {})) return {};
    pair(json, path, pair_record);
    return {pair_record.upper, pair_record.lower};
  }
};

using Ordered = nlohmann::ordered_json;

template <class Items, class Write>
Ordered list_of(const Items& items, Write write) {
  Ordered list = Ordered::array();
  for (const auto& item : items) list.push_back(write(item));
  return list;
}

Ordered point_json(Point2 p) { return Ordered::array({p.x, p.y}); }

Ordered line_json(const std::vector<Point2>& points) { return list_of(points, point_json); }

template <class Item>
Ordered pair_of(const Item& item) {
  return {{"upper", item.upper}, {"lower", item.lower}};
}

Ordered scribbles_json(const understanding::Scribbles& scribbles) {
  Ordered json = {
      {"parts", scribbles.parts},
      {"strokes", list_of(scribbles.strokes, [&](const understanding::Scribble& stroke) {
         return stroke_json(stroke, scribbles);
       })}};
  if (scribbles.complete) json["complete"] = true;
  if (scribbles.count > 0) json["count"] = scribbles.count;
  return json;
}

Ordered part_json(
    const std::pair<const understanding::PartLabel, understanding::PartCorrection>& part) {
  const auto& [label, correction] = part;
  Ordered item = {{"label", label}};
  if (correction.id) item["id"] = *correction.id;
  if (correction.c) item["c"] = *correction.c;
  if (correction.d) item["d"] = *correction.d;
  if (correction.flat) item["flat"] = *correction.flat;
  if (correction.lean) item["lean"] = point_json(*correction.lean);
  if (correction.outline) item["outline"] = list_of(*correction.outline, line_json);
  return item;
}

Ordered labels_json(const std::pair<understanding::PartLabel, understanding::PartLabel>& labels) {
  return {{"upper", labels.first}, {"lower", labels.second}};
}

Ordered join_json(const Join& join) {
  Ordered item = pair_of(join);
  item["line"] = line_json(join.line);
  return item;
}

Ordered relation_json(const Relation& relation) {
  Ordered item = pair_of(relation);
  item["relation"] = name(relation.kind);
  if (relation.range) item["range"] = line_json({relation.range->first, relation.range->second});
  return item;
}

Ordered robin_json(const RobinRange& range) {
  Ordered item = pair_of(range);
  item["from"] = point_json(range.from);
  item["to"] = point_json(range.to);
  if (range.alpha0) item["alpha0"] = *range.alpha0;
  if (range.rho) item["rho"] = *range.rho;
  return item;
}

Ordered cue_json(const Cue& cue) {
  return {{"part", cue.part},
          {"kind", name(cue.kind)},
          {"line", line_json(cue.line)},
          {"value", cue.value}};
}

Ordered corrections_json(const understanding::Corrections& corrections) {
  Ordered json = {{"parts", list_of(corrections.parts, part_json)},
                  {"order", list_of(corrections.order, labels_json)},
                  {"joins", list_of(corrections.joins, join_json)},
                  {"no_joins", list_of(corrections.no_joins, labels_json)},
                  {"relations", list_of(corrections.relations, relation_json)},
                  {"robin", list_of(corrections.robin, robin_json)}};
  if (!corrections.cues.empty()) json["cues"] = list_of(corrections.cues, cue_json);
  return json;
}

Ordered part_record_json(const understanding::PartRecord& part) {
  return {{"label", part.label}, {"id", part.id}, {"completion", name(part.completion)}};
}

Ordered arrow_json(const understanding::OrderArrow& arrow) {
  Ordered item = pair_of(arrow);
  item["confidence"] = arrow.confidence;
  item["user"] = arrow.user;
  item["kept"] = arrow.kept;
  return item;
}

Ordered join_record_json(const understanding::JoinRecord& join) {
  Ordered item = pair_of(join);
  item["confidence"] = join.confidence;
  return item;
}

Ordered record_json(const understanding::SegmentationRecord& record) {
  return {{"parts", list_of(record.parts, part_record_json)},
          {"order", list_of(record.order, arrow_json)},
          {"joins", list_of(record.joins, join_record_json)},
          {"scribbles", scribbles_json(record.scribbles)},
          {"corrections", corrections_json(record.corrections)}};
}

}  // namespace

Result<Project> read_project_json(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.error();
  ProjectReader reader;
  Project project = reader.project(*json);
  if (reader.error()) return *reader.error();
  return project;
}

std::string write_project_json(const Project& project) {
  Ordered json = {{"format", "relievo-project"}, {"version", project_version}};
  json["name"] = project.name;
  json["drawing"] = nullptr;
  if (!project.drawing.bytes.empty())
    json["drawing"] = {{"name", project.drawing.name},
                       {"kind", project.drawing.kind},
                       {"mime", project.drawing.mime}};
  for (const auto& [key, value] : project.other_keys) json[key] = Ordered::parse(value);
  if (project.segmentation) json["segmentation"] = record_json(*project.segmentation);
  return json.dump(1, ' ', false, Ordered::error_handler_t::replace) + "\n";
}

}  // namespace relievo
