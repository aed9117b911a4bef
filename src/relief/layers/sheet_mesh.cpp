#include "relief/layers/sheet_mesh.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "kernel/base/disjoint_sets.h"
#include "kernel/geometry/polygon.h"

namespace relievo::relief {
namespace {

/// Groups the corners at one node: those of faces that are connected across shared edges have one
/// number. Numbers start at 0 in order of appearance.
std::vector<int> fans_of(const SheetMesh& mesh, std::span<const Corner> corners) {
  std::vector<int> group(corners.size(), -1);
  std::vector<size_t> pending;
  int count = 0;
  for (size_t i = 0; i < group.size(); ++i) {
    if (group[i] >= 0) continue;
    group[i] = count;
    pending.assign(1, i);
    while (!pending.empty()) {
      const Corner corner = corners[pending.back()];
      pending.pop_back();
      for (const int k : {next_place(place_of(corner)), last_place(place_of(corner))}) {
        const int next = mesh.face_across(triangle_of(corner), k);
        if (next < 0) continue;
        for (size_t j = 0; j < group.size(); ++j)
          if (triangle_of(corners[j]) == next && group[j] < 0) {
            group[j] = count;
            pending.push_back(j);
          }
      }
    }
    ++count;
  }
  return group;
}

/// Returns whether the faces at one node follow each other all around it, each sharing an edge with
/// the next. `spokes` is scratch memory.
bool is_closed_fan(const SheetMesh& mesh, std::span<const Corner> corners,
                   std::vector<std::pair<int, int>>& spokes) {
  spokes.clear();
  for (const Corner corner : corners) {
    const Triangle& face = mesh.faces[triangle_of(corner)];
    spokes.push_back({face[next_place(place_of(corner))], face[last_place(place_of(corner))]});
  }
  size_t at = 0;
  for (size_t passed = 1; passed <= spokes.size(); ++passed) {
    const int shared = spokes[at].second;
    at = 0;
    while (at < spokes.size() && spokes[at].first != shared) ++at;
    if (at == 0 || at == spokes.size()) return at == 0 && passed == spokes.size();
  }
  return false;
}

/// Loops of one part along an undirected edge: crossing it from left to right of (low -> high)
/// adds `turn` to the winding number of `part`.
struct EdgeTurn {
  std::array<int, 2> edge;
  int part;
  int turn;
};

using Winding = std::vector<std::pair<int, int>>;  // part, number; ascending parts, no zeros

std::vector<EdgeTurn> collect_turns(const SheetMesh& mesh) {
  std::vector<EdgeTurn> turns;
  for (size_t l = 0; l < mesh.loops.size(); ++l) {
    const std::vector<int>& loop = mesh.loops[l];
    for (size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      // The left side of a -> b has the larger winding number.
      turns.push_back({{std::min(a, b), std::max(a, b)}, mesh.loop_part[l], a < b ? -1 : 1});
    }
  }
  std::sort(turns.begin(), turns.end(), [](const EdgeTurn& x, const EdgeTurn& y) {
    return x.edge != y.edge ? x.edge < y.edge : x.part < y.part;
  });
  std::vector<EdgeTurn> merged;
  for (const EdgeTurn& turn : turns) {
    if (!merged.empty() && merged.back().edge == turn.edge && merged.back().part == turn.part)
      merged.back().turn += turn.turn;
    else
      merged.push_back(turn);
  }
  return merged;
}

/// The turns along the edge opposite to corner k.
std::span<const EdgeTurn> turns_at(const std::vector<EdgeTurn>& turns, const Triangle& triangle,
                                   int k) {
  const auto [low, high] = std::minmax(triangle[next_place(k)], triangle[last_place(k)]);
  const auto [first, last] =
      std::equal_range(turns.begin(), turns.end(), EdgeTurn{{low, high}, 0, 0},
                       [](const EdgeTurn& x, const EdgeTurn& y) { return x.edge < y.edge; });
  return {turns.data() + (first - turns.begin()), static_cast<size_t>(last - first)};
}

/// Adds turns, times a sign, to winding numbers.
Winding crossed(Winding winding, std::span<const EdgeTurn> turns, int sign) {
  for (const EdgeTurn& turn : turns) {
    if (turn.turn == 0) continue;
    const auto at =
        std::lower_bound(winding.begin(), winding.end(), turn.part,
                         [](const auto& entry, int part) { return entry.first < part; });
    if (at != winding.end() && at->first == turn.part) {
      at->second += sign * turn.turn;
      if (at->second == 0) winding.erase(at);
    } else {
      winding.insert(at, {turn.part, sign * turn.turn});
    }
  }
  return winding;
}

/// The sign of turns when a triangle is left through the edge opposite to corner k.
int sign_out(const Triangle& triangle, int k) {
  return triangle[next_place(k)] < triangle[last_place(k)] ? 1 : -1;
}

/// Winding numbers of all triangles: `region` (#T) gives the index of a triangle's in the result.
std::vector<Winding> flood(const SheetMesh& mesh, std::vector<int>& region) {
  const std::vector<EdgeTurn> turns = collect_turns(mesh);
  std::vector<Winding> windings;
  std::vector<int> pending;
  const auto start_region = [&](int t, Winding winding) {
    region[t] = static_cast<int>(windings.size());
    windings.push_back(std::move(winding));
    pending.push_back(t);
  };
  for (size_t seed = 0; seed < region.size(); ++seed)
    for (int side = 0; side < 3; ++side) {
      if (mesh.base.neighbours[seed][side] >= 0 || region[seed] >= 0) continue;
      const Triangle& hull = mesh.base.triangles[seed];
      start_region(static_cast<int>(seed),
                   crossed({}, turns_at(turns, hull, side), -sign_out(hull, side)));
      while (!pending.empty()) {
        const int t = pending.back();
        pending.pop_back();
        for (int k = 0; k < 3; ++k) {
          const int next = mesh.base.neighbours[t][k];
          if (next < 0 || region[next] >= 0) continue;
          const Triangle& triangle = mesh.base.triangles[t];
          const std::span<const EdgeTurn> along = turns_at(turns, triangle, k);
          if (along.empty()) {
            region[next] = region[t];
            pending.push_back(next);
          } else {
            start_region(next, crossed(windings[region[t]], along, sign_out(triangle, k)));
          }
        }
      }
    }
  return windings;
}

}  // namespace

int SheetMesh::loop_vertex(int loop, int position) const {
  const std::vector<int>& ring = loops[loop];
  const int n = static_cast<int>(ring.size());
  return ring[((position % n) + n) % n];
}

int SheetMesh::triangle_left_of(int a, int b) const {
  for (const Corner corner : base_corners.at(a)) {
    const int t = triangle_of(corner);
    if (base.triangles[t][next_place(place_of(corner))] == b) return t;
  }
  return -1;
}

int SheetMesh::face_of(int t, int part) const {
  if (t < 0) return -1;
  const auto first = face_part.begin() + stack_begin[t];
  const auto last = face_part.begin() + stack_begin[t + 1];
  const auto at = std::lower_bound(first, last, part);
  return at != last && *at == part ? static_cast<int>(at - face_part.begin()) : -1;
}

int SheetMesh::face_across(int face, int k) const {
  const int t = face_triangle[face];
  const int next = base.neighbours[t][k];
  if (next < 0) return -1;
  const int corner = place_of_node(base.neighbours[next], t);
  for (int f = stack_begin[next]; f < stack_begin[next + 1]; ++f)
    if (share_edge(faces[face], k, faces[f], corner)) return f;
  return -1;
}

int SheetMesh::outline_node(int part, int a, int b, int vertex) const {
  int inner = triangle_left_of(a, b);
  int outer = triangle_left_of(b, a);
  if (face_of(inner, part) < 0) std::swap(inner, outer);
  const int face = face_of(inner, part);
  return face < 0 || face_of(outer, part) >= 0 ? -1 : node_at(face, vertex);
}

double SheetMesh::run_length(const LoopRun& run) const {
  double length = 0;
  for (int i = 0; i < run.edges; ++i) length += loop_step(run.loop, run.position + i, 1);
  return length;
}

std::vector<int> SheetMesh::run_vertices(const LoopRun& run) const {
  std::vector<int> vertices;
  for (int i = 0; i <= run.edges; ++i) vertices.push_back(loop_vertex(run.loop, run.position + i));
  return vertices;
}

void make_nodes(SheetMesh& mesh) {
  mesh.base_corners = corners_at_nodes(mesh.base.triangles, mesh.points.size());
  std::vector<std::pair<int, Corner>> at_vertex;  // part, corner of its face
  for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) {
    at_vertex.clear();
    for (const Corner corner : mesh.base_corners.at(v)) {
      const int t = triangle_of(corner);
      for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f)
        at_vertex.emplace_back(mesh.face_part[f], corner_of(f, place_of(corner)));
    }
    std::sort(at_vertex.begin(), at_vertex.end());
    int part = -1;
    for (const auto& [own, corner] : at_vertex) {
      if (own != part) mesh.node_vertex.push_back(v);
      part = own;
      mesh.faces[triangle_of(corner)][place_of(corner)] =
          static_cast<int>(mesh.node_vertex.size()) - 1;
    }
  }
}

