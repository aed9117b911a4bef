#include "relief/finish/ink_mesh.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "relief/finish/draw_in.h"
#include "relief/finish/ink_ribbons.h"
#include "relief/finish/ink_shell.h"
#include "relief/finish/place_tiles.h"
#include "relief/finish/spread_colours.h"

namespace relievo::relief {
namespace {

constexpr int swatches_in_row = 32;  ///< plain colours of which a row is as long as the picture
constexpr int least_swatch = 8;      ///< px, side of a plain colour

/// Places the colours of the lines below a picture. Texture coordinates are px of it.
class InkTiles {
 public:
  InkTiles(const std::vector<InkRibbon>& ribbons, const std::vector<PartInk>& parts,
           const Image8& inked, Image8& picture) {
    // Reduced textures must not mix them with others.
    const int side = std::max(least_swatch, inked.width / swatches_in_row);
    std::vector<ImageSize> sizes;
    for (const InkRibbon& ribbon : ribbons)
      sizes.push_back({ribbon.box.width(), ribbon.box.height()});
    sizes.resize(ribbons.size() + parts.size(), {side, side});
    const int drawn = picture.height;
    const auto places = place_tiles(sizes, picture.width, picture.height);
    Image8 tiles(picture.width, picture.height - drawn, 3, 255);
    Image8 known(tiles.width, tiles.height, 1);
    for (size_t i = 0; i < sizes.size(); ++i) {
      const auto [x, y] = places[i];
      const bool is_ribbon = i < ribbons.size();
      for (int v = 0; v < sizes[i].height; ++v)
        for (int u = 0; u < sizes[i].width; ++u) {
          const uint8_t* colour = is_ribbon
                                      ? &inked.at(ribbons[i].box.left + u, ribbons[i].box.top + v)
                                      : parts[i - ribbons.size()].rgb.data();
          std::copy_n(colour, 3, &tiles.at(x + u, y - drawn + v));
          known.at(x + u, y - drawn + v) = 1;
        }
      if (is_ribbon)
        corners_.push_back({1.0 * x - ribbons[i].box.left, 1.0 * y - ribbons[i].box.top});
      else
        colours_.push_back({x + 0.5 * side, y + 0.5 * side});
    }
    spread_colours(known, tiles);
    picture.pixels.resize(4 * static_cast<size_t>(picture.width) * picture.height, 255);
    uint8_t* below = &picture.at(0, drawn);
    for (size_t i = 0; i < known.pixels.size(); ++i)
      std::copy_n(&tiles.pixels[3 * i], 3, below + 4 * i);
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
