#pragma once

#include <string>
#include <vector>

#include "io/svg/annotated_parts.h"

namespace relievo {

/// The part that the group lies in, or -1.
int enclosing_part(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts, int group);

/// The part whose id, or whose group's id or label, is `name`; `otherwise` where that is empty.
/// Fails with bad_input at `where` where there is none.
Result<int> part_named(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                       const std::string& name, int otherwise, const std::string& where);

}  // namespace relievo
