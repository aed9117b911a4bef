#include "relief/layers/boundaries.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
namespace {

RobinRamp ramp_of(const RobinRange& range, double length) {
  return {range.upper, range.lower, length, range.alpha0.value_or(-1), range.rho.value_or(-1)};
}

/// Finds the roles of nodes, and the ranges of parts that are no bumps.
class BoundaryFinder {
 public:
  BoundaryFinder(const SheetMesh& mesh, const Scene& scene, bool attach)
      : mesh_(mesh), scene_(scene), attach_(attach), ramp_of_(mesh.node_vertex.size(), -1) {
    find_open_edges();
    find_joins();
  }

  void lay_automatic_ramps() {
    for (const Seam& seam : mesh_.seams) {
      if (seam.bump) continue;
      if (seam.first_end_inside) lay_from(seam, seam.run.position, -1);
      if (seam.last_end_inside) lay_from(seam, seam.run.position + seam.run.edges, 1);
    }
  }

  void lay_given_ramp(const RobinRange& range, const LoopRun& run) {
    if (run.loop < 0 || run.edges < 1) return;
    const int direction = run.reversed ? -1 : 1;
    const int start = run.reversed ? run.position + run.edges : run.position;
    std::vector<RampNode> steps;
    double s = 0;
    for (int i = 0; i < run.edges; ++i) {
      const int at = start + direction * i;
      add_step(range.upper, range.lower, run.loop, at, s, steps);
      s += mesh_.loop_step(run.loop, at, direction);
    }
    drop_ramps_at(steps);
    add_ramp(ramp_of(range, s), steps, mesh_.surface[range.upper] == mesh_.surface[range.lower]);
  }

  Boundaries result() {
    remove_dropped_ramps();
    for (const RampNode& node : out_.ramp_nodes) out_.role[node.node] = NodeRole::ramp;
    return std::move(out_);
  }

 private:
  // Nodes at open edges lie on outlines, or on flap edges if their part continues beyond the edge.
  void find_open_edges() {
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
  }

  void find_joins() {
    for (const Seam& seam : mesh_.seams) {
      const auto& [loop, position, edges, reversed] = seam.run;
      if (seam.bump) continue;
      for (int i = seam.first_end_inside ? 0 : 1; i <= edges - (seam.last_end_inside ? 0 : 1);
           ++i) {
        const int edge = position + std::min(i, edges - 1);
        const int node = mesh_.outline_node(seam.upper, mesh_.loop_vertex(loop, edge),
                                            mesh_.loop_vertex(loop, edge + 1),
                                            mesh_.loop_vertex(loop, position + i));
        if (node >= 0) out_.role[node] = NodeRole::seam;
      }
    }
  }

  // The frontmost node at `vertex` of the surface of `lower`, behind `upper`, or -1.
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

  // Appends the node of the upper part at a position of its loop, with t = s, its arc length in px.
  // Returns false and appends nothing if that node is not on an outline.
  bool add_step(int upper, int lower, int loop, int at, double s,
                std::vector<RampNode>& steps) const {
    const int vertex = mesh_.loop_vertex(loop, at);
    int node = mesh_.outline_node(upper, vertex, mesh_.loop_vertex(loop, at + 1), vertex);
    if (node < 0) node = mesh_.outline_node(upper, mesh_.loop_vertex(loop, at - 1), vertex, vertex);
    if (node < 0 || out_.role[node] != NodeRole::outline) return false;
    const double mass = 0.5 * (mesh_.loop_step(loop, at, -1) + mesh_.loop_step(loop, at, 1));
    steps.push_back({node, -1, node_below(vertex, upper, lower), s, mass});
    return true;
  }

  // Walks from a merged end until the exit, another join, or all the way round. Outline beside the
  // end that a part growing out of the upper one hides looks like part of the join, so the range
  // begins beyond it.
  void lay_from(const Seam& seam, int start, int direction) {
    const int loop = seam.run.loop;
    const int n = static_cast<int>(mesh_.loops[loop].size());
    std::vector<RampNode> steps;
    double s = 0;
    double hidden = 0;
    bool exit = false;
    for (int i = 1; i < n && !exit; ++i) {
      const int at = start + direction * i;
      s += mesh_.loop_step(loop, at - direction, direction);
      const bool out = comes_out(seam.upper, mesh_.loop_vertex(loop, at));
      if (out) hidden = s;
      if (add_step(seam.upper, seam.lower, loop, at, s, steps)) {
        const int below = steps.back().below;
        exit = below < 0 || out_.role[below] == NodeRole::outline;
      } else if (!out) {
        break;
      }
    }
    if (exit) steps.pop_back();
    for (RampNode& step : steps) step.t = std::max(0.0, step.t - hidden);
    double length = s - hidden;
    if (!exit) length = std::min(0.5 * length, mesh_.run_length(seam.run));
    while (!steps.empty() && steps.back().t >= length) steps.pop_back();
    add_ramp({seam.upper, seam.lower, length, -1, -1}, steps, true);
  }

  // Whether the outline of the part comes out at the vertex from behind a part that grows out of
  // it.
  bool comes_out(int part, int vertex) const {
    const std::vector<int>& passed = mesh_.passed[part];
    return std::find(passed.begin(), passed.end(), vertex) != passed.end();
  }

