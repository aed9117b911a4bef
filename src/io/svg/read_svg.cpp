#include "io/svg/read_svg.h"

#include <utility>

#include "io/svg/propose_parts.h"
#include "io/svg/svg_drawing.h"

namespace relievo {

Result<SvgImport> read_svg(std::string_view bytes, const SvgOptions& options) {
  const auto document = parse_svg_document(bytes, options);
  if (!document) return document.error();
  const auto drawing = read_drawing(**document, options);
  if (!drawing) return drawing.error();
  SvgImport import;
  import.scene.width = drawing->width;
  import.scene.height = drawing->height;
  import.scene.parts = propose_parts(*drawing);
  import.proposed = true;
  import.warnings = drawing->warnings;
  return import;
}

}  // namespace relievo
