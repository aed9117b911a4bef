#pragma once

#include <string>
#include <vector>

#include "io/svg/svg_drawing.h"
#include "relievo/scene.h"

namespace relievo {

/// A group of the drawing that is one part of the scene.
struct AnnotatedPart {
  int group = -1;
  Part part;
  Palette colors;
};

/// The groups that are parts: those marked as such, and, with `layers`, all Inkscape layers. The
/// innermost such group owns a shape. Back to front by the first shape of each; a group without
/// a filled shape is no part. The silhouette of a part is what its filled shapes paint, their
/// strokes included, and strokes without a fill that are wider than 1/50 of the canvas diagonal.
/// Fails with bad_input where data-c or data-d is no sound number.
Result<std::vector<AnnotatedPart>> annotated_parts(const SvgDrawing& drawing, bool layers);

/// Relations that data-relation asks for: to every part behind that the part overlaps. Fails with
/// bad_input where the value is not equal, above or free.
Result<std::vector<Relation>> annotated_relations(const SvgDrawing& drawing,
                                                  const std::vector<AnnotatedPart>& parts);

/// Returns the opaque marks of each Inkscape layer that shows a filled shape or a wide stroke.
std::vector<std::vector<understanding::Mark>> marks_by_layer(const SvgDrawing& drawing);

/// The part that the group lies in, or -1.
int enclosing_part(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts, int group);

/// The part whose id, or whose group's id or label, is `name`; `otherwise` where that is empty.
/// Fails with bad_input at `where` where there is none.
Result<int> part_named(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                       const std::string& name, int otherwise, const std::string& where);

}  // namespace relievo