  void add_ramp(const RobinRamp& ramp, const std::vector<RampNode>& steps, bool glued) {
    if (steps.empty() || ramp.length <= 0) return;
    const int number = static_cast<int>(out_.ramps.size());
    const bool attached = attach_ && glued && has_one_sign(mesh_, scene_, ramp.upper);
    out_.ramps.push_back(ramp);
    dropped_.push_back(false);
    for (const RampNode& step : steps) {
      if (ramp_of_[step.node] >= 0) continue;
      ramp_of_[step.node] = number;
      out_.ramp_nodes.push_back(
          {step.node, number, attached ? step.below : -1, step.t / ramp.length, step.mass});
      if (glued && step.below >= 0 && out_.role[step.below] != NodeRole::outline)
        out_.glued.push_back({step.below, step.node, true});
    }
  }

  void drop_ramps_at(const std::vector<RampNode>& steps) {
    for (const RampNode& step : steps)
      if (ramp_of_[step.node] >= 0) dropped_[ramp_of_[step.node]] = true;
    for (int& ramp : ramp_of_)
      if (ramp >= 0 && dropped_[ramp]) ramp = -1;
  }

  void remove_dropped_ramps() {
    std::vector<int> number(out_.ramps.size(), -1);
    int count = 0;
    for (size_t r = 0; r < number.size(); ++r) {
      if (dropped_[r]) continue;
      out_.ramps[count] = out_.ramps[r];
      number[r] = count++;
    }
    out_.ramps.resize(count);
    for (RampNode& node : out_.ramp_nodes) node.ramp = number[node.ramp];
    std::erase_if(out_.ramp_nodes, [](const RampNode& node) { return node.ramp < 0; });
  }

  const SheetMesh& mesh_;
  const Scene& scene_;
  bool attach_;
  Boundaries out_;
  std::vector<bool> dropped_;  // per ramp
  std::vector<int> ramp_of_;   // per node: the range that it lies in, or -1
};

/// One loop of a bump.
class BumpLoop {
 public:
  BumpLoop(const SheetMesh& mesh, int loop)
      : mesh_(mesh),
        loop_(loop),
        size_(static_cast<int>(mesh.loops[loop].size())),
        t_(size_, 1),
        ramp_(size_, -1) {}

  void join(const LoopRun& run) {
    for (int i = 0; i <= run.edges; ++i) t_[wrap(run.position + i)] = 0;
  }

  /// Lays a range beside each end of a join.
  void lay_beside(const Seam& seam, std::vector<RobinRamp>& ramps) {
    const double length = mesh_.run_length(seam.run);
    lay_from(seam, seam.run.position, -1, length, ramps);
    lay_from(seam, seam.run.position + seam.run.edges, 1, length, ramps);
  }

  /// Lays a range of the scene in place of those that it touches.
  void lay_given(const RobinRange& range, const LoopRun& run, std::vector<RobinRamp>& ramps) {
    std::vector<int> touched;
    for (int i = 0; i <= run.edges; ++i) touched.push_back(ramp_[wrap(run.position + i)]);
    for (int i = 0; i < size_; ++i) {
      if (ramp_[i] < 0 || std::find(touched.begin(), touched.end(), ramp_[i]) == touched.end())
        continue;
      ramp_[i] = -1;
      t_[i] = 1;
    }
    const double length = mesh_.run_length(run);
    const int start = run.reversed ? run.position + run.edges : run.position;
    const int direction = run.reversed ? -1 : 1;
    double s = 0;
    for (int i = 0; i <= run.edges; ++i) {
      const int at = wrap(start + direction * i);
      if (t_[at] > 0) set(at, s / length, static_cast<int>(ramps.size()));
      s += mesh_.loop_step(loop_, at, direction);
    }
    ramps.push_back(ramp_of(range, length));
  }

  void append_nodes(std::vector<BumpNode>& nodes) const {
    const int part = mesh_.loop_part[loop_];
    for (int i = 0; i < size_; ++i) {
      const int vertex = mesh_.loop_vertex(loop_, i);
      const int node = mesh_.outline_node(part, vertex, mesh_.loop_vertex(loop_, i + 1), vertex);
      if (node >= 0) nodes.push_back({node, part, ramp_[i], t_[i]});
    }
  }

 private:
  int wrap(int position) const { return ((position % size_) + size_) % size_; }
  void set(int at, double t, int ramp) {
    t_[at] = t;
    ramp_[at] = ramp;
  }

  void lay_from(const Seam& seam, int start, int direction, double length,
                std::vector<RobinRamp>& ramps) {
    double way = 0;  // to the next join, or round to this one
    for (int i = 1; i < size_ && t_[wrap(start + direction * i)] > 0; ++i)
      way += mesh_.loop_step(loop_, start + direction * (i - 1), direction);
    length = std::min(length, 0.5 * way);
    double s = mesh_.loop_step(loop_, start, direction);
    for (int i = 1; i < size_ && s < length; ++i) {
      set(wrap(start + direction * i), s / length, static_cast<int>(ramps.size()));
      s += mesh_.loop_step(loop_, start + direction * i, direction);
    }
    ramps.push_back({seam.upper, seam.lower, length, -1, -1});
  }

