#include "relief/finish/ink_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "kernel/image/pixel_box.h"
#include "kernel/meshing/simplify_triangles.h"
#include "kernel/meshing/vertex_numbering.h"
#include "relief/finish/floor.h"
#include "relief/finish/place_tiles.h"

namespace relievo::relief {
namespace {

constexpr double ribbon_lift = 0.002;  ///< of the canvas: height of ribbons above parts below
constexpr double steepest = 3;         ///< widths by which a ribbon rises to the parts below
constexpr int tile_margin = 2;         ///< px around a ribbon, for filtering
constexpr int tile_side = 24;          ///< px, shorter side of most tiles
constexpr double shell_share = 0.35;   ///< of the surface's triangles that a shell has
constexpr double shell_error = 0.5;    ///< of the ink's width by which it may depart
constexpr int swatch = 8;              ///< px, side of a plain colour

/// A stretch of a line and the pixels of the drawing around it.
struct Piece {
  int part = 0;
  std::vector<OutlinePoint> points;
  PixelBox box;
};

/// Builds the lines. Their texture coordinates are px of the picture.
class InkBuilder {
 public:
  InkBuilder(const ContourInk& ink, const Image8& inked, const Model& model)
      : ink_(ink),
        inked_(inked),
        model_(model),
        scale_(inked.width / model.width),
        numbers_(model.positions.size()) {
    for (const InkLine& line : ink.lines) cut_line(line);
  }

  InkMesh build(Image8& picture) {
    std::vector<ImageSize> sizes;
    for (const Piece& piece : pieces_) sizes.push_back({piece.box.width(), piece.box.height()});
    sizes.resize(pieces_.size() + model_.parts.size(), {swatch, swatch});
    places_ = place_tiles(sizes, picture.width, picture.height);
    picture.pixels.resize(4 * static_cast<size_t>(picture.width) * picture.height, 255);
    add_ribbons(picture);
    add_shells(picture);
    return std::move(mesh_);
  }

 private:
  /// Returns the two ends of the line across the ink of a point, canvas px: inner, outer.
  static std::array<Point2, 2> across(const OutlinePoint& p) {
    return {p.place - p.inside * p.out, p.place + p.outside * p.out};
  }

  Point2 on_drawing(Point2 canvas) const {
    return {scale_ * canvas.x, scale_ * (model_.height - canvas.y)};
  }

  PixelBox pixels_around(const Box2& box) const {
    const auto low = [](double v) {
      return std::max(0, static_cast<int>(std::floor(v)) - tile_margin);
    };
    const auto high = [](double v, int most) {
      return std::min(most, static_cast<int>(std::floor(v)) + tile_margin + 1);
    };
    return {low(box.min.x), low(box.min.y), high(box.max.x, inked_.width),
            high(box.max.y, inked_.height)};
  }

  /// Cuts a line into pieces of about `tile_side`, or longer where they run along rows or columns.
  void cut_line(const InkLine& line) {
    std::vector<OutlinePoint> points = line.points;
    if (line.closed) points.push_back(points.front());
    Piece piece{line.part, {}, {}};
    Box2 box;
    const auto finish = [&] {
      if (piece.points.size() > 1) {
        piece.box = pixels_around(box);
        pieces_.push_back(piece);
      }
    };
    const auto grow = [&](Box2 by, const OutlinePoint& p) {
      for (const Point2 end : across(p)) by.add(on_drawing(end));
      return by;
    };
    for (const OutlinePoint& p : points) {
      Box2 grown = grow(box, p);
      const double breadth = scale_ * (p.inside + p.outside);
      const Point2 sides = grown.max - grown.min;
      if (piece.points.size() > 1 && std::min(sides.x, sides.y) > tile_side + breadth) {
        finish();
        const OutlinePoint last = piece.points.back();
        piece.points = {last};
        grown = grow(grow({}, last), p);
      }
      piece.points.push_back(p);
      box = grown;
    }
    finish();
  }

  void add_ribbons(Image8& picture) {
    Floor floor(model_);
    size_t next = 0;
    for (size_t p = 0; p < model_.parts.size(); ++p) {
      for (; next < pieces_.size() && pieces_[next].part == static_cast<int>(p); ++next) {
        copy_tile(pieces_[next].box, places_[next], picture);
        add_ribbon(pieces_[next], places_[next], floor);
      }
      floor.add(model_, model_.parts[p], model_.positions);
    }
  }

  void copy_tile(const PixelBox& box, const std::array<int, 2>& place, Image8& picture) const {
    for (int y = box.top; y < box.bottom; ++y)
      for (int x = box.left; x < box.right; ++x)
        std::copy_n(&inked_.at(x, y), 3,
                    &picture.at(place[0] + x - box.left, place[1] + y - box.top));
  }

