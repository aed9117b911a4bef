#include "understanding/labels/keep_figure.h"

#include "kernel/image/components.h"
#include "kernel/image/watershed.h"

namespace relievo::understanding {

void keep_figure(const Basins& basins, const std::vector<int>& of_basin, int last_label,
                 Image<int32_t>& labels) {
  const FigureMask& figure = basins.figure;
  if (figure.inside.empty()) return;
  constexpr int32_t wall = -1;
  for (size_t i = 0; i < labels.pixels.size(); ++i) {
    const int basin = basins.index.pixels[i];
    const bool stroke_says_no = of_basin[basin] == 0 && basins.region[basin] != 0;
    if (figure.inside.pixels[i] == 0 && figure.said) labels.pixels[i] = 0;
    if (labels.pixels[i] == 0 && (figure.inside.pixels[i] == 0 || stroke_says_no))
      labels.pixels[i] = wall;
  }
  flood_from_seeds(basins.ink, labels);
  Image8 left(labels.width, labels.height, 1);
  for (size_t i = 0; i < left.pixels.size(); ++i) left.pixels[i] = labels.pixels[i] == 0 ? 1 : 0;
  const Components pieces = connected_components(left, Connectivity::sides);
  for (size_t i = 0; i < labels.pixels.size(); ++i) {
    const int32_t piece = pieces.label.pixels[i];
    if (piece != 0) labels.pixels[i] = last_label + piece;
    if (labels.pixels[i] == wall) labels.pixels[i] = 0;
  }
}

}  // namespace relievo::understanding
