#include "relief/layers/connect_sheets.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

namespace relievo::relief {
namespace {

/// Edges that a join needs inside the lower part: with fewer no node lies between its ends.
constexpr int min_seam_edges = 3;

std::string name_of(const Scene& scene, size_t j) {
  const Join& join = scene.joins[j];
  return to_string(Culprit{CulpritList::joins, j}) + " (\"" + scene.parts[join.upper].id +
         "\" to \"" + scene.parts[join.lower].id + "\")";
}

/// Finds the longest stretch [first, last) of path edges with a face below.
std::pair<int, int> longest_run(const std::vector<int>& below) {
  std::pair<int, int> best{0, 0};
  const int n = static_cast<int>(below.size());
  for (int i = 0; i < n; ++i) {
    int j = i;
    while (j < n && below[j] >= 0) ++j;
    if (j - i > best.second - best.first) best = {i, j};
    i = std::max(i, j);
  }
  return best;
}

/// Lists the faces met when turning around `vertex` on the surface, from `face` away from the edge
/// to `from` until the edge to `until`, or all the way round if that is -1. Sets `complete` if the
/// turn reached `until` or closed.
std::vector<int> turn(const SheetMesh& mesh, int face, int vertex, int from, int until,
                      bool& complete) {
  std::vector<int> fan = {face};
  complete = false;
  while (true) {
    const Triangle& corners = mesh.base.triangles[mesh.face_triangle[face]];
    const int at = place_of_node(corners, vertex);
    const int a = next_place(at);
    const int b = last_place(at);
    const int away = corners[a] == from ? b : a;  // end of the edge that we leave through
    if (corners[away] == until) {
      complete = true;
      return fan;
    }
    const int next = mesh.face_across(face, away == a ? b : a);
    if (next < 0) return fan;
    if (std::find(fan.begin(), fan.end(), next) != fan.end()) {
      complete = next == fan.front();
      return fan;
    }
    from = corners[away];
    face = next;
    fan.push_back(face);
  }
}

/// Corners of faces with their new nodes.
using Moves = std::vector<std::pair<Corner, int>>;

/// Gives all faces of the fan around `vertex` the node `node` there.
void move_all(const SheetMesh& mesh, const std::vector<int>& fan, int vertex, int node,
              Moves& moves) {
  for (const int face : fan) {
    const Triangle& corners = mesh.base.triangles[mesh.face_triangle[face]];
    moves.emplace_back(corner_of(face, place_of_node(corners, vertex)), node);
  }
}

/// Returns whether each edge of the face has no other face on the same side and at most one across.
bool has_plain_edges(const SheetMesh& mesh, int face) {
  const int t = mesh.face_triangle[face];
  const Triangle& own = mesh.faces[face];
  const auto stack_of = [&mesh](int triangle) {
    return std::span(mesh.faces)
        .subspan(mesh.stack_begin[triangle],
                 mesh.stack_begin[triangle + 1] - mesh.stack_begin[triangle]);
  };
  for (int k = 0; k < 3; ++k) {
    const int a = next_place(k);
    const int b = last_place(k);
    int beside = 0;
    for (const Triangle& other : stack_of(t)) beside += other[a] == own[a] && other[b] == own[b];
    int across = 0;
    if (const int next = mesh.base.neighbours[t][k]; next >= 0) {
      const int corner = place_of_node(mesh.base.neighbours[next], t);
      for (const Triangle& other : stack_of(next)) across += share_edge(own, k, other, corner);
    }
    if (beside > 1 || across > 1) return false;
  }
  return true;
}

/// Makes the surfaces of two parts one, under the lower of their numbers.
void unite(int a, int b, std::vector<int>& surfaces) {
  const int low = std::min(surfaces[a], surfaces[b]);
  const int high = std::max(surfaces[a], surfaces[b]);
  for (int& surface : surfaces)
    if (surface == high) surface = low;
}

class Connector {
 public:
  Connector(const Scene& scene, SheetMesh& mesh) : scene_(scene), mesh_(mesh) {
    const size_t part_count = scene.parts.size();
    mesh.passed.resize(part_count);
    mesh.surface.resize(part_count);
    std::iota(mesh.surface.begin(), mesh.surface.end(), 0);
    dropped_.assign(mesh.faces.size(), 0);
    faces_of_.resize(part_count);
    for (size_t f = 0; f < mesh.faces.size(); ++f)
      faces_of_[mesh.face_part[f]].push_back(static_cast<int>(f));
  }

