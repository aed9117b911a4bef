#include "relief/layers/sheet_mesh.h"

#include <algorithm>
#include <utility>

namespace relievo::relief {
namespace {

/// An edge of a face as the faces of the triangle beyond it have it.
struct EdgeAcross {
  int first_face = 0;  // beyond
  int last_face = 0;   // behind the last
  int from = 0;        // corners of theirs at its ends
  int to = 0;
  int from_node = -1;
  int to_node = -1;

  bool is_of(const Triangle& face) const { return face[from] == from_node && face[to] == to_node; }
};

/// The edge opposite to corner k; no faces where there is no triangle beyond.
EdgeAcross edge_across(const SheetMesh& mesh, int face, int k) {
  const int t = mesh.face_triangle[face];
  const int next = mesh.base.neighbours[t][k];
  if (next < 0) return {};
  const int corner = place_of_node(mesh.base.neighbours[next], t);
  return {mesh.stack_begin[next], mesh.stack_begin[next + 1],      next_place(corner),
          last_place(corner),     mesh.faces[face][last_place(k)], mesh.faces[face][next_place(k)]};
}

/// Groups of the faces around one node that hang together across shared edges.
class Fans {
 public:
  explicit Fans(const SheetMesh& mesh) : mesh_(mesh) {}

  /// Group number per corner; numbers start at 0 in order of appearance.
  std::vector<int> groups(std::span<const Corner> corners) {
    std::vector<int> group(corners.size(), -1);
    int count = 0;
    for (size_t i = 0; i < group.size(); ++i) {
      if (group[i] >= 0) continue;
      group[i] = count;
      pending_.assign(1, i);
      while (!pending_.empty()) {
        const Corner corner = corners[pending_.back()];
        pending_.pop_back();
        for (const int turn : {1, 2}) {
          const int next = mesh_.face_across(triangle_of(corner), (place_of(corner) + turn) % 3);
          if (next < 0) continue;
          for (size_t j = 0; j < group.size(); ++j)
            if (triangle_of(corners[j]) == next && group[j] < 0) {
              group[j] = count;
              pending_.push_back(j);
            }
        }
      }
      ++count;
    }
    return group;
  }

