#include "relief/cues/strokes.h"

#include <algorithm>
#include <array>

#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

using Triangle = std::array<Point2, 3>;

/// Whether all of the triangle lies strictly on one side of the line through a and b.
bool on_one_side(const Triangle& triangle, Point2 a, Point2 b) {
  int left = 0;
  int right = 0;
  for (const Point2 p : triangle) {
    const double side = cross(b - a, p - a);
    left += side > 0 ? 1 : 0;
    right += side < 0 ? 1 : 0;
  }
  return left == 3 || right == 3;
}

/// Whether the segment lies strictly outside one edge of the triangle, whose area is positive.
bool beyond_an_edge(const Triangle& triangle, Point2 a, Point2 b) {
  for (int k = 0; k < 3; ++k) {
    const Point2 p = triangle[k];
    const Point2 edge = triangle[next_place(k)] - p;
    if (cross(edge, a - p) < 0 && cross(edge, b - p) < 0) return true;
  }
  return false;
}

bool apart(const Box2& a, const Box2& b) {
  return a.max.x < b.min.x || b.max.x < a.min.x || a.max.y < b.min.y || b.max.y < a.min.y;
}

}  // namespace

std::vector<StrokeContact> stroke_contacts(const PartSheet& sheet, const Scene& scene, int part,
                                           CueKind kind, double scale) {
  std::vector<StrokeContact> contacts;
  for (const Cue& cue : scene.cues) {
    if (cue.part != part || cue.kind != kind) continue;
    for (size_t i = 0; i + 1 < cue.line.size(); ++i) {
      const Point2 a = scale * cue.line[i];
      const Point2 b = scale * cue.line[i + 1];
      if (a == b) continue;
      const Box2 box = bounding_box(Ring{a, b});
      for (size_t t = 0; t < sheet.triangles.size(); ++t) {
        const auto [p, q, r] = sheet.triangles[t];
        const Triangle triangle{sheet.positions[p], sheet.positions[q], sheet.positions[r]};
        const auto [x0, x1] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
        const auto [y0, y1] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        if (apart(box, {{x0, y0}, {x1, y1}}) || on_one_side(triangle, a, b) ||
            beyond_an_edge(triangle, a, b))
          continue;
        contacts.push_back({static_cast<int>(t), &cue, 1 / distance(a, b) * (b - a)});
      }
    }
  }
  return contacts;
}

std::vector<bool> parts_with(const Scene& scene, std::initializer_list<CueKind> kinds) {
  std::vector<bool> found(scene.parts.size(), false);
  for (const Cue& cue : scene.cues)
    if (std::find(kinds.begin(), kinds.end(), cue.kind) != kinds.end()) found[cue.part] = true;
  return found;
}

}  // namespace relievo