  Status connect(size_t j, const LoopRun& run) {
    path_ = mesh_.run_vertices(run);
    upper_ = scene_.joins[j].upper;
    lower_ = scene_.joins[j].lower;
    find_sides();
    below_.clear();
    for (const int t : outer_) below_.push_back(face_below(t));
    const auto [first, last] = longest_run(below_);
    if (last - first < min_seam_edges)
      return Error{ErrorCode::bad_input,
                   "the join hardly runs inside the lower part; move it inwards or remove it",
                   name_of(scene_, j),
                   {CulpritList::joins, j}};
    if (last - first < static_cast<int>(outer_.size()))
      warnings_.push_back(name_of(scene_, j) +
                          ": only the part of the join inside the lower part is used");
    follow(first, last);
    Seam seam;
    seam.upper = upper_;
    seam.lower = lower_;
    seam.run = {run.loop, run.position + first, last - first};
    if (is_bump())
      replace_below(std::move(seam));
    else if (!reconnect(std::move(seam), first, last))
      return Error{ErrorCode::bad_input,
                   "three surfaces would meet along the join; move it away from the other joins of "
                   "these parts or remove one of them",
                   name_of(scene_, j),
                   {CulpritList::joins, j}};
    unite(upper_, lower_, mesh_.surface);
    return Done{};
  }

  std::vector<std::string> finish() {
    const std::vector<int> number = drop_faces(dropped_, mesh_);
    for (Seam& seam : mesh_.seams) {
      for (int& face : seam.covered) face = number[face];
      std::erase(seam.covered, -1);
    }
    return std::move(warnings_);
  }

 private:
  // Finds the triangle beside each path edge that the upper part covers, and the one that it does
  // not; both -1 if the edge is not on the upper part's outline.
  void find_sides() {
    inner_.clear();
    outer_.clear();
    for (size_t i = 0; i + 1 < path_.size(); ++i) {
      int inner = mesh_.triangle_left_of(path_[i], path_[i + 1]);
      int outer = mesh_.triangle_left_of(path_[i + 1], path_[i]);
      if (mesh_.face_of(inner, upper_) < 0) std::swap(inner, outer);
      const bool outline = mesh_.face_of(inner, upper_) >= 0 && mesh_.face_of(outer, upper_) < 0;
      inner_.push_back(outline ? inner : -1);
      outer_.push_back(outline ? outer : -1);
    }
  }

  // The frontmost face of the lower surface behind the upper part over a triangle, or -1.
  int face_below(int t) const {
    if (t < 0) return -1;
    int below = -1;
    for (int f = mesh_.stack_begin[t]; f < mesh_.stack_begin[t + 1]; ++f)
      if (mesh_.face_part[f] < upper_ && dropped_[f] == 0 &&
          mesh_.surface[mesh_.face_part[f]] == mesh_.surface[lower_])
        below = f;
    return below;
  }

  // Whether the lower part lies behind all of the upper one and continues around it. A part that
  // was joined before is a bump only on the surface that it is a bump on already.
  bool is_bump() const {
    if (mesh_.surface[upper_] != upper_)
      return mesh_.surface[upper_] == mesh_.surface[lower_] &&
             std::any_of(mesh_.seams.begin(), mesh_.seams.end(),
                         [&](const Seam& seam) { return seam.upper == upper_ && seam.bump; });
    for (const int face : faces_of_[upper_]) {
      const int t = mesh_.face_triangle[face];
      if (!is_next_below(t)) return false;
      for (const int next : mesh_.base.neighbours[t])
        if (mesh_.face_of(next, upper_) < 0 && !is_next_below(next)) return false;
    }
    return true;
  }

  bool is_next_below(int t) const {
    const int below = face_below(t);
    return below >= 0 && mesh_.face_part[below] == lower_;
  }

  void replace_below(Seam seam) {
    seam.bump = true;
    mesh_.seams.push_back(std::move(seam));
    if (mesh_.surface[upper_] != upper_) return;
    for (const int face : faces_of_[upper_]) {
      const int below = face_below(mesh_.face_triangle[face]);
      mesh_.faces[face] = mesh_.faces[below];
      mesh_.face_source[face] = mesh_.face_source[below];
      mesh_.faces[below] = {-1, -1, -1};  // no longer connected to anything
      dropped_[below] = 1;
    }
  }

  // Walks along the path on the surface, outwards from an edge where the lower part itself is
  // visible, so that the faces below neighbouring edges are connected.
  void follow(int first, int last) {
    int start = (first + last) / 2;
    if (mesh_.face_part[below_[start]] != lower_)
      for (int i = first; i < last; ++i)
        if (mesh_.face_part[below_[i]] == lower_) start = i;
    for (int i = start; i + 1 < last; ++i) carry(i, i + 1);
    for (int i = start; i > first; --i) carry(i, i - 1);
  }