 private:
  const SheetMesh& mesh_;
  std::vector<size_t> pending_;
};

/// Whether the faces at one node follow each other all around it, each sharing an edge with the
/// next. `spokes` is memory to use.
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

}  // namespace

int Loops::vertex(int loop, int position) const {
  const std::vector<int>& ring = vertices[loop];
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
  const EdgeAcross edge = edge_across(*this, face, k);
  for (int f = edge.first_face; f < edge.last_face; ++f)
    if (edge.is_of(faces[f])) return f;
  return -1;
}

int SheetMesh::outline_node(int part, int a, int b, int vertex) const {
  int inner = triangle_left_of(a, b);
  int outer = triangle_left_of(b, a);
  if (face_of(inner, part) < 0) std::swap(inner, outer);
  const int face = face_of(inner, part);
  return face < 0 || face_of(outer, part) >= 0 ? -1 : node_at(face, vertex);
}

SheetMesh make_sheets(std::vector<Point2> points, PlanarTriangulation base, Loops loops,
                      const Cover& cover) {
  SheetMesh mesh;
  mesh.base_corners = corners_at_nodes(base.triangles, points.size());
  mesh.points = std::move(points);
  mesh.base = std::move(base);
  mesh.loops = std::move(loops);
  mesh.stack_begin = cover.stack_begin;
  mesh.face_part = cover.stack_part;
  mesh.face_source = cover.stack_part;
  mesh.faces.resize(cover.stack_part.size());
  for (size_t t = 0; t + 1 < cover.stack_begin.size(); ++t)
    mesh.face_triangle.insert(mesh.face_triangle.end(),
                              cover.stack_begin[t + 1] - cover.stack_begin[t], static_cast<int>(t));
  std::vector<std::pair<int, Corner>> at_vertex;  // part, corner of its face
  for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) {
    at_vertex.clear();
    for (const Corner corner : mesh.base_corners.at(v)) {
      const int t = triangle_of(corner);
      for (int f = cover.stack_begin[t]; f < cover.stack_begin[t + 1]; ++f)
        at_vertex.emplace_back(cover.stack_part[f], corner_of(f, place_of(corner)));
    }
    std::sort(at_vertex.begin(), at_vertex.end());
    int part = -1;
    for (const auto& [own, corner] : at_vertex) {
      if (own != part) {
        mesh.node_vertex.push_back(v);
        mesh.node_part.push_back(own);
        part = own;
      }
      mesh.faces[triangle_of(corner)][place_of(corner)] =
          static_cast<int>(mesh.node_vertex.size()) - 1;
    }
  }
  return mesh;
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

bool has_plain_edges(const SheetMesh& mesh, int face) {
  const int t = mesh.face_triangle[face];
  const auto stack = [&mesh](int first, int last) {
    return std::pair(mesh.faces.begin() + first, mesh.faces.begin() + last);
  };
  for (int k = 0; k < 3; ++k) {
    const int a = next_place(k);
    const int b = last_place(k);
    const auto [first, last] = stack(mesh.stack_begin[t], mesh.stack_begin[t + 1]);
    const auto is_beside = [&](const Triangle& other) {
      return other[a] == mesh.faces[face][a] && other[b] == mesh.faces[face][b];
    };
    if (std::count_if(first, last, is_beside) > 1) return false;
    const EdgeAcross edge = edge_across(mesh, face, k);
    const auto [first_across, last_across] = stack(edge.first_face, edge.last_face);
    const auto is_across = [&](const Triangle& other) { return edge.is_of(other); };
    if (std::count_if(first_across, last_across, is_across) > 1) return false;
  }
  return true;
}

std::vector<DepthPair> split_fans(SheetMesh& mesh) {
  std::vector<DepthPair> ties;
  const int count = static_cast<int>(mesh.node_vertex.size());
  const NodeCorners all = corners_at_nodes(mesh.faces, mesh.node_vertex.size());
  Fans fans(mesh);
  struct Move {
    Corner corner;
    int node;
  };
  std::vector<Move> moves;
  std::vector<std::pair<int, int>> spokes;
  for (int n = 0; n < count; ++n) {
    const std::span<const Corner> corners = all.at(n);
    if (is_closed_fan(mesh, corners, spokes)) continue;
    const std::vector<int> group = fans.groups(corners);
    const int groups = group.empty() ? 0 : *std::max_element(group.begin(), group.end()) + 1;
    for (int g = 1; g < groups; ++g) {
      const int copy = static_cast<int>(mesh.node_vertex.size());
      mesh.node_vertex.push_back(mesh.node_vertex[n]);
      mesh.node_part.push_back(0);
      ties.push_back({n, copy, true});
      for (size_t i = 0; i < group.size(); ++i)
        if (group[i] == g) moves.push_back({corners[i], copy});
    }
  }
  for (const Move& move : moves)
    mesh.faces[triangle_of(move.corner)][place_of(move.corner)] = move.node;
  return ties;
}

std::vector<int> frontmost_parts(const SheetMesh& mesh) {
  std::vector<int> part(mesh.node_vertex.size(), -1);
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    for (const int n : mesh.faces[f]) part[n] = std::max(part[n], mesh.face_part[f]);
  return part;
}

bool has_one_sign(const SheetMesh& mesh, const Scene& scene, int part) {
  const auto is_raised = [&](size_t p) { return scene.parts[p].d > 0; };
  for (size_t p = 0; p < scene.parts.size(); ++p)
    if (mesh.surface[p] == mesh.surface[part] && is_raised(p) != is_raised(part)) return false;
  return true;
}

}  // namespace relievo::relief
