#include "solid/back_paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "solid/paint_behind.h"

namespace relievo {
namespace {

using Colour = std::array<uint8_t, 4>;

constexpr int cell = 8;  ///< px, side of the square of a plain colour
constexpr Colour base_colour{236, 230, 218, 255};

/// Calls visit(area, colour) for a part's triangles, each with the colour in its middle.
template <class Visit>
void for_each_colour(const Model& model, const ModelPart& part, const Image8& rgba, Visit visit) {
  for (int t = part.first_triangle; t < part.end(); ++t) {
    const auto& [a, b, c] = model.triangles[t];
    const Point2 middle = (1.0 / 3) * (model.uvs[a] + model.uvs[b] + model.uvs[c]);
    const Point3 p = model.positions[a];
    const int x = std::clamp(static_cast<int>(middle.x * rgba.width), 0, rgba.width - 1);
    const int y = std::clamp(static_cast<int>(middle.y * rgba.height), 0, rgba.height - 1);
    visit(norm(cross(model.positions[b] - p, model.positions[c] - p)), &rgba.at(x, y));
  }
}

/// Returns the mean colour of a part by area.
Colour mean_colour(const Model& model, const ModelPart& part, const Image8& rgba) {
  std::array<double, 3> sum{};
  double all = 0;
  for_each_colour(model, part, rgba, [&](double area, const uint8_t* here) {
    for (int k = 0; k < 3; ++k) sum[k] += area * here[k];
    all += area;
  });
  if (all == 0) return base_colour;
  Colour colour{0, 0, 0, 255};
  for (int k = 0; k < 3; ++k) colour[k] = static_cast<uint8_t>(std::lround(sum[k] / all));
  return colour;
}

/// Returns the colour of most of a part's area.
Colour most_colour(const Model& model, const ModelPart& part, const Image8& rgba) {
  struct Patch {
    uint32_t rgb;
    double area;
  };
  std::vector<Patch> patches;
  for_each_colour(model, part, rgba, [&](double area, const uint8_t* here) {
    patches.push_back({uint32_t{here[0]} << 16 | uint32_t{here[1]} << 8 | here[2], area});
  });
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.rgb < b.rgb; });
  Colour colour = base_colour;
  double most = 0;
  double sum = 0;
  for (size_t i = 0; i < patches.size(); ++i) {
    const auto [rgb, area] = patches[i];
    sum = i > 0 && patches[i - 1].rgb == rgb ? sum + area : area;
    if (sum <= most) continue;
    most = sum;
    colour = {static_cast<uint8_t>(rgb >> 16), static_cast<uint8_t>(rgb >> 8),
              static_cast<uint8_t>(rgb), 255};
  }
  return colour;
}

/// Adds a cell for each colour below the drawing, row by row; returns their middles.
std::vector<Point2> add_cells(const std::vector<Colour>& colours, Image8& rgba) {
  const int width = rgba.width;
  const int in_row = std::max(1, width / cell);
  const int count = static_cast<int>(colours.size());
  const int rows = (count + in_row - 1) / in_row;
  const int top = rgba.height;
  rgba.height += rows * cell;
  rgba.pixels.reserve(4 * static_cast<size_t>(rgba.height) * width);
  for (int y = 0; y < rows * cell; ++y)
    for (int x = 0; x < width; ++x) {
      const int at = std::min(y / cell * in_row + std::min(x / cell, in_row - 1), count - 1);
      rgba.pixels.insert(rgba.pixels.end(), colours[at].begin(), colours[at].end());
    }
  std::vector<Point2> middles;
  for (int k = 0; k < count; ++k) {
    const int row = k / in_row;
    middles.push_back({(k % in_row + 0.5) * std::min(cell, width) / width,
                       (top + (row + 0.5) * cell) / rgba.height});
  }
  return middles;
}

}  // namespace

BackPaint paint_back(const Drawing& drawing, const relief::VisibleSheet& sheet, BackSide side) {
  if (drawing.rgba.empty()) return {};
  const Model& model = sheet.model;
  const bool pixel_art = drawing.pixel_art > 0;
  // Averages would be colours that pixel art does not have.
  if (side == BackSide::plain && pixel_art) side = BackSide::parts;
  std::vector<Colour> colours;
  if (side == BackSide::parts)
    for (const ModelPart& part : model.parts)
      colours.push_back(pixel_art ? most_colour(model, part, drawing.rgba)
                                  : mean_colour(model, part, drawing.rgba));
  colours.push_back(base_colour);
  BackPaint painted{drawing};
  Image8& rgba = painted.drawing.rgba;
  if (side == BackSide::plain) {
    const Image8 behind = paint_behind(sheet, drawing);
    rgba.pixels.insert(rgba.pixels.end(), behind.pixels.begin(), behind.pixels.end());
    rgba.height += behind.height;
  }
  const double pictured = rgba.height;
  painted.parts = add_cells(colours, rgba);
  painted.plate = painted.parts.back();
  if (side != BackSide::parts) painted.parts.clear();
  painted.shrink = static_cast<double>(drawing.rgba.height) / rgba.height;
  painted.pictured = pictured / rgba.height;
  painted.behind = painted.pictured - painted.shrink;
  return painted;
}

}  // namespace relievo