std::vector<int> drop_faces(const std::vector<uint8_t>& dropped, SheetMesh& mesh) {
  std::vector<int> number(dropped.size(), -1);
  int count = 0;
  int triangle = 0;
  for (size_t f = 0; f < dropped.size(); ++f) {
    for (; triangle <= mesh.face_triangle[f]; ++triangle) mesh.stack_begin[triangle] = count;
    if (dropped[f] != 0) continue;
    mesh.face_part[count] = mesh.face_part[f];
    mesh.face_source[count] = mesh.face_source[f];
    mesh.face_triangle[count] = mesh.face_triangle[f];
    mesh.faces[count] = mesh.faces[f];
    number[f] = count++;
  }
  for (; triangle < static_cast<int>(mesh.stack_begin.size()); ++triangle)
    mesh.stack_begin[triangle] = count;
  mesh.face_part.resize(count);
  mesh.face_source.resize(count);
  mesh.face_triangle.resize(count);
  mesh.faces.resize(count);
  return number;
}

std::vector<DepthPair> split_fans(SheetMesh& mesh) {
  std::vector<DepthPair> ties;
  const int count = static_cast<int>(mesh.node_vertex.size());
  const NodeCorners all = corners_at_nodes(mesh.faces, mesh.node_vertex.size());
  std::vector<Triangle> split = mesh.faces;
  std::vector<std::pair<int, int>> spokes;
  for (int n = 0; n < count; ++n) {
    const std::span<const Corner> corners = all.at(n);
    if (is_closed_fan(mesh, corners, spokes)) continue;
    const std::vector<int> group = fans_of(mesh, corners);
    const int groups = group.empty() ? 0 : *std::max_element(group.begin(), group.end()) + 1;
    for (int g = 1; g < groups; ++g) {
      const int copy = static_cast<int>(mesh.node_vertex.size());
      mesh.node_vertex.push_back(mesh.node_vertex[n]);
      ties.push_back({n, copy, true});
      for (size_t i = 0; i < group.size(); ++i)
        if (group[i] == g) split[triangle_of(corners[i])][place_of(corners[i])] = copy;
    }
  }
  mesh.faces = std::move(split);
  return ties;
}

