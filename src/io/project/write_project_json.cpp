#include "io/project/write_project_json.h"

#include <nlohmann/json.hpp>

#include "io/project/project.h"
#include "io/scribbles/scribbles_json.h"

namespace relievo {
namespace {

using Ordered = nlohmann::ordered_json;

Ordered json_of(Point2 p) { return Ordered::array({p.x, p.y}); }

Ordered json_of(const std::vector<Point2>& points) {
  Ordered list = Ordered::array();
  for (const Point2 p : points) list.push_back(json_of(p));
  return list;
}

template <class Item>
Ordered pair_of(const Item& item) {
  return {{"upper", item.upper}, {"lower", item.lower}};
}

Ordered json_of(const understanding::Scribbles& scribbles) {
  Ordered strokes = Ordered::array();
  for (const understanding::Scribble& stroke : scribbles.strokes)
    strokes.push_back(stroke_json(stroke, scribbles));
  Ordered json = {{"parts", scribbles.parts}, {"strokes", std::move(strokes)}};
  if (scribbles.complete) json["complete"] = true;
  if (scribbles.count > 0) json["count"] = scribbles.count;
  return json;
}

Ordered json_of(understanding::PartLabel label, const understanding::PartCorrection& correction) {
  Ordered item = {{"label", label}};
  if (correction.id) item["id"] = *correction.id;
  if (correction.c) item["c"] = *correction.c;
  if (correction.d) item["d"] = *correction.d;
  if (correction.flat) item["flat"] = *correction.flat;
  if (correction.lean) item["lean"] = json_of(*correction.lean);
  if (!correction.outline) return item;
  item["outline"] = Ordered::array();
  for (const Ring& ring : *correction.outline) item["outline"].push_back(json_of(ring));
  return item;
}

using LabelPairs = std::vector<std::pair<understanding::PartLabel, understanding::PartLabel>>;

Ordered json_of(const LabelPairs& pairs) {
  Ordered list = Ordered::array();
  for (const auto& [upper, lower] : pairs) list.push_back({{"upper", upper}, {"lower", lower}});
  return list;
}

Ordered json_of(const understanding::Corrections& corrections) {
  Ordered json;
  for (const char* key : {"parts", "order", "joins", "no_joins", "relations", "robin"})
    json[key] = Ordered::array();
  for (const auto& [label, correction] : corrections.parts)
    json["parts"].push_back(json_of(label, correction));
  json["order"] = json_of(corrections.order);
  for (const Join& join : corrections.joins) {
    Ordered item = pair_of(join);
    item["line"] = json_of(join.line);
    json["joins"].push_back(std::move(item));
  }
  json["no_joins"] = json_of(corrections.no_joins);
  for (const Relation& relation : corrections.relations) {
    Ordered item = pair_of(relation);
    item["relation"] = name(relation.kind);
    if (relation.range)
      item["range"] = json_of(std::vector<Point2>{relation.range->first, relation.range->second});
    json["relations"].push_back(std::move(item));
  }
  for (const RobinRange& range : corrections.robin) {
    Ordered item = pair_of(range);
    item["from"] = json_of(range.from);
    item["to"] = json_of(range.to);
    if (range.alpha0) item["alpha0"] = *range.alpha0;
    if (range.rho) item["rho"] = *range.rho;
    json["robin"].push_back(std::move(item));
  }
  for (const Cue& cue : corrections.cues)
    json["cues"].push_back({{"part", cue.part},
                            {"kind", name(cue.kind)},
                            {"line", json_of(cue.line)},
                            {"value", cue.value}});
  return json;
}

Ordered json_of(const understanding::SegmentationRecord& record) {
  Ordered parts = Ordered::array();
  for (const understanding::PartRecord& part : record.parts)
    parts.push_back(
        {{"label", part.label}, {"id", part.id}, {"completion", name(part.completion)}});
  Ordered order = Ordered::array();
  for (const understanding::OrderArrow& arrow : record.order) {
    Ordered item = pair_of(arrow);
    item["confidence"] = arrow.confidence;
    item["user"] = arrow.user;
    item["kept"] = arrow.kept;
    order.push_back(std::move(item));
  }
  Ordered joins = Ordered::array();
  for (const understanding::JoinRecord& join : record.joins) {
    Ordered item = pair_of(join);
    item["confidence"] = join.confidence;
    joins.push_back(std::move(item));
  }
  return {{"parts", std::move(parts)},
          {"order", std::move(order)},
          {"joins", std::move(joins)},
          {"scribbles", json_of(record.scribbles)},
          {"corrections", json_of(record.corrections)}};
}

}  // namespace

std::string write_project_json(const Project& project) {
  Ordered json = {{"format", "relievo-project"}, {"version", project_version}};
  json["name"] = project.name;
  json["drawing"] = nullptr;
  if (!project.drawing.bytes.empty())
    json["drawing"] = {{"name", project.drawing.name},
                       {"kind", project.drawing.kind},
                       {"mime", project.drawing.mime}};
  for (const auto& [key, value] : project.other_keys) json[key] = Ordered::parse(value);
  if (project.segmentation) json["segmentation"] = json_of(*project.segmentation);
  return json.dump(1, ' ', false, Ordered::error_handler_t::replace) + "\n";
}

}  // namespace relievo
