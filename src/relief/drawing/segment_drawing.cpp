#include "relief/drawing/segment_drawing.h"

#include "relief/drawing/find_basins.h"

namespace relievo {

Result<Segmentation> segment_drawing(const Drawing& drawing, const Scribbles& scribbles,
                                     const LabelOptions& options) {
  const Result<Basins> basins = find_basins(drawing);
  if (!basins) return basins.error();
  return label_basins(*basins, scribbles, options);
}

}  // namespace relievo
