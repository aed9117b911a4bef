#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/scenes.h"

namespace relievo::testing {

/// A reproducible stream of numbers, the same on every platform.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed * 2862933555777941757ULL + 3037000493ULL) {}
  double uniform(double low, double high) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * static_cast<double>(state_ >> 11) / 9007199254740992.0;
  }
  int integer(int low, int high) {
    return low + static_cast<int>(uniform(0, 1) * (high - low + 1));
  }

 private:
  uint64_t state_;
};

/// A wobbly ellipse.
inline Ring blob(Random& random, Point2 centre, double rx, double ry, double wobble) {
  const double phase = random.uniform(0, 6.28);
  const double turn = random.uniform(0, 3.14);
  const int lobes = random.integer(2, 5);
  Ring ring;
  for (int i = 0; i < 160; ++i) {
    const double a = 2 * M_PI * i / 160;
    const double r = 1 + wobble * std::sin(lobes * a + phase);
    const Point2 p{rx * r * std::cos(a), ry * r * std::sin(a)};
    ring.push_back({centre.x + p.x * std::cos(turn) - p.y * std::sin(turn),
                    centre.y + p.x * std::sin(turn) + p.y * std::cos(turn)});
  }
  return ring;
}

/// The longest run of the upper outline inside the lower one, shortened at both ends; empty when
/// there is hardly any.
inline std::vector<Point2> inside_run(const Outline& upper, const Outline& lower) {
  const Ring& ring = upper[0];
  const size_t n = ring.size();
  size_t best = 0;
  size_t best_length = 0;
  for (size_t i = 0; i < n; ++i) {
    size_t length = 0;
    while (length < n && contains(lower, ring[(i + length) % n])) ++length;
    if (length > best_length) {
      best = i;
      best_length = length;
    }
  }
  std::vector<Point2> line;
  for (size_t k = best_length / 4; k < best_length - best_length / 4; ++k)
    line.push_back(ring[(best + k) % n]);
  return line.size() >= 6 ? line : std::vector<Point2>();
}

/// A scene of overlapping blobs, some joined with a part behind them, some inflated backwards.
inline Scene random_scene(uint64_t seed) {
  Random random(seed);
  Scene scene = canvas();
  const int count = random.integer(2, 9);
  for (int p = 0; p < count; ++p) {
    const Point2 centre{random.uniform(100, 300), random.uniform(100, 300)};
    const double rx = random.uniform(15, 110);
    const double ry = random.uniform(15, 60);
    Ring ring = blob(random, centre, rx, ry, random.uniform(0, 0.25));
    const double d = random.uniform(0, 1) < 0.15 ? -1 : 1;
    scene.parts.push_back(part("part" + std::to_string(p), ring, random.uniform(1, 4), d));
  }
  for (int upper = 1; upper < count; ++upper) {
    if (random.uniform(0, 1) < 0.4) continue;
    const int lower = random.integer(0, upper - 1);
    std::vector<Point2> line = inside_run(scene.parts[upper].outline, scene.parts[lower].outline);
    if (!line.empty()) scene.joins.push_back({upper, lower, line});
  }
  return scene;
}

/// The scene with every part leaning somehow.
inline Scene leaning(Scene scene, uint64_t seed) {
  Random random(seed);
  for (Part& part : scene.parts) part.lean = {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)};
  return scene;
}

}  // namespace relievo::testing