  const SheetMesh& mesh_;
  int loop_;
  int size_;
  std::vector<double> t_;  // per position, as in BumpNode
  std::vector<int> ramp_;
};

/// Finds the outlines of all bumps by part, and appends their ranges to `ramps`.
std::vector<BumpNode> find_bump_outlines(const SheetMesh& mesh, const Scene& scene,
                                         const std::vector<LoopRun>& robin_runs,
                                         std::vector<RobinRamp>& ramps) {
  std::vector<BumpNode> nodes;
  for (int loop = 0; loop < static_cast<int>(mesh.loops.size()); ++loop) {
    const int part = mesh.loop_part[loop];
    std::vector<const Seam*> joins;  // of the bump, if the part is one
    for (const Seam& seam : mesh.seams)
      if (seam.bump && seam.upper == part) joins.push_back(&seam);
    if (joins.empty()) continue;
    std::erase_if(joins, [loop](const Seam* seam) { return seam->run.loop != loop; });
    BumpLoop outline(mesh, loop);
    for (const Seam* seam : joins) outline.join(seam->run);
    for (const Seam* seam : joins) outline.lay_beside(*seam, ramps);
    for (size_t r = 0; r < scene.robin.size(); ++r)
      if (scene.robin[r].upper == part && robin_runs[r].loop == loop && robin_runs[r].edges > 0)
        outline.lay_given(scene.robin[r], robin_runs[r], ramps);
    outline.append_nodes(nodes);
  }
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const BumpNode& a, const BumpNode& b) { return a.part < b.part; });
  return nodes;
}

/// Marks the faces behind the upper part of a join; loose ones stay loose.
void mark_behind(const SheetMesh& mesh, const LocalOrder& order, const Seam& seam, Flap kind,
                 std::vector<Flap>& flap) {
  std::vector<uint8_t> reached(mesh.faces.size(), 0);
  std::vector<int> pending;
  const auto take = [&](int face) {
    if (face < 0 || reached[face] != 0 || mesh.face_part[face] >= seam.upper) return;
    const int cover = mesh.face_of(mesh.face_triangle[face], seam.upper);
    if (cover < 0 || (!order.is_usual() && order.place[face] >= order.place[cover])) return;
    reached[face] = 1;
    if (flap[face] != Flap::loose) flap[face] = kind;
    pending.push_back(face);
  };
  for (const int face : seam.covered) take(face);
  while (!pending.empty()) {
    const int face = pending.back();
    pending.pop_back();
    for (int k = 0; k < 3; ++k) take(mesh.face_across(face, k));
  }
}

/// Flags the nodes whose surface, without loose flaps, has an outline, #N.
std::vector<uint8_t> nodes_with_outline(const SheetMesh& mesh, const std::vector<NodeRole>& role,
                                        const std::vector<Flap>& flap) {
  const int nodes = static_cast<int>(role.size());
  DisjointSets pieces(nodes);
  for (size_t f = 0; f < flap.size(); ++f)
    if (flap[f] != Flap::loose)
      for (const int k : {1, 2}) pieces.unite(mesh.faces[f][0], mesh.faces[f][k]);
  std::vector<uint8_t> fixed(role.size(), 0);
  for (int n = 0; n < nodes; ++n)
    if (role[n] == NodeRole::outline || role[n] == NodeRole::ramp) fixed[pieces.find(n)] = 1;
  for (int n = 0; n < nodes; ++n) fixed[n] = fixed[pieces.find(n)];
  return fixed;
}

/// Keeps the loose flaps that are connected to a face. Returns whether there were any.
bool keep_around(const SheetMesh& mesh, int face, std::vector<Flap>& flap) {
  bool any = false;
  std::vector<int> pending = {face};
  while (!pending.empty()) {
    const int at = pending.back();
    pending.pop_back();
    for (int k = 0; k < 3; ++k) {
      const int next = mesh.face_across(at, k);
      if (next < 0 || flap[next] != Flap::loose) continue;
      flap[next] = Flap::kept;
      any = true;
      pending.push_back(next);
    }
  }
  return any;
}

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

std::vector<Flap> find_flaps(const SheetMesh& mesh, const std::vector<NodeRole>& role,
                             const LocalOrder& order, const Scene& scene, bool loose) {
  std::vector<Flap> flap(mesh.faces.size(), Flap::none);
  for (const Seam& seam : mesh.seams)
    mark_behind(mesh, order, seam,
                loose && has_one_sign(mesh, scene, seam.upper) ? Flap::loose : Flap::kept, flap);
  for (bool changed = true; changed;) {
    changed = false;
    const std::vector<uint8_t> fixed = nodes_with_outline(mesh, role, flap);
    for (int f = 0; f < static_cast<int>(flap.size()); ++f)
      if (flap[f] != Flap::loose && fixed[mesh.faces[f][0]] == 0)
        changed = keep_around(mesh, f, flap) || changed;
  }
  return flap;
}

}  // namespace relievo::relief
