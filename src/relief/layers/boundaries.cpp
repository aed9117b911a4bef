#include "relief/layers/boundaries.h"

#include <algorithm>

namespace relievo::relief {
namespace {

/// A point of the walk along an outline away from a seam.
struct Step {
  int node;     // of the upper part
  int below;    // node of the lower surface
  double s;     // arc length from the start
  double mass;  // half the length of the two edges at it
};

/// Removes dropped ramps and marks the nodes of the others.
void compact_ramps(const std::vector<bool>& dropped, Boundaries& out) {
  std::vector<int> number(out.ramps.size(), -1);
  std::vector<RobinRamp> ramps;
  for (size_t r = 0; r < out.ramps.size(); ++r) {
    if (r < dropped.size() && dropped[r]) continue;
    number[r] = static_cast<int>(ramps.size());
    ramps.push_back(out.ramps[r]);
  }
  std::vector<RampNode> nodes;
  for (RampNode node : out.ramp_nodes) {
    node.ramp = number[node.ramp];
    if (node.ramp >= 0) nodes.push_back(node);
  }
  out.ramps = std::move(ramps);
  out.ramp_nodes = std::move(nodes);
  for (const RampNode& node : out.ramp_nodes) out.role[node.node] = NodeRole::ramp;
}

class BoundaryFinder {
 public:
  BoundaryFinder(const SheetMesh& mesh, const Scene& scene, bool attach)
      : mesh_(mesh), scene_(scene), attach_(attach) {
    find_roles();
  }

  void lay_automatic_ramps() {
    for (const Seam& seam : mesh_.seams) {
      if (seam.bump) continue;
      if (seam.first_end_inside) lay_from(seam, seam.position, -1);
      if (seam.last_end_inside) lay_from(seam, seam.position + seam.edges, 1);
    }
  }

  void lay_given_ramp(const RobinRange& range, const LoopRun& run) {
    if (run.loop < 0 || run.edges < 1) return;
    const bool from_last = run.reversed;
    const int start = from_last ? run.position + run.edges : run.position;
    std::vector<Step> steps;
    double s = 0;
    for (int i = 0; i < run.edges; ++i) {
      const int at = from_last ? start - i : start + i;
      add_step(range.upper, range.lower, run.loop, at, s, steps);
      s += mesh_.loop_step(run.loop, at, from_last ? -1 : 1);
    }
    drop_ramps_at(steps);
    RobinRamp ramp{range.upper, range.lower, s, range.alpha0.value_or(-1), range.rho.value_or(-1)};
    add_ramp(ramp, steps, mesh_.surface[range.upper] == mesh_.surface[range.lower]);
  }

  Boundaries result() {
    compact_ramps(dropped_, out_);
    return std::move(out_);
  }

 private:
  void find_roles() {
    out_.role.assign(mesh_.node_vertex.size(), NodeRole::interior);
    for (size_t f = 0; f < mesh_.faces.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        if (mesh_.face_across(static_cast<int>(f), k) >= 0) continue;
        const int beyond = mesh_.base.neighbours[mesh_.face_triangle[f]][k];
        const bool flap = mesh_.face_of(beyond, mesh_.face_part[f]) >= 0;
        for (const int corner : {next_place(k), last_place(k)}) {
          NodeRole& role = out_.role[mesh_.faces[f][corner]];
          if (role != NodeRole::outline) role = flap ? NodeRole::flap : NodeRole::outline;
        }
      }
    for (const Seam& seam : mesh_.seams)
      for (int i = seam.bump ? seam.edges + 1 : 0; i <= seam.edges; ++i) {
        if ((i == 0 && !seam.first_end_inside) || (i == seam.edges && !seam.last_end_inside))
          continue;
        const int edge = seam.position + std::min(i, seam.edges - 1);
        const int node = mesh_.outline_node(seam.upper, vertex_at(seam.loop, edge),
                                            vertex_at(seam.loop, edge + 1),
                                            vertex_at(seam.loop, seam.position + i));
        if (node >= 0) out_.role[node] = NodeRole::seam;
      }
  }

  int vertex_at(int loop, int position) const { return mesh_.loops.vertex(loop, position); }

  // The frontmost node at `vertex` of the surface of `lower`, behind `upper`; -1 if there is none.
  int node_below(int vertex, int upper, int lower) const {
    int best = -1;
    int best_part = -1;
    for (const Corner corner : mesh_.base_corners.at(vertex)) {
      const int t = triangle_of(corner);
      for (int f = mesh_.stack_begin[t]; f < mesh_.stack_begin[t + 1]; ++f) {
        const int part = mesh_.face_part[f];
        if (part >= upper || mesh_.surface[part] != mesh_.surface[lower]) continue;
        const int node = mesh_.faces[f][place_of(corner)];
        const bool better =
            part > best_part || (part == best_part && out_.role[best] == NodeRole::flap);
        if (!better) continue;
        best = node;
        best_part = part;
      }
    }
    return best;
  }