  void add_ribbon(const Piece& piece, const std::array<int, 2>& place, const Floor& floor) {
    const double lift = ribbon_lift * std::max(model_.width, model_.height);
    for (size_t i = 0; i < piece.points.size(); ++i) {
      const OutlinePoint& p = piece.points[i];
      const Point3 inner = model_.positions[p.vertex];
      const Point2 outer = across(p)[1];
      const double below = floor.range_at({outer.x / model_.width, 1 - outer.y / model_.height})[1];
      const double most = inner.z + steepest * (p.inside + p.outside);
      mesh_.positions.push_back(inner);
      mesh_.positions.push_back({outer.x, outer.y, std::clamp(below + lift, inner.z, most)});
      for (const Point2 end : {Point2{inner.x, inner.y}, outer}) {
        const Point2 on = on_drawing(end);
        mesh_.uvs.push_back({place[0] + on.x - piece.box.left, place[1] + on.y - piece.box.top});
      }
      if (i == 0) continue;
      const int v = static_cast<int>(mesh_.positions.size()) - 4;
      // The part lies on the left of the line, the ribbon on its right.
      mesh_.triangles.push_back({v, v + 1, v + 2});
      mesh_.triangles.push_back({v + 2, v + 1, v + 3});
    }
  }

  /// Returns the width of ink at every vertex, the mean of its triangles'.
  std::vector<double> shell_widths() const {
    std::vector<double> width(model_.positions.size(), 0);
    std::vector<int> count(model_.positions.size(), 0);
    for (size_t p = 0; p < model_.parts.size(); ++p)
      for (int t = model_.parts[p].first_triangle; t < model_.parts[p].end(); ++t)
        for (const int v : model_.triangles[t]) {
          width[v] += ink_.parts[p].width;
          ++count[v];
        }
    for (size_t v = 0; v < width.size(); ++v) width[v] /= std::max(1, count[v]);
    return width;
  }

  void add_shells(Image8& picture) {
    const std::vector<double> width = shell_widths();
    for (size_t p = 0; p < model_.parts.size(); ++p) {
      const PartInk& own = ink_.parts[p];
      const std::array<int, 2> place = places_[pieces_.size() + p];
      for (int y = 0; y < swatch; ++y)
        for (int x = 0; x < swatch; ++x)
          std::copy(own.rgb.begin(), own.rgb.end(), &picture.at(place[0] + x, place[1] + y));
      if (own.width > 0) add_shell(model_.parts[p], width, place);
    }
  }

  /// Adds the shell of a part, with fewer triangles than the part has.
  void add_shell(const ModelPart& part, const std::vector<double>& width,
                 const std::array<int, 2>& place) {
    numbers_.restart();
    std::vector<std::array<int, 3>> triangles;
    for (int t = part.first_triangle; t < part.end(); ++t)
      triangles.push_back(numbers_.of(model_.triangles[t]));
    std::vector<Point3> positions;
    double least = std::numeric_limits<double>::infinity();
    for (const int v : numbers_.given()) {
      positions.push_back(model_.positions[v]);
      least = std::min(least, width[v]);
    }
    triangles =
        simplify_triangles(positions, triangles,
                           static_cast<size_t>(shell_share * static_cast<double>(triangles.size())),
                           shell_error * least);
    VertexNumbering kept(positions.size());
    const int first = static_cast<int>(mesh_.positions.size());
    for (const std::array<int, 3>& t : triangles) {
      const auto [a, b, c] = kept.of(t);
      mesh_.triangles.push_back({first + c, first + b, first + a});
    }
    for (const int k : kept.given()) {
      const int v = numbers_.given()[k];
      mesh_.positions.push_back(model_.positions[v] + width[v] * model_.normals[v]);
      mesh_.uvs.push_back({place[0] + 0.5 * swatch, place[1] + 0.5 * swatch});
    }
  }

  const ContourInk& ink_;
  const Image8& inked_;
  const Model& model_;
  double scale_;  ///< px of the drawing per px of the canvas
  VertexNumbering numbers_;
  std::vector<Piece> pieces_;
  std::vector<std::array<int, 2>> places_;  ///< of the pieces and of a plain colour for each part
  InkMesh mesh_;
};

}  // namespace

void add_ink(const ContourInk& ink, const Image8& inked, Model& model, Image8& picture) {
  const double drawn = picture.height;
  model.ink = InkBuilder(ink, inked, model).build(picture);
  for (Point2& uv : model.uvs) uv.y *= drawn / picture.height;
  for (Point2& uv : model.ink.uvs) uv = {uv.x / picture.width, uv.y / picture.height};
}

}  // namespace relievo::relief
