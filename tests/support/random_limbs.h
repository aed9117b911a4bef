#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/random_scene.h"

namespace relievo::testing {

/// A limb with round ends.
inline Ring capsule(Point2 root, double angle, double length, double half_width) {
  Ring ring;
  const Point2 along{std::cos(angle), std::sin(angle)};
  const Point2 aside{-along.y, along.x};
  constexpr int steps = 40;
  const auto cap = [&](Point2 centre, double from) {
    for (int i = 0; i <= steps; ++i) {
      const double a = from + M_PI * i / steps;
      ring.push_back(centre + half_width * (std::cos(a) * along + std::sin(a) * aside));
    }
  };
  const auto side = [&](Point2 from, Point2 to) {
    for (int i = 1; i < steps; ++i)
      ring.push_back(from + (static_cast<double>(i) / steps) * (to - from));
  };
  const Point2 tip = root + length * along;
  cap(tip, -M_PI / 2);
  side(tip + half_width * aside, root + half_width * aside);
  cap(root, M_PI / 2);
  side(root - half_width * aside, tip - half_width * aside);
  return ring;
}

/// Joins the limb that was added last with `lower` along the cap of its root.
inline void join_root(Point2 root, double angle, double half_width, int lower, Scene& scene) {
  Join join{static_cast<int>(scene.parts.size()) - 1, lower, {}};
  for (int i = 0; i <= 20; ++i) {
    const double a = angle + M_PI / 2 + M_PI * i / 20;
    join.line.push_back(root + half_width * Point2{std::cos(a), std::sin(a)});
  }
  scene.joins.push_back(join);
}

/// A body that is an ellipse with one or two limbs in front of it that are joined, or a limb on a
/// limb, at any angle, width and depth of reach.
inline Scene random_limbs(uint64_t seed) {
  Random random(seed);
  Scene scene = canvas();
  const double a = random.uniform(60, 110);
  const double b = random.uniform(50, 90);
  scene.parts.push_back(part("body", blob(random, {200, 200}, a, b, random.uniform(0, 0.1)), 4));
  const double half = std::min(a, b);
  const int kind = random.integer(0, 2);  // one limb, two on the body, a limb on a limb
  double angle = random.uniform(0, 2 * M_PI);
  for (int limb = 0; limb < (kind == 0 ? 1 : 2); ++limb) {
    const double width = random.uniform(0.15, 0.4) * half;
    const double depth = random.uniform(0.05, 0.9);  // of what the root can be moved inside
    const double way = depth * std::max(0.0, 0.75 * half - width);
    const Point2 away{std::cos(angle), std::sin(angle)};
    const Point2 root = Point2{200, 200} + (0.8 * half - width - way) * away;
    const double bend = angle + random.uniform(-0.7, 0.7);
    const double length = random.uniform(1.3, 2.0) * half;
    if (limb == 1 && kind == 2) {
      const Point2 tip = scene.parts[1].outline[0][20];
      const Point2 middle = 0.5 * (tip + root);
      const double thin = 0.7 * width * random.uniform(0.5, 1);
      const double turn = bend + random.uniform(0.4, 1.2);
      scene.parts.push_back(
          part("limb1", capsule(middle, turn, length, thin), random.uniform(2, 4)));
      join_root(middle, turn, thin, 1, scene);
      break;
    }
    scene.parts.push_back(part("limb" + std::to_string(limb), capsule(root, bend, length, width),
                               random.uniform(2, 4)));
    join_root(root, bend, width, 0, scene);
    angle += random.uniform(0.6, 2.5);
  }
  return scene;
}

}  // namespace relievo::testing
