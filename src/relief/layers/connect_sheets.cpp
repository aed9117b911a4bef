#include "relief/layers/connect_sheets.h"

#include <algorithm>
#include <numeric>

namespace relievo::relief {
namespace {

constexpr int min_seam_edges = 3;

Seam seam_of(const JoinPath& join, int first, int last) {
  Seam seam;
  seam.upper = join.upper;
  seam.lower = join.lower;
  seam.loop = join.loop;
  seam.position = join.position + first;
  seam.edges = last - first;
  return seam;
}

/// The longest stretch of path edges with a face below, as [first, last).
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

/// The faces met when turning around `vertex` from `face`, away from the edge to `from`, until
/// the edge to `until` (or -1: all the way), staying on the surface; complete is set where
/// `until` was reached or the turn closed.
std::vector<int> turn(const SheetMesh& mesh, int face, int vertex, int from, int until,
                      bool& complete) {
  std::vector<int> fan = {face};
  complete = false;
  while (true) {
    const Triangle& corners = mesh.base.triangles[mesh.face_triangle[face]];
    const int at = place_of_node(corners, vertex);
    const int a = next_place(at);
    const int b = last_place(at);
    const int away = corners[a] == from ? b : a;  // corner of the edge that we leave through
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

/// Corners of faces with the nodes that they get.
using Moves = std::vector<std::pair<Corner, int>>;

/// All faces of the fan around `vertex` get `node` there.
void move_all(const SheetMesh& mesh, const std::vector<int>& fan, int vertex, int node,
              Moves& moves) {
  for (const int face : fan) {
    const Triangle& corners = mesh.base.triangles[mesh.face_triangle[face]];
    moves.emplace_back(corner_of(face, place_of_node(corners, vertex)), node);
  }
}

/// Both surfaces are one, named by the lower of their numbers.
void unite(int a, int b, std::vector<int>& surfaces) {
  const int low = std::min(surfaces[a], surfaces[b]);
  const int high = std::max(surfaces[a], surfaces[b]);
  for (int& surface : surfaces)
    if (surface == high) surface = low;
}

class Connector {
 public:
  Connector(int part_count, SheetMesh& mesh) : mesh_(mesh) {
    mesh.surface.resize(part_count);
    std::iota(mesh.surface.begin(), mesh.surface.end(), 0);
    dropped_.assign(mesh.faces.size(), 0);
    faces_of_.resize(part_count);
    for (size_t f = 0; f < mesh.faces.size(); ++f)
      faces_of_[mesh.face_part[f]].push_back(static_cast<int>(f));
  }

  Status connect(const JoinPath& join) {
    path_ = join.vertices;
    upper_ = join.upper;
    find_sides();
    find_surface(join);
    const auto [first, last] = longest_run(below_);
    if (last - first < min_seam_edges)
      return Error{ErrorCode::bad_input,
                   "the join hardly runs inside the lower part; move it inwards or remove it",
                   join.name, join.culprit};
    if (last - first < static_cast<int>(outer_.size()))
      warnings_.push_back(join.name + ": only the part of the join inside the lower part is used");
    follow(join, first, last);
    if (is_bump(join))
      replace_below(join, first, last);
    else if (!reconnect(join, first, last))
      return Error{ErrorCode::bad_input,
                   "three surfaces would meet along the join; move it away from the other joins of "
                   "these parts or remove one of them",
                   join.name, join.culprit};
    unite(join.upper, join.lower, mesh_.surface);
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
  // Per path edge the triangles on the side that the upper part covers and on the other.
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

  bool same_surface(int part, int lower) const {
    return mesh_.surface[part] == mesh_.surface[lower];
  }

  // Per path edge the frontmost face of the lower surface on the outer side, or -1.
  void find_surface(const JoinPath& join) {
    below_.assign(outer_.size(), -1);
    for (size_t i = 0; i < outer_.size(); ++i) below_[i] = face_below(outer_[i], join);
  }

  // The frontmost face of the lower surface behind the upper part over a triangle, or -1.
  int face_below(int t, const JoinPath& join) const {
    if (t < 0) return -1;
    int below = -1;
    for (int f = mesh_.stack_begin[t]; f < mesh_.stack_begin[t + 1]; ++f)
      if (mesh_.face_part[f] < upper_ && dropped_[f] == 0 &&
          same_surface(mesh_.face_part[f], join.lower))
        below = f;
    return below;
  }

  // Whether the lower part lies under all of the upper one and on around it. A part that was joined
  // to other surfaces before, or to this one as no bump, is none.
  bool is_bump(const JoinPath& join) const {
    if (mesh_.surface[upper_] != upper_) return is_bump_already(join);
    for (const int face : faces_of_[upper_]) {
      const int t = mesh_.face_triangle[face];
      if (!is_next_below(t, join)) return false;
      for (const int next : mesh_.base.neighbours[t])
        if (mesh_.face_of(next, upper_) < 0 && !is_next_below(next, join)) return false;
    }
    return true;
  }

  bool is_next_below(int t, const JoinPath& join) const {
    const int below = face_below(t, join);
    return below >= 0 && mesh_.face_part[below] == join.lower;
  }

  bool is_bump_already(const JoinPath& join) const {
    return std::any_of(mesh_.seams.begin(), mesh_.seams.end(), [&](const Seam& seam) {
      return seam.upper == upper_ && seam.bump && same_surface(upper_, join.lower);
    });
  }

  void replace_below(const JoinPath& join, int first, int last) {
    Seam seam = seam_of(join, first, last);
    seam.bump = true;
    mesh_.seams.push_back(std::move(seam));
    if (mesh_.surface[upper_] != upper_) return;
    for (const int face : faces_of_[upper_]) {
      const int below = face_below(mesh_.face_triangle[face], join);
      mesh_.faces[face] = mesh_.faces[below];
      mesh_.face_source[face] = mesh_.face_source[below];
      mesh_.faces[below] = {-1, -1, -1};  // hangs together with nothing any more
      dropped_[below] = 1;
    }
  }

  // Walks along the seam on the surface, outwards from where the lower part itself is in view,
  // so that neighbouring edges refer to faces that hang together.
  void follow(const JoinPath& join, int first, int last) {
    int start = (first + last) / 2;
    if (mesh_.face_part[below_[start]] != join.lower)
      for (int i = first; i < last; ++i)
        if (mesh_.face_part[below_[i]] == join.lower) start = i;
    for (int i = start; i + 1 < last; ++i) carry(i, i + 1);
    for (int i = start; i > first; --i) carry(i, i - 1);
  }

  void carry(int i, int j) {
    const int from = path_[j > i ? i : i + 1];
    const int until = path_[j > i ? j + 1 : j];
    bool complete = false;
    const std::vector<int> fan =
        turn(mesh_, below_[i], path_[std::max(i, j)], from, until, complete);
    if (complete && !comes_in_front(below_[j], fan.back())) below_[j] = fan.back();
  }

  // Whether a part of the surface begins in front of a face that the path has followed so far,
  // with an outline: then what is seen goes on on that part.
  bool comes_in_front(int face, int followed) const {
    return mesh_.face_part[face] > mesh_.face_part[followed];
  }

  int upper_node(int i, int vertex) const {
    return mesh_.node_at(mesh_.face_of(inner_[i], upper_), vertex);
  }

  // Whether the surface stays one: no edge has more than two faces.
  bool reconnect(const JoinPath& join, int first, int last) {
    Moves moves;
    std::vector<Mount> mounts;
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
        mounts.push_back({vertex, mesh_.face_part[below_[i]]});
      } else if (back && other.back() != below_[i - 1]) {
        merge_end(i, vertex, path_[i + 1], moves);
        move_all(mesh_, fan, vertex, node, moves);
        mounts.push_back({vertex, mesh_.face_part[below_[i - 1]]});
      } else {
        move_all(mesh_, fan, vertex, node, moves);
        if (!onwards) move_all(mesh_, other, vertex, node, moves);
      }
    }
    Seam seam = seam_of(join, first, last);
    seam.covered = covered_faces(first, last);
    seam.mounts = std::move(mounts);
    seam.first_end_inside = merge_end(first, path_[first], path_[first + 1], moves);
    seam.last_end_inside = merge_end(last - 1, path_[last], path_[last - 1], moves);
    for (const auto& [corner, node] : moves)
      mesh_.faces[triangle_of(corner)][place_of(corner)] = node;
    mesh_.seams.push_back(seam);
    return std::all_of(moves.begin(), moves.end(), [&](const auto& move) {
      return has_plain_edges(mesh_, triangle_of(move.first));
    });
  }

  // The faces that hang together with those below across path edges first to last, before the cut.
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

  // Re-attaches the whole turn around an end; where the turn is not closed, the end lies on an
  // outline, and only what is reached from the outer side moves.
  bool merge_end(int edge, int vertex, int along, Moves& moves) const {
    bool closed = false;
    move_all(mesh_, turn(mesh_, below_[edge], vertex, along, -1, closed), vertex,
             upper_node(edge, vertex), moves);
    return closed;
  }

  SheetMesh& mesh_;
  std::vector<std::string> warnings_;
  std::vector<uint8_t> dropped_;            // per face: replaced by a bump's
  std::vector<std::vector<int>> faces_of_;  // per part
  std::vector<int> path_;
  std::vector<int> inner_;
  std::vector<int> outer_;
  std::vector<int> below_;
  int upper_ = -1;
};

}  // namespace

Result<std::vector<std::string>> connect_sheets(const std::vector<JoinPath>& joins, int part_count,
                                                SheetMesh& mesh) {
  std::vector<size_t> order(joins.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return joins[a].upper < joins[b].upper; });
  Connector connector(part_count, mesh);
  for (const size_t j : order)
    if (Status status = connector.connect(joins[j]); !status) return status.error();
  return connector.finish();
}

}  // namespace relievo::relief
