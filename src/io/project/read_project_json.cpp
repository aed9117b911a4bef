#include "io/project/read_project_json.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/project/project.h"
#include "io/scene/json_parse.h"
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
    std::string known;
    for (size_t k = 0; k < understanding::completion_names.size(); ++k) {
      if (json == understanding::completion_names[k])
        return static_cast<understanding::CompletionKind>(k);
      known += (k == 0 ? "\"" : "\", \"") + std::string(understanding::completion_names[k]);
    }
    fail(path, "must be one of " + known + "\"");
    return {};
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

}  // namespace

Result<Project> read_project_json(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.error();
  ProjectReader reader;
  Project project = reader.project(*json);
  if (reader.error()) return *reader.error();
  return project;
}

}  // namespace relievo
