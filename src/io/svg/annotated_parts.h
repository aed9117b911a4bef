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

/// Returns the groups that are parts: those marked as such, and, with `layers`, all Inkscape
/// layers. The innermost such group owns a shape. Parts are sorted back to front by their first
/// shapes; a group without a filled shape is no part. The outline of a part holds its filled shapes
/// with their strokes, and strokes without a fill that are wider than 1/50 of the canvas diagonal.
/// Errors: `bad_input` where data-c, data-d, data-flat or data-lean is out of range.
Result<std::vector<AnnotatedPart>> annotated_parts(const SvgDrawing& drawing, bool layers);

/// Returns a relation for each part with data-relation to every part behind that it overlaps.
/// Errors: `bad_input` where the value is not equal, above or free.
Result<std::vector<Relation>> annotated_relations(const SvgDrawing& drawing,
                                                  const std::vector<AnnotatedPart>& parts);

/// Returns the opaque marks of each Inkscape layer that shows a filled shape or a wide stroke.
std::vector<std::vector<understanding::Mark>> marks_by_layer(const SvgDrawing& drawing);

/// Returns the part that holds the group, or -1.
int enclosing_part(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts, int group);

/// Returns the part whose id, or whose group's id or label, is `name`; `otherwise` for an empty
/// name. Errors: `bad_input` at `where` where there is no such part.
Result<int> part_named(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                       const std::string& name, int otherwise, const std::string& where);

}  // namespace relievo