  bool add_step(int upper, int lower, int loop, int at, double s, std::vector<Step>& steps) const {
    const int vertex = vertex_at(loop, at);
    int node = mesh_.outline_node(upper, vertex, vertex_at(loop, at + 1), vertex);
    if (node < 0) node = mesh_.outline_node(upper, vertex_at(loop, at - 1), vertex, vertex);
    if (node < 0 || out_.role[node] != NodeRole::outline) return false;
    const double mass = 0.5 * (mesh_.loop_step(loop, at, -1) + mesh_.loop_step(loop, at, 1));
    steps.push_back({node, node_below(vertex, upper, lower), s, mass});
    return true;
  }

  // Walks from a merged end until the exit, another seam, or all the way round. What other parts
  // hide beside the end is a part of the join as it is seen: the ramp begins beyond.
  void lay_from(const Seam& seam, int start, int direction) {
    const int n = static_cast<int>(mesh_.loops.vertices[seam.loop].size());
    std::vector<Step> steps;
    double s = 0;
    double hidden = 0;
    bool exit = false;
    for (int i = 1; i < n; ++i) {
      const int at = start + direction * i;
      s += mesh_.loop_step(seam.loop, at - direction, direction);
      const bool out = comes_out(seam.upper, vertex_at(seam.loop, at));
      if (out) hidden = s;
      if (!add_step(seam.upper, seam.lower, seam.loop, at, s, steps)) {
        if (out) continue;
        break;
      }
      const int below = steps.back().below;
      exit = below < 0 || out_.role[below] == NodeRole::outline;
      if (!exit) continue;
      steps.pop_back();
      break;
    }
    for (Step& step : steps) step.s = std::max(0.0, step.s - hidden);
    double length = s - hidden;
    if (!exit) length = std::min(0.5 * length, seam_length(seam));
    while (!steps.empty() && steps.back().s >= length) steps.pop_back();
    add_ramp({seam.upper, seam.lower, length, -1, -1}, steps, true);
  }

  // Whether the outline of the part comes out there from under a part that grows out of it.
  bool comes_out(int part, int vertex) const {
    const auto here = [&](const Mount& mount) {
      return mount.part == part && mount.vertex == vertex;
    };
    return std::any_of(mesh_.seams.begin(), mesh_.seams.end(), [&](const Seam& seam) {
      return std::any_of(seam.mounts.begin(), seam.mounts.end(), here);
    });
  }

  double seam_length(const Seam& seam) const {
    double length = 0;
    for (int i = 0; i < seam.edges; ++i) length += mesh_.loop_step(seam.loop, seam.position + i, 1);
    return length;
  }

  void add_ramp(const RobinRamp& ramp, const std::vector<Step>& steps, bool glued) {
    if (steps.empty() || ramp.length <= 0) return;
    const int number = static_cast<int>(out_.ramps.size());
    out_.ramps.push_back(ramp);
    for (const Step& step : steps) {
      if (ramp_of(step.node) >= 0) continue;
      set_ramp_of(step.node, number);
      const bool attached = attach_ && glued && has_one_sign(mesh_, scene_, ramp.upper);
      const int below = attached ? step.below : -1;
      out_.ramp_nodes.push_back({step.node, number, below, step.s / ramp.length, step.mass});
      if (glued && step.below >= 0 && out_.role[step.below] != NodeRole::outline)
        out_.glued.push_back({step.below, step.node});
    }
  }

  int ramp_of(int node) const { return ramp_of_.empty() ? -1 : ramp_of_[node]; }
  void set_ramp_of(int node, int ramp) {
    if (ramp_of_.empty()) ramp_of_.assign(mesh_.node_vertex.size(), -1);
    ramp_of_[node] = ramp;
  }

  void drop_ramps_at(const std::vector<Step>& steps) {
    dropped_.resize(out_.ramps.size(), false);
    for (const Step& step : steps)
      if (ramp_of(step.node) >= 0) dropped_[ramp_of(step.node)] = true;
    if (ramp_of_.empty()) return;
    for (int& ramp : ramp_of_)
      if (ramp >= 0 && dropped_[ramp]) ramp = -1;
  }

  const SheetMesh& mesh_;
  const Scene& scene_;
  bool attach_;
  Boundaries out_;
  std::vector<int> ramp_of_;  // per node
  std::vector<bool> dropped_;
};

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

Boundaries find_boundaries(const SheetMesh& mesh, const Scene& scene,
                           const std::vector<LoopRun>& robin_runs, bool attach) {
  BoundaryFinder finder(mesh, scene, attach);
  finder.lay_automatic_ramps();
  for (size_t r = 0; r < scene.robin.size(); ++r)
    finder.lay_given_ramp(scene.robin[r], robin_runs[r]);
  Boundaries boundaries = finder.result();
  boundaries.bump_nodes = find_bump_outlines(mesh, scene, robin_runs, boundaries.ramps);
  return boundaries;
}

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

}  // namespace relievo::relief
