#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "relievo/image.h"

namespace relievo::testing {

/// A shape in canvas px.
using Inside = std::function<bool(double x, double y)>;

inline Inside disc(double cx, double cy, double r) {
  return [=](double x, double y) { return (x - cx) * (x - cx) + (y - cy) * (y - cy) < r * r; };
}

inline Inside box(double x0, double y0, double x1, double y1) {
  return [=](double x, double y) { return x > x0 && x < x1 && y > y0 && y < y1; };
}

inline Inside oval(double cx, double cy, double a, double b, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return [=](double x, double y) {
    const double u = (c * (x - cx) + s * (y - cy)) / a;
    const double v = (c * (y - cy) - s * (x - cx)) / b;
    return u * u + v * v < 1;
  };
}

/// Shapes painted back to front; shape k has label k + 1.
inline Image16 painted(int width, int height, const std::vector<Inside>& shapes) {
  Image16 labels(width, height, 1);
  for (size_t k = 0; k < shapes.size(); ++k)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (shapes[k](x + 0.5, y + 0.5)) labels.at(x, y) = static_cast<uint16_t>(k + 1);
  return labels;
}

/// A whole number in [low, high], the same with every library.
inline int draw(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

/// Two to seven ovals and boxes on top of each other, on 96 x 80 px.
inline Image16 random_labels(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Inside> shapes;
  const int count = draw(random, 2, 7);
  for (int k = 0; k < count; ++k) {
    const double cx = draw(random, 15, 80);
    const double cy = draw(random, 15, 65);
    const double a = draw(random, 5, 30);
    const double b = draw(random, 5, 20);
    if (draw(random, 0, 2) == 0)
      shapes.push_back(box(cx - a, cy - b, cx + a, cy + b));
    else
      shapes.push_back(oval(cx, cy, a, b, draw(random, 0, 314) / 100.0));
  }
  return painted(96, 80, shapes);
}

}  // namespace relievo::testing
