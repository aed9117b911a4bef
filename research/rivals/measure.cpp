#include "research/rivals/measure.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "kernel/base/workers.h"
#include "kernel/image/image_size.h"
#include "relief/layers/layered_mesh.h"
#include "seams/seam_chains.h"

namespace relievo::research {
namespace {

constexpr double degrees_per_radian = 180 / 3.14159265358979323846;
constexpr int steps_aside = 8;
constexpr double edges_per_step = 0.5;
/// Cells on a side of the grid for the water.
constexpr int pond_side = 96;

/// Height and slope at the start of a walk.
struct Start {
  double height = 0;
  double slope = 0;
};

/// Fits a parabola to the heights at 1, 2, ... steps; nothing if the surface ends before.
std::optional<Start> look_back(const FrontProbe& probe, Point2 from, Point2 step) {
  Eigen::Matrix<double, steps_aside, 3> powers;
  Eigen::Matrix<double, steps_aside, 1> heights;
  for (int i = 0; i < steps_aside; ++i) {
    const double s = i + 1;
    const auto height = probe.height(from + s * step);
    if (!height) return std::nullopt;
    powers.row(i) << 1, s, s * s;
    heights[i] = *height;
  }
  const Eigen::Vector3d x = powers.colPivHouseholderQr().solve(heights);
  return Start{x[0], x[1] / norm(step)};
}

/// The visible nodes that are far enough from all outlines for a walk.
class SmoothNodes {
 public:
  SmoothNodes(const relief::LayeredMesh& mesh) : mesh_(mesh), seen_(relief::seen_nodes(mesh)) {
    const std::set<int> rims = testing::loose_rims(mesh);
    for (size_t n = 0; n < seen_.size(); ++n) {
      const bool drawn =
          !relief::is_inside(mesh.node_role[n]) || rims.count(static_cast<int>(n)) > 0;
      if (seen_[n] != 0 && drawn) drawn_.push_back(mesh.vertices[mesh.node_vertex[n]]);
    }
  }

  bool contain(int node) const {
    const Point2 at = mesh_.vertices[mesh_.node_vertex[node]];
    const double reach = (steps_aside * edges_per_step + 1) * mesh_.edge_length;
    return seen_[node] != 0 && std::none_of(drawn_.begin(), drawn_.end(),
                                            [&](Point2 p) { return distance(p, at) < reach; });
  }

