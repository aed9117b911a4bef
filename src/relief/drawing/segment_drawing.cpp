#include "relief/drawing/segment_drawing.h"

#include "relief/drawing/find_basins.h"

namespace relievo {

Result<Segmentation> segment_drawing(const Drawing& drawing, const Scribbles& scribbles,
                                     const RunContext& context) {
  const Result<Basins> basins = find_basins(drawing, context);
  if (!basins) return basins.error();
  if (context.cancelled()) return interrupted_error();
  return label_basins(*basins, scribbles);
}

}  // namespace relievo