bool has_one_sign(const SheetMesh& mesh, const Scene& scene, int part) {
  const auto is_raised = [&](size_t p) { return scene.parts[p].d > 0; };
  for (size_t p = 0; p < scene.parts.size(); ++p)
    if (mesh.surface[p] == mesh.surface[part] && is_raised(p) != is_raised(part)) return false;
  return true;
}

void cover_triangles(SheetMesh& mesh) {
  std::vector<int> region(mesh.base.triangles.size(), -1);
  const std::vector<Winding> windings = flood(mesh, region);
  mesh.stack_begin.push_back(0);
  for (size_t t = 0; t < region.size(); ++t) {
    for (const auto& entry : windings[region[t]]) {
      mesh.face_part.push_back(entry.first);
      mesh.face_triangle.push_back(static_cast<int>(t));
    }
    mesh.stack_begin.push_back(static_cast<int>(mesh.face_part.size()));
  }
  mesh.face_source = mesh.face_part;
  mesh.faces.resize(mesh.face_part.size());
}

void drop_specks(double least_area, SheetMesh& mesh) {
  const int faces = static_cast<int>(mesh.face_part.size());
  DisjointSets pieces(faces);
  for (int f = 0; f < faces; ++f)
    for (const int next : mesh.base.neighbours[mesh.face_triangle[f]]) {
      if (next < mesh.face_triangle[f]) continue;
      const int other = mesh.face_of(next, mesh.face_part[f]);
      if (other >= 0) pieces.unite(f, other);
    }
  std::vector<double> area(faces, 0);
  for (int f = 0; f < faces; ++f) {
    const auto [a, b, c] = mesh.base.triangles[mesh.face_triangle[f]];
    const Point2 p = mesh.points[a];
    area[pieces.find(f)] += 0.5 * cross(mesh.points[b] - p, mesh.points[c] - p);
  }
  std::vector<uint8_t> dropped(faces);
  for (int f = 0; f < faces; ++f) dropped[f] = area[pieces.find(f)] >= least_area ? 0 : 1;
  drop_faces(dropped, mesh);
}

}  // namespace relievo::relief