 private:
  const relief::LayeredMesh& mesh_;
  std::vector<uint8_t> seen_;
  std::vector<Point2> drawn_;
};

void measure_chain(const FrontProbe& probe, const relief::LayeredMesh& mesh,
                   const SmoothNodes& smooth, const testing::SeamChain& chain, Measures& measures) {
  const double total = chain.length.back();
  const auto place = [&](size_t i) { return mesh.vertices[mesh.node_vertex[chain.nodes[i]]]; };
  for (size_t i = 1; i + 1 < chain.nodes.size(); ++i) {
    const bool middle = chain.length[i] >= 0.25 * total && chain.length[i] <= 0.75 * total;
    if (!middle || !smooth.contain(chain.nodes[i])) continue;
    const Point2 along = place(i + 1) - place(i - 1);
    const Point2 across =
        (edges_per_step * mesh.edge_length / norm(along)) * Point2{-along.y, along.x};
    const auto there = look_back(probe, place(i), across);
    const auto here = look_back(probe, place(i), -1 * across);
    if (!there || !here) continue;
    measures.slope_jumps.push_back(degrees_per_radian *
                                   std::abs(std::atan(there->slope) + std::atan(here->slope)));
    measures.height_jumps.push_back(std::abs(there->height - here->height));
  }
}

/// Returns the depth of the deepest water within half of `radius` around the centre. Water runs off
/// outside `radius` and beside the surface.
double deepest_water(const FrontProbe& probe, Point2 middle, double radius) {
  const double cell = 2 * radius / pond_side;
  std::vector<double> ground(pond_side * pond_side, std::numeric_limits<double>::quiet_NaN());
  const auto place = [&](int i) {
    const int row = i / pond_side;
    const int column = i % pond_side;
    return middle + Point2{(column + 0.5) * cell - radius, (row + 0.5) * cell - radius};
  };
  for (int i = 0; i < pond_side * pond_side; ++i)
    if (distance(place(i), middle) < radius)
      if (const auto height = probe.height(place(i))) ground[i] = *height;
  const auto beside = [&](int i, auto visit) {
    const int x = i % pond_side;
    if (x > 0) visit(i - 1);
    if (x + 1 < pond_side) visit(i + 1);
    if (i >= pond_side) visit(i - pond_side);
    if (i + pond_side < pond_side * pond_side) visit(i + pond_side);
  };
  using Level = std::pair<double, int>;
  std::priority_queue<Level, std::vector<Level>, std::greater<>> queue;
  for (int i = 0; i < pond_side * pond_side; ++i) {
    bool drains = false;
    beside(i, [&](int other) { drains = drains || std::isnan(ground[other]); });
    if (drains && !std::isnan(ground[i])) queue.push({ground[i], i});
  }
  std::vector<bool> wet(ground.size(), false);
  double deepest = 0;
  while (!queue.empty()) {
    const double water = queue.top().first;
    const int i = queue.top().second;
    queue.pop();
    if (wet[i]) continue;
    wet[i] = true;
    if (distance(place(i), middle) <= 0.5 * radius) deepest = std::max(deepest, water - ground[i]);
    beside(i, [&](int other) {
      if (!std::isnan(ground[other]) && !wet[other])
        queue.push({std::max(water, ground[other]), other});
    });
  }
  return deepest;
}

/// Makes a flat model of the covered base triangles.
Model drawn_area(const relief::LayeredMesh& mesh, const Model& like) {
  Model model;
  model.width = like.width;
  model.height = like.height;
  for (const Point2 p : mesh.vertices) {
    model.positions.push_back({p.x, like.height - p.y, 0});
    model.normals.push_back({0, 0, 1});
  }
  model.triangles = mesh.triangles;
  return model;
}

template <class T>
T blend(const std::vector<T>& values, const std::array<int, 3>& corners, const RayHit& hit) {
  return (1 - hit.u - hit.v) * values[corners[0]] + hit.u * values[corners[1]] +
         hit.v * values[corners[2]];
}

}  // namespace

Result<Measures> measure(const Model& model, const relief::LayeredMesh& joined, int longest,
                         const RunContext& context) {
  const auto probe = FrontProbe::build(model, context);
  if (!probe) return probe.error();
  const Model area = drawn_area(joined, model);
  const auto drawn = FrontProbe::build(area, context);
  if (!drawn) return drawn.error();
  Measures measures;
  const SmoothNodes smooth(joined);
  const std::vector<uint8_t> seen = relief::seen_nodes(joined);
  for (const testing::SeamChain& chain : testing::seam_chains(joined)) {
    if (context.cancelled()) return interrupted_error();
    measure_chain(*probe, joined, smooth, chain, measures);
    const double total = chain.length.back();
    for (const int end : {chain.nodes.front(), chain.nodes.back()})
      if (seen[end] != 0)
        measures.pits.push_back(
            deepest_water(*probe, joined.vertices[joined.node_vertex[end]], 0.5 * total) / total);
  }
  for (auto* values : {&measures.slope_jumps, &measures.height_jumps, &measures.pits})
    std::sort(values->begin(), values->end());
  const ReliefMaps shown = probe->maps(longest);
  const ReliefMaps wanted = drawn->maps(longest);
  double both = 0;
  double either = 0;
  for (size_t i = 0; i < shown.part.pixels.size(); ++i) {
    const bool a = shown.part.pixels[i] >= 0;
    const bool b = wanted.part.pixels[i] >= 0;
    both += a && b ? 1 : 0;
    either += a || b ? 1 : 0;
  }
  measures.contour_iou = either > 0 ? both / either : 1;
  return measures;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  return sorted[static_cast<size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)))];
}

Result<FrontProbe> FrontProbe::build(const Model& model, const RunContext& context) {
  auto rays = RayScene::build(model, {}, context);
  if (!rays) return rays.error();
  double top = 0;
  for (const Point3 p : model.positions) top = std::max(top, p.z);
  return FrontProbe(model, std::move(*rays), top + 1);
}

std::optional<RayHit> FrontProbe::hit(Point2 canvas) const {
  return rays_.first_hit({canvas.x, model_->height - canvas.y, top_}, {0, 0, -1});
}

std::optional<double> FrontProbe::height(Point2 canvas) const {
  const auto found = hit(canvas);
  if (!found) return std::nullopt;
  return blend(model_->positions, model_->triangles[found->triangle], *found).z;
}

ReliefMaps FrontProbe::maps(int longest) const {
  const ImageSize size = fitted_size(model_->width, model_->height, longest);
  const double pixel = model_->width / size.width;
  ReliefMaps maps{ImageF(size.width, size.height, 1, std::numeric_limits<float>::quiet_NaN()),
                  ImageF(size.width, size.height, 3, 0.0F),
                  Image<int32_t>(size.width, size.height, 1, -1)};
  run_ranges(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < size.width; ++x) {
        const auto found = hit({(x + 0.5) * pixel, (y + 0.5) * pixel});
        Point3 normal{0, 0, 1};
        if (found) {
          const auto& corners = model_->triangles[found->triangle];
          normal = normalized(blend(model_->normals, corners, *found));
          maps.height.at(x, y) = static_cast<float>(blend(model_->positions, corners, *found).z);
          maps.part.at(x, y) = 0;
        }
        maps.normal.at(x, y, 0) = static_cast<float>(normal.x);
        maps.normal.at(x, y, 1) = static_cast<float>(normal.y);
        maps.normal.at(x, y, 2) = static_cast<float>(normal.z);
      }
  });
  return maps;
}

}  // namespace relievo::research
