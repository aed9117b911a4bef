#include "relief/layers/sheet_mesh.h"

#include <algorithm>
#include <span>
#include <utility>

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

}  // namespace relievo::relief
