#pragma once

namespace relievo {

/// Calls visit(x, y) once for every pixel of the picture's edge.
template <class Visit>
void along_edge(int width, int height, Visit visit) {
  for (int x = 0; x < width; ++x) {
    visit(x, 0);
    if (height > 1) visit(x, height - 1);
  }
  for (int y = 1; y + 1 < height; ++y) {
    visit(0, y);
    if (width > 1) visit(width - 1, y);
  }
}

}  // namespace relievo
