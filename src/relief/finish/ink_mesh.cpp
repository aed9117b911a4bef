#include "relief/finish/ink_mesh.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "relief/finish/draw_in.h"
#include "relief/finish/ink_ribbons.h"
#include "relief/finish/ink_shell.h"
#include "relief/finish/place_tiles.h"

namespace relievo::relief {
namespace {

constexpr int swatch = 8;  ///< px, side of a plain colour

/// Places the colours of the lines below a picture. Texture coordinates are px of it.
class InkTiles {
 public:
  InkTiles(const std::vector<InkRibbon>& ribbons, const std::vector<PartInk>& parts,
           const Image8& inked, Image8& picture) {
    std::vector<ImageSize> sizes;
    for (const InkRibbon& ribbon : ribbons)
      sizes.push_back({ribbon.box.width(), ribbon.box.height()});
    sizes.resize(ribbons.size() + parts.size(), {swatch, swatch});
    const auto places = place_tiles(sizes, picture.width, picture.height);
    picture.pixels.resize(4 * static_cast<size_t>(picture.width) * picture.height, 255);
    for (size_t i = 0; i < ribbons.size(); ++i) {
      const PixelBox& box = ribbons[i].box;
      const auto [x, y] = places[i];
      corners_.push_back({static_cast<double>(x - box.left), static_cast<double>(y - box.top)});
      for (int v = box.top; v < box.bottom; ++v)
        for (int u = box.left; u < box.right; ++u)
          std::copy_n(&inked.at(u, v), 3, &picture.at(x + u - box.left, y + v - box.top));
    }
    for (size_t p = 0; p < parts.size(); ++p) {
      const auto [x, y] = places[ribbons.size() + p];
      colours_.push_back({x + 0.5 * swatch, y + 0.5 * swatch});
      for (int v = y; v < y + swatch; ++v)
        for (int u = x; u < x + swatch; ++u)
          std::copy(parts[p].rgb.begin(), parts[p].rgb.end(), &picture.at(u, v));
    }
  }

  /// Returns what a ribbon's coordinates on the drawing are moved by.
  Point2 corner(size_t ribbon) const { return corners_[ribbon]; }
  const std::vector<Point2>& colours() const { return colours_; }

 private:
  std::vector<Point2> corners_;
  std::vector<Point2> colours_;  ///< by part
};

/// Adds ribbons of a surface at their place. `scale`: px of the drawing per px of the canvas.
void add_ribbons(const std::vector<InkRibbon>& ribbons, const InkTiles& tiles, double scale,
                 double height, const SolidPlace& place, double width, InkMesh& mesh) {
  for (size_t i = 0; i < ribbons.size(); ++i) {
    int v = static_cast<int>(mesh.positions.size());
    for (const std::array<Point3, 2>& rung : ribbons[i].rungs)
      for (const Point3& drawn : rung) {
        const Point3 p = rung[0] + width * (drawn - rung[0]);
        mesh.positions.push_back({place.scale.x * p.x + place.shift.x,
                                  place.scale.y * p.y + place.shift.y,
                                  place.scale.z * p.z + place.shift.z});
        mesh.uvs.push_back(tiles.corner(i) + scale * Point2{drawn.x, height - drawn.y});
      }
    // The part lies on the left of the line, the ribbon on its right.
    for (; v + 3 < static_cast<int>(mesh.positions.size()); v += 2) {
      mesh.triangles.push_back({v, v + 1, v + 2});
      mesh.triangles.push_back({v + 2, v + 1, v + 3});
    }
  }
}

/// Draws in a solid: its front, its walls and its back alike, so that it stays closed.
void draw_in_solid(const DrawIn& map, const SolidPlace& place, Point2 uv_per_px, Model& solid) {
  if (map.empty()) return;
  for (size_t v = 0; v < solid.positions.size(); ++v) {
    Point3& p = solid.positions[v];
    const Point2 at{(p.x - place.shift.x) / place.scale.x, (p.y - place.shift.y) / place.scale.y};
    const Point2 by = map.moved(at) - at;
    p.x += place.scale.x * by.x;
    p.y += place.scale.y * by.y;
    Point2& uv = solid.uvs[v];
    if (uv.y < place.pictured) uv = uv + Point2{by.x * uv_per_px.x, -by.y * uv_per_px.y};
  }
}

/// Adds the lines of a surface to a body: itself, or the solid that it lies on.
void add_lines(const ContourInk& ink, const Image8& inked, const Model& surface,
               const std::vector<InkRibbon>& ribbons, const SolidPlace& place, double width,
               const Model& body, Model& model, Image8& picture) {
  const double drawn = picture.height;
  const InkTiles tiles(ribbons, ink.parts, inked, picture);
  InkMesh mesh;
  add_ribbons(ribbons, tiles, inked.width / surface.width, surface.height, place, width, mesh);
  add_shells(ink, body, place, width, tiles.colours(), mesh);
  for (Point2& uv : mesh.uvs) uv = {uv.x / picture.width, uv.y / picture.height};
  model.ink = std::move(mesh);
  for (Point2& uv : model.uvs) uv.y *= drawn / picture.height;
}

}  // namespace

void add_ink(const ContourInk& ink, const Image8& inked, double width, Model& model,
             Image8& picture) {
  const auto ribbons = make_ribbons(ink, model, {inked.width, inked.height}, true);
  add_lines(ink, inked, model, ribbons, {}, width, model, model, picture);
}

void add_ink(const ContourInk& ink, const Image8& inked, double width, Model surface,
             const SolidPlace& place, Model& solid, Image8& picture) {
  const DrawIn map(ink);
  const Point2 uv_per_px{1 / surface.width, inked.height / (surface.height * picture.height)};
  draw_in_solid(map, place, uv_per_px, solid);
  draw_in(map, surface);
  const auto ribbons = make_ribbons(ink, surface, {inked.width, inked.height}, !place.backed);
  add_lines(ink, inked, surface, ribbons, place, width, weld(solid), solid, picture);
}

}  // namespace relievo::relief
