#pragma once

#include <algorithm>

namespace relievo {

/// A rectangle of pixels: columns [left, right) and rows [top, bottom). It may reach beyond a
/// picture.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool empty() const { return right <= left || bottom <= top; }
  bool contains(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
};

/// Returns the pixels in both boxes.
inline PixelBox intersect(const PixelBox& p, const PixelBox& q) {
  return {std::max(p.left, q.left), std::max(p.top, q.top), std::min(p.right, q.right),
          std::min(p.bottom, q.bottom)};
}

}  // namespace relievo