  // Replaces the face below edge j by the one that the surface below edge i leads to, unless a part
  // of the surface begins in front of that: then the visible surface continues on that part.
  void carry(int i, int j) {
    const int from = path_[j > i ? i : i + 1];
    const int until = path_[j > i ? j + 1 : j];
    bool complete = false;
    const int reached = turn(mesh_, below_[i], path_[std::max(i, j)], from, until, complete).back();
    if (complete && mesh_.face_part[below_[j]] <= mesh_.face_part[reached]) below_[j] = reached;
  }

  int upper_node(int i, int vertex) const {
    return mesh_.node_at(mesh_.face_of(inner_[i], upper_), vertex);
  }

  // Cuts and reconnects along path edges first to last. Returns whether no edge has got more than
  // two faces.
  bool reconnect(Seam seam, int first, int last) {
    Moves moves;
    for (int i = first + 1; i < last; ++i) {
      const int vertex = path_[i];
      const int node = upper_node(i, vertex);
      bool onwards = false;
      bool back = false;
      const std::vector<int> fan =
          turn(mesh_, below_[i - 1], vertex, path_[i - 1], path_[i + 1], onwards);
      const std::vector<int> other =
          turn(mesh_, below_[i], vertex, path_[i + 1], path_[i - 1], back);
      if (onwards && fan.back() != below_[i]) {
        merge_end(i - 1, vertex, path_[i - 1], moves);
        move_all(mesh_, other, vertex, node, moves);
        mesh_.passed[mesh_.face_part[below_[i]]].push_back(vertex);
      } else if (back && other.back() != below_[i - 1]) {
        merge_end(i, vertex, path_[i + 1], moves);
        move_all(mesh_, fan, vertex, node, moves);
        mesh_.passed[mesh_.face_part[below_[i - 1]]].push_back(vertex);
      } else {
        move_all(mesh_, fan, vertex, node, moves);
        if (!onwards) move_all(mesh_, other, vertex, node, moves);
      }
    }
    seam.covered = covered_faces(first, last);
    seam.first_end_inside = merge_end(first, path_[first], path_[first + 1], moves);
    seam.last_end_inside = merge_end(last - 1, path_[last], path_[last - 1], moves);
    for (const auto& [corner, node] : moves)
      mesh_.faces[triangle_of(corner)][place_of(corner)] = node;
    mesh_.seams.push_back(std::move(seam));
    return std::all_of(moves.begin(), moves.end(), [&](const auto& move) {
      return has_plain_edges(mesh_, triangle_of(move.first));
    });
  }

  // The faces connected to those below across path edges first to last, before the cut.
  std::vector<int> covered_faces(int first, int last) const {
    std::vector<int> faces;
    for (int i = first; i < last; ++i) {
      const auto& corners = mesh_.base.triangles[outer_[i]];
      int opposite = 0;
      while (corners[opposite] == path_[i] || corners[opposite] == path_[i + 1]) ++opposite;
      const int face = mesh_.face_across(below_[i], opposite);
      if (face >= 0) faces.push_back(face);
    }
    return faces;
  }

  // Re-attaches the whole turn around an end. If the turn is not closed, the end lies on an outline
  // and only the faces reached from the outer side move. Returns whether it is closed.
  bool merge_end(int edge, int vertex, int along, Moves& moves) const {
    bool closed = false;
    move_all(mesh_, turn(mesh_, below_[edge], vertex, along, -1, closed), vertex,
             upper_node(edge, vertex), moves);
    return closed;
  }

  const Scene& scene_;
  SheetMesh& mesh_;
  std::vector<std::string> warnings_;
  std::vector<uint8_t> dropped_;            // per face: replaced by a bump's
  std::vector<std::vector<int>> faces_of_;  // per part
  int upper_ = -1;
  int lower_ = -1;
  std::vector<int> path_;   // vertices of the join
  std::vector<int> inner_;  // per edge of the path, as found by find_sides
  std::vector<int> outer_;
  std::vector<int> below_;  // per edge: face of the lower surface over the outer triangle, or -1
};

}  // namespace

Result<std::vector<std::string>> connect_sheets(const Scene& scene,
                                                const std::vector<LoopRun>& runs, SheetMesh& mesh) {
  const std::vector<Join>& joins = scene.joins;
  for (size_t j = 0; j < joins.size(); ++j)
    if (runs[j].loop < 0)
      return Error{ErrorCode::bad_input,
                   "the outline collapses along the join; use a finer mesh",
                   name_of(scene, j),
                   {CulpritList::joins, j}};
  std::vector<size_t> order(joins.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return joins[a].upper < joins[b].upper; });
  Connector connector(scene, mesh);
  for (const size_t j : order)
    if (Status status = connector.connect(j, runs[j]); !status) return status.error();
  return connector.finish();
}

}  // namespace relievo::relief
