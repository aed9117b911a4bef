#include "io/svg/read_svg.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "io/svg/annotations.h"
#include "io/svg/paintable_text.h"
#include "io/svg/svg_attributes.h"
#include "io/svg/svg_document.h"
#include "io/svg/svg_drawing.h"

namespace relievo {
namespace {

using understanding::LayeredDrawing;

using Elements = std::vector<pugi::xml_node>;

bool is_annotated(const SvgDrawing& drawing) {
  return std::any_of(drawing.groups.begin(), drawing.groups.end(), [](const SvgGroup& group) {
    return group.mark == SvgMark::part || has_part_values(group.element);
  });
}

bool has_notes(const SvgDrawing& drawing) {
  return std::any_of(drawing.shapes.begin(), drawing.shapes.end(),
                     [](const SvgShape& shape) { return shape.is_note(); });
}

/// Takes the parts and their joins, cues and relations; `lines` become the elements that draw
/// joins and cues.
Status take_annotations(const SvgDrawing& drawing, bool layers, LayeredDrawing& result,
                        Elements& lines) {
  auto parts = annotated_parts(drawing, layers);
  if (!parts) return parts.error();
  Scene& scene = result.scene;
  if (Status s = add_annotated_joins(drawing, *parts, layers, scene.joins, lines); !s) return s;
  if (Status s = add_annotated_cues(drawing, *parts, scene.cues, lines); !s) return s;
  auto relations = annotated_relations(drawing, *parts);
  if (!relations) return relations.error();
  for (AnnotatedPart& part : *parts) {
    scene.parts.push_back(std::move(part.part));
    result.colors.push_back(std::move(part.colors));
  }
  scene.relations = std::move(*relations);
  turn_joins_from_behind(scene);
  return Done{};
}

/// Sets the texts of the drawing to paint, without `lines`. Where the drawing's layers may be no
/// parts, the text with these lines is kept too.
void set_paintable(SvgDocument& document, const SvgDrawing& drawing, const Elements& lines,
                   LayeredDrawing& result) {
  const double width = drawing.px_width;
  const double height = drawing.px_height;
  if (!result.layers.empty() && !lines.empty()) {
    pugi::xml_document copy;
    copy.reset(document.xml);
    result.text_with_lines = paintable_text(copy.document_element(), width, height);
  }
  for (pugi::xml_node line : lines) set_attribute(line, "data-relievo", "ignore");
  result.paintable = {paintable_text(document.root, width, height), width, height};
}

/// Returns whether the drawing shows pictures alone, at most one of which is cut out.
bool is_flat(const SvgDrawing& drawing) {
  const auto shows = [](const SvgShape& shape) {
    return (shape.fill && shape.fill->a > faint_alpha) ||
           (shape.stroke && shape.stroke->a > faint_alpha);
  };
  size_t pictures = 0;
  size_t cut_out = 0;
  for (const SvgShape& shape : drawing.shapes) {
    if (!shows(shape)) continue;
    if (!shape.picture) return false;
    ++pictures;
    cut_out += shape.picture->has_holes ? 1 : 0;
  }
  return pictures > 0 && cut_out < 2;
}

std::vector<const SvgShape*> shapes_of(const SvgDrawing& drawing) {
  std::vector<const SvgShape*> shapes;
  for (const SvgShape& shape : drawing.shapes) shapes.push_back(&shape);
  return shapes;
}

}  // namespace

Result<LayeredDrawing> read_svg(std::string_view bytes, const SvgOptions& options) {
  const auto document = parse_svg_document(bytes, options);
  if (!document) return document.error();
  const auto drawing = read_drawing(**document, options);
  if (!drawing) return drawing.error();
  LayeredDrawing result;
  result.warnings = drawing->warnings;
  result.scene.width = drawing->width;
  result.scene.height = drawing->height;
  const bool annotated = is_annotated(*drawing);
  const bool declared = annotated || has_notes(*drawing);
  if (!declared) {
    result.marks = opaque_marks(*drawing, shapes_of(*drawing));
    result.layers = marks_by_layer(*drawing);
    if (result.layers.size() < 2) result.layers.clear();
    result.flat = is_flat(*drawing);
  }
  Elements lines;
  if (declared || !result.layers.empty())
    if (Status status = take_annotations(*drawing, !annotated, result, lines); !status)
      return status.error();
  for (const SvgShape& shape : drawing->shapes)
    if (shape.fill && !shape.is_note())
      result.anchors.insert(result.anchors.end(), shape.anchors.begin(), shape.anchors.end());
  set_paintable(**document, *drawing, lines, result);
  return result;
}

}  // namespace relievo
