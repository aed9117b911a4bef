#include "io/svg/read_svg.h"

#include <algorithm>
#include <utility>

#include "io/parts/propose_parts.h"
#include "io/svg/interpret_svg.h"
#include "io/svg/svg_marks.h"

namespace relievo {
namespace {

bool is_annotated(const SvgDrawing& drawing) {
  return std::any_of(drawing.groups.begin(), drawing.groups.end(), [](const SvgGroup& group) {
    return group.annotation.mark == SvgMark::part || group.annotation.has_part_values();
  });
}

bool uses_layers(const SvgDrawing& drawing, const SvgOptions& options) {
  if (options.layers == SvgLayers::automatic) return layers_are_parts(drawing);
  return options.layers == SvgLayers::parts;
}

Status take_annotations(const SvgDrawing& drawing, bool layers, SvgInterpretation& result) {
  auto parts = annotated_parts(drawing, layers);
  if (!parts) return parts.error();
  auto joins = annotated_joins(drawing, *parts, layers);
  if (!joins) return joins.error();
  auto cues = annotated_cues(drawing, *parts);
  if (!cues) return cues.error();
  auto relations = annotated_relations(drawing, *parts);
  if (!relations) return relations.error();
  Scene& scene = result.import.scene;
  for (AnnotatedPart& part : *parts) {
    scene.parts.push_back(std::move(part.part));
    result.import.colors.push_back(std::move(part.colors));
  }
  scene.joins = std::move(joins->joins);
  scene.relations = std::move(*relations);
  scene.cues = std::move(cues->cues);
  result.note_elements = std::move(joins->elements);
  result.note_elements.insert(result.note_elements.end(), cues->elements.begin(),
                              cues->elements.end());
  return Done{};
}

Status propose(const SvgDrawing& drawing, const SvgOptions& options, SvgInterpretation& result) {
  if (drawing.shapes.size() > options.max_shapes) {
    return Error{ErrorCode::limit,
                 "too many shapes to propose parts from: group them into annotated parts (limit " +
                     std::to_string(options.max_shapes) + ")",
                 "svg"};
  }
  std::vector<Mark> marks = opaque_marks(drawing);
  result.import.line_art =
      !marks.empty() &&
      std::none_of(marks.begin(), marks.end(), [](const Mark& mark) { return mark.filled; });
  const FigureList figures = group_figures(std::move(marks), drawing.canvas());
  ProposedParts proposed = propose_parts(figures);
  result.import.scene.parts = std::move(proposed.parts);
  result.import.colors = std::move(proposed.colors);
  result.import.warnings.insert(result.import.warnings.end(), figures.notes.begin(),
                                figures.notes.end());
  result.import.proposed = true;
  for (const SvgShape& shape : drawing.shapes) {
    if (!shape.is_note()) continue;
    result.note_elements.push_back(shape.element);
    result.import.warnings.push_back(std::string(shape.join ? "joins" : "cues") +
                                     " are ignored where no part is annotated");
  }
  return Done{};
}

}  // namespace

Result<SvgInterpretation> interpret_svg(const SvgDrawing& drawing, const SvgOptions& options) {
  SvgInterpretation result;
  result.import.warnings = drawing.warnings;
  result.import.scene.width = drawing.width;
  result.import.scene.height = drawing.height;
  const bool annotated = is_annotated(drawing);
  const bool layers = !annotated && uses_layers(drawing, options);
  const Status status = annotated || layers ? take_annotations(drawing, layers, result)
                                            : propose(drawing, options, result);
  if (!status) return status.error();
  return result;
}

Result<SvgImport> read_svg(std::string_view bytes, const SvgOptions& options) {
  const auto document = parse_svg_document(bytes, options);
  if (!document) return document.error();
  const auto drawing = read_drawing(**document, options);
  if (!drawing) return drawing.error();
  auto result = interpret_svg(*drawing, options);
  if (!result) return result.error();
  if (result->import.scene.parts.empty()) {
    return Error{ErrorCode::bad_input, "no filled shape is visible on the canvas", "svg"};
  }
  return std::move(result->import);
}

}  // namespace relievo
