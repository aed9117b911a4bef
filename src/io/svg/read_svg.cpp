#include "io/svg/read_svg.h"

#include <algorithm>
#include <utility>

#include "io/parts/propose_parts.h"
#include "io/svg/annotated_parts.h"
#include "io/svg/paintable_svg.h"
#include "io/svg/svg_drawing.h"

namespace relievo {
namespace {

/// Elements that say something about parts and must not be painted.
using Notes = std::vector<pugi::xml_node>;

bool is_annotated(const SvgDrawing& drawing) {
  return std::any_of(drawing.groups.begin(), drawing.groups.end(), [](const SvgGroup& group) {
    return group.annotation.mark == SvgMark::part || group.annotation.has_part_values();
  });
}

bool uses_layers(const SvgDrawing& drawing, const SvgOptions& options) {
  if (options.layers == SvgLayers::automatic) return layers_are_parts(drawing);
  return options.layers == SvgLayers::parts;
}

Status take_annotations(const SvgDrawing& drawing, bool layers, SvgImport& import, Notes& notes) {
  auto parts = annotated_parts(drawing, layers);
  if (!parts) return parts.error();
  auto joins = annotated_joins(drawing, *parts, layers);
  if (!joins) return joins.error();
  auto cues = annotated_cues(drawing, *parts);
  if (!cues) return cues.error();
  auto relations = annotated_relations(drawing, *parts);
  if (!relations) return relations.error();
  Scene& scene = import.scene;
  for (AnnotatedPart& part : *parts) {
    scene.parts.push_back(std::move(part.part));
    import.colors.push_back(std::move(part.colors));
  }
  scene.joins = std::move(joins->joins);
  scene.relations = std::move(*relations);
  scene.cues = std::move(cues->cues);
  notes = std::move(joins->elements);
  notes.insert(notes.end(), cues->elements.begin(), cues->elements.end());
  return Done{};
}

Status propose(const SvgDrawing& drawing, const SvgOptions& options, SvgImport& import,
               Notes& notes) {
  if (drawing.shapes.size() > options.max_shapes) {
    return Error{ErrorCode::limit,
                 "too many shapes to propose parts from: group them into annotated parts (limit " +
                     std::to_string(options.max_shapes) + ")",
                 "svg"};
  }
  std::vector<Mark> marks = opaque_marks(drawing);
  import.line_art =
      !marks.empty() &&
      std::none_of(marks.begin(), marks.end(), [](const Mark& mark) { return mark.filled;
});
const FigureList figures = group_figures(std::move(marks), drawing.canvas());
ProposedParts proposed = propose_parts(figures);
import.scene.parts = std::move(proposed.parts);
import.colors = std::move(proposed.colors);
import.warnings.insert(import.warnings.end(), figures.notes.begin(), figures.notes.end());
import.proposed = true;
for (const SvgShape& shape : drawing.shapes) {
  if (!shape.is_note()) continue;
  notes.push_back(shape.element);
  import.warnings.push_back(std::string(shape.join ? "joins" : "cues") +
                            " are ignored where no part is annotated");
}
return Done{};
}  // namespace

/// A drawing with what it means, which may be nothing.
Result<SvgImport> interpret(std::string_view bytes, const SvgOptions& options) {
  const auto document = parse_svg_document(bytes, options);
  if (!document) return document.error();
  const auto drawing = read_drawing(**document, options);
  if (!drawing) return drawing.error();
  SvgImport import;
  Notes notes;
  import.warnings = drawing->warnings;
  import.scene.width = drawing->width;
  import.scene.height = drawing->height;
  const bool annotated = is_annotated(*drawing);
  const bool layers = !annotated && uses_layers(*drawing, options);
  const Status status = annotated || layers ? take_annotations(*drawing, layers, import, notes)
                                            : propose(*drawing, options, import, notes);
  if (!status) return status.error();
  import.paintable = {paintable_text(**document, drawing->px_width, drawing->px_height, notes),
                      drawing->px_width, drawing->px_height};
  return import;
}

}  // namespace relievo

Result<SvgImport> read_svg(std::string_view bytes, const SvgOptions& options) {
  auto import = interpret(bytes, options);
  if (import && import->scene.parts.empty())
    return Error{ErrorCode::bad_input, "no filled shape is visible on the canvas", "svg"};
  return import;
}

Result<PaintableSvg> paintable_svg(std::string_view bytes, const SvgOptions& options) {
  auto import = interpret(bytes, options);
  if (!import) return import.error();
  return std::move(import->paintable);
}

}  // namespace relievo
