#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "relief/finish/draw_in.h"
#include "relief/finish/fill_triangle.h"
#include "relief/finish/find_ink.h"
#include "relief/finish/finish_model.h"
#include "relief/finish/inked_discs.h"
#include "relief/finish/open_outlines.h"

namespace relievo::relief {
namespace {

const Disc ball{{110, 120}, 80};
const Disc nearer{{190, 120}, 60, 1, 90};
constexpr double width = 5;

double radius_of(const Disc& disc, Point2 canvas) {
  return distance({canvas.x, ink_canvas_height - canvas.y}, disc.centre);
}

TEST(FindInk, MeasuresALineInsideASilhouette) {
  const ContourInk ink = find_ink(disc_model({ball}), draw_inked({ball}, width, 0, 2));
  ASSERT_EQ(ink.lines.size(), 1U);
  EXPECT_TRUE(ink.lines[0].closed);
  EXPECT_TRUE(ink.plain.empty());
  EXPECT_NEAR(ink.parts[0].width, width, 0.3);
  EXPECT_EQ(ink.parts[0].rgb, (std::array<uint8_t, 3>{20, 20, 20}));
  for (const OutlinePoint& p : ink.lines[0].points) {
    EXPECT_NEAR(p.inside, width, 0.6);
    EXPECT_EQ(p.outside, 0);
    EXPECT_NEAR(radius_of(ball, p.place), ball.radius, 0.1);
    EXPECT_NEAR(radius_of(ball, p.place + p.out), ball.radius + 1, 0.1);
  }
}

TEST(FindInk, MeasuresALineOnBothSidesOfABorder) {
  const ContourInk ink = find_ink(disc_model({ball, nearer}), draw_inked({ball, nearer}, 3, 2, 2));
  int over = 0;
  for (const InkLine& line : ink.lines)
    for (const OutlinePoint& p : line.points) {
      if (line.part != 1 || radius_of(ball, p.place) > ball.radius - 3 * width) continue;
      ++over;
      EXPECT_NEAR(p.inside, 3, 0.6);
      EXPECT_NEAR(p.outside, 2, 0.6);
    }
  EXPECT_GT(over, 10);
}

TEST(FindInk, HasNoneWhereNoneIsDrawn) {
  const Model model = disc_model({ball, nearer});
  EXPECT_TRUE(find_ink(model, draw_inked({ball, nearer}, 0, 0)).lines.empty());
  EXPECT_TRUE(find_ink(model, {}).lines.empty());
  Drawing squares = draw_inked({ball, nearer}, width, 0);
  squares.pixel_art = 4;
  EXPECT_TRUE(find_ink(model, squares).lines.empty());
}

TEST(FindInk, LinesAreSeenAndLieOnTheirPart) {
  const Model model = disc_model({ball, nearer});
  const ContourInk ink = find_ink(model, draw_inked({ball, nearer}, width, 0));
  for (const InkLine& line : ink.lines)
    for (const OutlinePoint& p : line.points)
      if (line.part == 0) {
        EXPECT_GT(radius_of(nearer, p.place), nearer.radius);
      }
}

TEST(OpenOutlines, RunAroundEveryPartWithThePartOnTheLeft) {
  const Model model = disc_model({ball, nearer});
  const std::vector<OpenOutline> outlines = open_outlines(model);
  ASSERT_EQ(outlines.size(), 2U);
  for (const OpenOutline& outline : outlines) {
    EXPECT_TRUE(outline.closed);
    double area = 0;
    for (size_t i = 0; i < outline.vertices.size(); ++i) {
      const Point3 a = model.positions[outline.vertices[i]];
      const Point3 b = model.positions[outline.vertices[(i + 1) % outline.vertices.size()]];
      area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    const double radius = (outline.part == 0 ? ball : nearer).radius;
    EXPECT_NEAR(area, 3.14159265 * radius * radius, 0.01 * area);
  }
}

TEST(DrawIn, TakesTheOutlineToTheInnerEdgeAndKeepsWhatIsFar) {
  Model model = disc_model({ball});
  const Model before = model;
  const ContourInk ink = find_ink(model, draw_inked({ball}, width, 0, 2));
  draw_in(DrawIn(ink), model);
  double widest = 0;
  for (size_t v = 0; v < model.positions.size(); ++v) {
    const Point3 from = before.positions[v];
    const Point3 to = model.positions[v];
    const double r = radius_of(ball, {from.x, from.y});
    EXPECT_EQ(to.z, from.z);
    if (r < ball.radius - 6 * width) {
      EXPECT_TRUE(to == from);
    }
    if (r > ball.radius - 0.01) {
      EXPECT_NEAR(radius_of(ball, {to.x, to.y}), ball.radius - width, 0.6);
      widest = std::max(widest, distance({from.x, from.y}, {to.x, to.y}));
    }
    EXPECT_NEAR(model.uvs[v].x, to.x / ink_canvas_width, 1e-12);
    EXPECT_NEAR(model.uvs[v].y, 1 - to.y / ink_canvas_height, 1e-12);
  }
  EXPECT_GT(widest, 0.9 * width);
}

/// Twice the area of a triangle in the plane.
double turn_of(const Model& model, const std::array<int, 3>& t) {
  const Point3 a = model.positions[t[0]];
  const Point3 b = model.positions[t[1]];
  const Point3 c = model.positions[t[2]];
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(DrawIn, FoldsNoTriangle) {
  Model model = disc_model({ball, nearer});
  const Model before = model;
  draw_in(DrawIn(find_ink(model, draw_inked({ball, nearer}, width, 0))), model);
  for (const std::array<int, 3>& t : before.triangles)
    if (turn_of(before, t) > 1e-6) {
      EXPECT_GT(turn_of(model, t), 0);
    }
}

TEST(DrawIn, TakesTouchingVerticesAlong) {
  const ContourInk ink = find_ink(disc_model({ball, nearer}), draw_inked({ball, nearer}, width, 0));
  const DrawIn map(ink);
  for (const InkLine& line : ink.lines)
    for (const OutlinePoint& p : line.points)
      EXPECT_LT(distance(map.moved(p.place), p.place - p.inside * p.out), 0.5) << p.place.x;
}

/// Returns the front view of a finished model, by the greatest height at the middles of pixels: 0
/// nothing, 1 paint, 2 ink.
Image8 front_of(const Model& model, ImageSize size) {
  Image8 shown(size.width, size.height, 1);
  ImageF height(size.width, size.height, 1, -1e9F);
  const auto add = [&](const std::vector<Point3>& positions, const std::array<int, 3>& t,
                       uint8_t kind) {
    std::array<Point2, 3> corners;
    for (size_t k = 0; k < 3; ++k)
      corners[k] = {positions[t[k]].x / model.width * size.width,
                    (1 - positions[t[k]].y / model.height) * size.height};
    const auto [a, b, c] = corners;
    const double area = cross(b - a, c - a);
    // Lines are seen from one side alone; y points down here.
    if (kind == 2 && area >= 0) return;
    for_each_pixel_inside(corners, size, [&, a = a, b = b, c = c](int x, int y) {
      const Point2 p{x + 0.5, y + 0.5};
      const double v = cross(p - a, c - a) / area;
      const double w = cross(b - a, p - a) / area;
      const auto z = static_cast<float>((1 - v - w) * positions[t[0]].z + v * positions[t[1]].z +
                                        w * positions[t[2]].z);
      if (z < height.at(x, y)) return;
      height.at(x, y) = z;
      shown.at(x, y) = kind;
    });
  };
  for (const auto& t : model.triangles) add(model.positions, t, 1);
  for (const auto& t : model.ink.triangles) add(model.ink.positions, t, 2);
  return shown;
}

TEST(InkMesh, RibbonsFillTheContoursSeenFromTheFront) {
  const Drawing drawing = draw_inked({ball, nearer}, 3, 2, 2);
  const DrawnModel drawn = finish_model(disc_model({ball, nearer}), drawing, Ink::shell);
  const ImageSize size{drawing.rgba.width, drawing.rgba.height};
  const Image8 shown = front_of(drawn.model, size);
  const auto expected = [&](int x, int y) {
    const uint8_t* rgba = &drawing.rgba.at(x, y);
    return rgba[3] == 0 ? 0 : rgba[0] < 100 ? 2 : 1;
  };
  int wrong = 0;
  int all = 0;
  for (int y = 1; y + 1 < size.height; ++y)
    for (int x = 1; x + 1 < size.width; ++x) {
      const int here = expected(x, y);
      if (here != expected(x - 1, y) || here != expected(x + 1, y) || here != expected(x, y - 1) ||
          here != expected(x, y + 1))
        continue;
      all += here == 2 ? 1 : 0;
      wrong += shown.at(x, y) == here ? 0 : 1;
    }
  // Lines that meet leave some pixels between them.
  EXPECT_LT(wrong, 0.02 * all);
}

TEST(InkMesh, PaintHoldsNoInk) {
  const Drawing drawing = draw_inked({ball, nearer}, 3, 2, 2);
  const DrawnModel drawn = finish_model(disc_model({ball, nearer}), drawing, Ink::shell);
  const Image8& picture = drawn.drawing.rgba;
  double dark = 0;
  double all = 0;
  for (const auto& t : drawn.model.triangles)
    for (const int v : t) {
      const Point2 uv = drawn.model.uvs[v];
      const int x = std::clamp(static_cast<int>(uv.x * picture.width), 0, picture.width - 1);
      const int y = std::clamp(static_cast<int>(uv.y * picture.height), 0, picture.height - 1);
      dark += picture.at(x, y) < 150 ? 1 : 0;
      ++all;
    }
  // Some is left where lines meet.
  EXPECT_LT(dark, 0.01 * all);
}

TEST(InkMesh, ColoursAreThoseOfTheLines) {
  const DrawnModel drawn =
      finish_model(disc_model({ball, nearer}), draw_inked({ball, nearer}, 3, 2, 2), Ink::shell);
  const Image8& picture = drawn.drawing.rgba;
  int dark = 0;
  for (const auto& t : drawn.model.ink.triangles) {
    Point2 uv;
    for (const int v : t) uv = uv + (1.0 / 3) * drawn.model.ink.uvs[v];
    ASSERT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
    if (picture.at(static_cast<int>(uv.x * picture.width),
                   static_cast<int>(uv.y * picture.height)) < 100)
      ++dark;
  }
  EXPECT_GT(dark, 0.99 * static_cast<double>(drawn.model.ink.triangles.size()));
}

TEST(InkMesh, AShellSurroundsTheSurfaceAndShowsItsBack) {
  const DrawnModel drawn =
      finish_model(disc_model({ball}), draw_inked({ball}, width, 0, 2), Ink::shell);
  const Model& model = drawn.model;
  const Point3 centre{ball.centre.x, ink_canvas_height - ball.centre.y, 0};
  size_t shell = 0;
  for (const auto& t : model.ink.triangles) {
    const Point3 a = model.ink.positions[t[0]];
    const Point3 normal = cross(model.ink.positions[t[1]] - a, model.ink.positions[t[2]] - a);
    if (std::abs(a.z) < 1) continue;
    ++shell;
    EXPECT_LT(dot(normal, a - centre), 0);
    EXPECT_NEAR(norm(a - centre), ball.radius + 0.5 * width, 0.5 * width + 0.5);
  }
  EXPECT_GT(shell, 100U);
  EXPECT_LT(model.ink.triangles.size(), 0.6 * static_cast<double>(model.triangles.size()));
}

TEST(InkMesh, NoneKeepsTheSurfaceAndTakesTheInkOff) {
  const Model model = disc_model({ball});
  const DrawnModel drawn = finish_model(model, draw_inked({ball}, width, 0), Ink::none);
  EXPECT_TRUE(drawn.model.positions == model.positions);
  EXPECT_TRUE(drawn.model.ink.triangles.empty());
  for (int y = 0; y < ink_canvas_height; ++y)
    for (int x = 0; x < ink_canvas_width; ++x)
      if (distance({x + 0.5, y + 0.5}, ball.centre) < ball.radius) {
        ASSERT_EQ(drawn.drawing.rgba.at(x, y), 200) << x << ' ' << y;
      }
}

TEST(InkMesh, PaintIsAsDrawn) {
  const DrawnModel drawn =
      finish_model(disc_model({ball}), draw_inked({ball}, width, 0), Ink::paint);
  EXPECT_TRUE(drawn.model.ink.triangles.empty());
  EXPECT_EQ(drawn.drawing.rgba.at(110, 42), 20);
}

}  // namespace
}  // namespace relievo::relief
