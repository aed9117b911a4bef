#include "relief/layers/bump_outlines.h"

#include <algorithm>

namespace relievo {
namespace {

/// One loop of a bump.
class BumpLoop {
 public:
  BumpLoop(const SheetMesh& mesh, int loop)
      : mesh_(mesh),
        loop_(loop),
        size_(static_cast<int>(mesh.loops.vertices[loop].size())),
        t_(size_, 1),
        ramp_(size_, -1) {}

  void join(const Seam& seam) {
    for (int i = 0; i <= seam.edges; ++i) t_[wrap(seam.position + i)] = 0;
  }

  /// Beside the join, both ways.
  void loosen(const Seam& seam, std::vector<RobinRamp>& ramps) {
    double length = 0;
    for (int i = 0; i < seam.edges; ++i) length += step(seam.position + i, 1);
    loosen_from(seam, seam.position, -1, length, ramps);
    loosen_from(seam, seam.position + seam.edges, 1, length, ramps);
  }

  void give(const RobinRange& range, const LoopRun& run, std::vector<RobinRamp>& ramps) {
    std::vector<int> touched;
    for (int i = 0; i <= run.edges; ++i) touched.push_back(ramp_[wrap(run.position + i)]);
    for (int i = 0; i < size_; ++i) {
      if (ramp_[i] < 0 || std::find(touched.begin(), touched.end(), ramp_[i]) == touched.end())
        continue;
      ramp_[i] = -1;
      t_[i] = 1;
    }
    double length = 0;
    for (int i = 0; i < run.edges; ++i) length += step(run.position + i, 1);
    const int start = run.reversed ? run.position + run.edges : run.position;
    const int direction = run.reversed ? -1 : 1;
    double s = 0;
    for (int i = 0; i <= run.edges; ++i) {
      const int at = wrap(start + direction * i);
      if (t_[at] > 0) set(at, s / length, static_cast<int>(ramps.size()));
      s += step(at, direction);
    }
    ramps.push_back(
        {range.upper, range.lower, length, range.alpha0.value_or(-1), range.rho.value_or(-1)});
  }

  void append_nodes(std::vector<BumpNode>& nodes) const {
    const int part = mesh_.loops.part[loop_];
    for (int i = 0; i < size_; ++i) {
      const int vertex = vertex_at(i);
      const int node = mesh_.outline_node(part, vertex, vertex_at(i + 1), vertex);
      if (node >= 0) nodes.push_back({node, part, ramp_[i], t_[i]});
    }
  }

 private:
  int wrap(int position) const { return ((position % size_) + size_) % size_; }
  int vertex_at(int position) const { return mesh_.loops.vertex(loop_, position); }
  double step(int position, int direction) const {
    return mesh_.loop_step(loop_, position, direction);
  }
  void set(int at, double t, int ramp) {
    t_[at] = t;
    ramp_[at] = ramp;
  }

  void loosen_from(const Seam& seam, int start, int direction, double length,
                   std::vector<RobinRamp>& ramps) {
    double way = 0;  // to the next join, or round to this one
    for (int i = 1; i < size_ && t_[wrap(start + direction * i)] > 0; ++i)
      way += step(start + direction * (i - 1), direction);
    length = std::min(length, 0.5 * way);
    double s = step(start, direction);
    for (int i = 1; i < size_ && s < length; ++i) {
      set(wrap(start + direction * i), s / length, static_cast<int>(ramps.size()));
      s += step(start + direction * i, direction);
    }
    ramps.push_back({seam.upper, seam.lower, length, -1, -1});
  }

  const SheetMesh& mesh_;
  int loop_;
  int size_;
  std::vector<double> t_;
  std::vector<int> ramp_;
};

}  // namespace

std::vector<BumpNode> find_bump_outlines(const SheetMesh& mesh, const Scene& scene,
                                         const std::vector<LoopRun>& robin_runs,
                                         std::vector<RobinRamp>& ramps) {
  const std::vector<Seam>& seams = mesh.seams;
  std::vector<BumpNode> nodes;
  for (int loop = 0; loop < static_cast<int>(mesh.loops.part.size()); ++loop) {
    const int part = mesh.loops.part[loop];
    const auto on_bump = [&](const Seam& seam) { return seam.bump && seam.upper == part; };
    if (std::none_of(seams.begin(), seams.end(), on_bump)) continue;
    BumpLoop outline(mesh, loop);
    for (const Seam& seam : seams)
      if (on_bump(seam) && seam.loop == loop) outline.join(seam);
    for (const Seam& seam : seams)
      if (on_bump(seam) && seam.loop == loop) outline.loosen(seam, ramps);
    for (size_t r = 0; r < scene.robin.size(); ++r)
      if (scene.robin[r].upper == part && robin_runs[r].loop == loop && robin_runs[r].edges > 0)
        outline.give(scene.robin[r], robin_runs[r], ramps);
    outline.append_nodes(nodes);
  }
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const BumpNode& a, const BumpNode& b) { return a.part < b.part; });
  return nodes;
}

}  // namespace relievo
