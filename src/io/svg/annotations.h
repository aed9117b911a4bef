#pragma once

#include <pugixml.hpp>
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

/// Adds the joins of the drawing, and the elements that draw them to `elements`. A marked line
/// joins the part that holds it (or data-upper) to data-lower, which may lie in front of it (see
/// turn_joins_from_behind), or else to the nearest part behind that contains most of it. With
/// `layers`, a stroke without a fill that runs along the outline of its part, over a part behind,
/// is a join too. Errors: `bad_input` for unknown or missing names, `contradiction` for a line over
/// no part behind.
Status add_annotated_joins(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                           bool layers, std::vector<Join>& joins,
                           std::vector<pugi::xml_node>& elements);

/// Adds the cues of the drawing, and the elements that draw them to `elements`: each subpath of a
/// marked line is a cue of the part that holds it or of data-part. Errors: `bad_input` for an
/// unknown or missing part, and for an unsound data-cue or data-value.
Status add_annotated_cues(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                          std::vector<Cue>& cues, std::vector<pugi::xml_node>& elements);

}  // namespace relievo
