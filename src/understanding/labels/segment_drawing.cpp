#include "understanding/labels/segment_drawing.h"

#include "understanding/areas/find_basins.h"
#include "understanding/labels/label_basins.h"
#include "understanding/perception/built_in_network.h"

namespace relievo::understanding {

Result<Segmentation> segment_drawing(const Drawing& drawing, const Scribbles& scribbles,
                                     const RunContext& context) {
  const Result<Basins> basins = find_basins(drawing, built_in_network(), context);
  if (!basins) return basins.error();
  if (context.cancelled()) return interrupted_error();
  return label_basins(*basins, scribbles);
}

}  // namespace relievo::understanding
