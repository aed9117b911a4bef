#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>

#include "io/image/decode_image.h"
#include "relievo/files.h"
#include "understanding/areas/find_basins.h"
#include "understanding/labels/label_basins.h"
#include "understanding/perception/built_in_network.h"
#include "understanding/scene/propose_scene.h"

// Prints the CPU time, of all threads, of segmentation, of a changed stroke, and of completing,
// ordering and joining 15 parts, for drawings of increasing size. Usage: relievo_segmentation
// [DRAWING]; without one, circles.

namespace relievo {
namespace {

constexpr int repetitions = 5;

/// Draws circles of ink with a gap in each, some of them coloured, on paper with grain.
Drawing circles(int side) {
  Drawing drawing{Image8(side, side, 4, 250)};
  const double cell = side / 3.0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double u = x - (std::floor(x / cell) + 0.5) * cell;
      const double v = y - (std::floor(y / cell) + 0.5) * cell;
      const double radius = std::hypot(u, v);
      const bool coloured = static_cast<int>(x / cell) == 1 && radius < 0.4 * cell;
      const bool ink = std::abs(radius - 0.4 * cell) < 3 && (std::abs(u) > 0.04 * cell || v < 0);
      const int grain = (x * 7919 + y * 104729) % 5;
      for (int c = 0; c < 3; ++c) {
        const int paper = coloured ? 120 + 50 * c : 250;
        drawing.rgba.at(x, y, c) = static_cast<uint8_t>(ink ? 30 : paper - grain);
      }
    }
  return drawing;
}

/// Makes fifteen discs in rows of four, each of which hides some of its neighbours.
Image16 pile(int side) {
  Image16 labels(side, side, 1);
  const double cell = side / 4.4;
  for (int part = 0; part < 15; ++part) {
    const double cx = (part % 4 + 0.7) * cell;
    const double cy = (part / 4 + 0.7) * cell;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        if (std::hypot(x - cx, y - cy) < 0.62 * cell)
          labels.at(x, y) = static_cast<uint16_t>(part + 1);
  }
  return labels;
}

double cpu_milliseconds() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Measures the least CPU time of several runs, ms.
double time_of(const std::function<void()>& work) {
  double best = 1e9;
  for (int k = 0; k < repetitions; ++k) {
    const double begin = cpu_milliseconds();
    work();
    best = std::min(best, cpu_milliseconds() - begin);
  }
  return best;
}

/// Prints one line and returns the time per megapixel.
double measure(const Drawing& drawing) {
  const double megapixels = 1e-6 * drawing.rgba.width * drawing.rgba.height;
  Result<understanding::Basins> basins = understanding::find_basins(drawing, built_in_network());
  if (!basins) {
    std::printf("%s\n", to_string(basins.error()).c_str());
    return 0;
  }
  const double x = drawing.rgba.width / 2.0;
  const double y = drawing.rgba.height / 2.0;
  const understanding::Scribbles strokes{
      {"a", "b"},
      {{understanding::ScribbleKind::hard, 0, {{x - 30, y}, {x - 30, y + 20}}, 5},
       {understanding::ScribbleKind::hard, 1, {{x + 30, y}, {x + 30, y + 20}}, 5}}};
  const double find =
      time_of([&] { basins = understanding::find_basins(drawing, built_in_network()); });
  const double label = time_of([&] { (void)understanding::label_basins(*basins, strokes); });
  std::printf("%7.2f MP  basins %7.1f ms/MP  strokes %6.1f ms/MP (%4.1f %%)\n", megapixels,
              find / megapixels, label / megapixels, 100 * label / find);
  return find / megapixels;
}

/// Measures the time per megapixel for the parts of a scene.
double measure_proposal(int side) {
  const Image16 labels = pile(side);
  const double megapixels = 1e-6 * side * side;
  const double time = time_of([&] { (void)understanding::propose_scene(labels); });
  std::printf("%7.2f MP  15 parts completed, ordered, joined %7.1f ms/MP\n", megapixels,
              time / megapixels);
  return time / megapixels;
}

int run(int argc, char** argv) {
  if (argc > 1) {
    const auto bytes = read_file(argv[1]);
    const auto image = bytes ? decode_image(*bytes) : Result<Image8>(bytes.error());
    if (!image) {
      std::printf("%s\n", to_string(image.error()).c_str());
      return 1;
    }
    measure({*image});
    return 0;
  }
  const double small = measure(circles(500));
  for (const int side : {1000, 2000, 4000})
    std::printf("  cost per pixel against the smallest: %.2f\n", measure(circles(side)) / small);
  const double few = measure_proposal(500);
  for (const int side : {1000, 2000})
    std::printf("  cost per pixel against the smallest: %.2f\n", measure_proposal(side) / few);
  return 0;
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) { return relievo::run(argc, argv); }
