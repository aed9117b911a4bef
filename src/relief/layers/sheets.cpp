#include "relief/layers/sheets.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace relievo {
namespace {

/// Lists the corners at each of `count` nodes or vertices of a triangle array.
std::pair<std::vector<int>, std::vector<Corner>> corners_by_node(
    const std::vector<std::array<int, 3>>& triangles, size_t count) {
  std::vector<int> begin(count + 1, 0);
  for (const auto& triangle : triangles)
    for (const int v : triangle) ++begin[v + 1];
  for (size_t v = 0; v < count; ++v) begin[v + 1] += begin[v];
  std::vector<Corner> corners(begin.back());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) corners[next[triangles[t][k]]++] = static_cast<Corner>(3 * t + k);
  return {std::move(begin), std::move(corners)};
}

/// An edge of a face as the faces of the triangle beyond it have it.
struct EdgeAcross {
  int first_face = 0;  // beyond
  int last_face = 0;   // behind the last
  int from = 0;        // corners of theirs at its ends
  int to = 0;
  int from_node = -1;
  int to_node = -1;

  bool is_of(const std::array<int, 3>& face) const {
    return face[from] == from_node && face[to] == to_node;
  }
};

/// The edge opposite to corner k; no faces where there is no triangle beyond.
EdgeAcross edge_across(const BaseMesh& base, const Sheets& sheets, int face, int k) {
  const int t = sheets.face_triangle[face];
  const int next = base.mesh.neighbours[t][k];
  if (next < 0) return {};
  int corner = 0;
  while (base.mesh.neighbours[next][corner] != t) ++corner;
  return {
      sheets.stack_begin[next], sheets.stack_begin[next + 1],    (corner + 1) % 3,
      (corner + 2) % 3,         sheets.faces[face][(k + 2) % 3], sheets.faces[face][(k + 1) % 3]};
}

/// Groups of the faces around one node that hang together across shared edges.
class Fans {
 public:
  Fans(const BaseMesh& base, const Sheets& sheets) : base_(base), sheets_(sheets) {}

  /// Group number per corner in [first, last); numbers start at 0 in order of appearance.
  std::vector<int> groups(const Corner* first, const Corner* last) {
    std::vector<int> group(last - first, -1);
    int count = 0;
    for (size_t i = 0; i < group.size(); ++i) {
      if (group[i] >= 0) continue;
      group[i] = count;
      pending_.assign(1, i);
      while (!pending_.empty()) {
        const Corner corner = first[pending_.back()];
        pending_.pop_back();
        for (const int turn : {1, 2}) {
          const int next = face_across(base_, sheets_, corner / 3, (corner % 3 + turn) % 3);
          if (next < 0) continue;
          for (size_t j = 0; j < group.size(); ++j)
            if (first[j] / 3 == next && group[j] < 0) {
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
  const BaseMesh& base_;
  const Sheets& sheets_;
  std::vector<size_t> pending_;
};

/// Whether the faces at one node follow each other all around it, each sharing an edge with the
/// next. `spokes` is memory to use.
bool is_closed_fan(const Sheets& sheets, const Corner* first, const Corner* last,
                   std::vector<std::pair<int, int>>& spokes) {
  spokes.clear();
  for (const Corner* corner = first; corner != last; ++corner) {
    const std::array<int, 3>& face = sheets.faces[*corner / 3];
    spokes.push_back({face[(*corner % 3 + 1) % 3], face[(*corner % 3 + 2) % 3]});
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

int BaseMesh::triangle_left_of(int a, int b) const {
  for (int i = corner_begin[a]; i < corner_begin[a + 1]; ++i) {
    const int t = corners[i] / 3;
    if (mesh.triangles[t][(corners[i] % 3 + 1) % 3] == b) return t;
  }
  return -1;
}

BaseMesh make_base_mesh(std::vector<Point2> points, PlanarTriangulation mesh) {
  BaseMesh base;
  std::tie(base.corner_begin, base.corners) = corners_by_node(mesh.triangles, points.size());
  base.points = std::move(points);
  base.mesh = std::move(mesh);
  return base;
}

int Sheets::face_of(int t, int part) const {
  if (t < 0) return -1;
  const auto first = face_part.begin() + stack_begin[t];
  const auto last = face_part.begin() + stack_begin[t + 1];
  const auto at = std::lower_bound(first, last, part);
  return at != last && *at == part ? static_cast<int>(at - face_part.begin()) : -1;
}

Sheets make_sheets(const BaseMesh& base, const Cover& cover) {
  Sheets sheets;
  sheets.stack_begin = cover.stack_begin;
  sheets.face_part = cover.stack_part;
  sheets.face_source = cover.stack_part;
  sheets.faces.resize(cover.stack_part.size());
  for (size_t t = 0; t + 1 < cover.stack_begin.size(); ++t)
    sheets.face_triangle.insert(sheets.face_triangle.end(),
                                cover.stack_begin[t + 1] - cover.stack_begin[t],
                                static_cast<int>(t));
  std::vector<std::pair<int, int>> at_vertex;  // part, face corner
  for (size_t v = 0; v < base.points.size(); ++v) {
    at_vertex.clear();
    for (int i = base.corner_begin[v]; i < base.corner_begin[v + 1]; ++i) {
      const int t = base.corners[i] / 3;
      for (int f = cover.stack_begin[t]; f < cover.stack_begin[t + 1]; ++f)
        at_vertex.emplace_back(cover.stack_part[f], 3 * f + base.corners[i] % 3);
    }
    std::sort(at_vertex.begin(), at_vertex.end());
    for (size_t i = 0; i < at_vertex.size(); ++i) {
      if (i == 0 || at_vertex[i].first != at_vertex[i - 1].first) {
        sheets.node_vertex.push_back(static_cast<int>(v));
        sheets.node_part.push_back(at_vertex[i].first);
      }
      const Corner corner = at_vertex[i].second;
      sheets.faces[corner / 3][corner % 3] = static_cast<int>(sheets.node_vertex.size()) - 1;
    }
  }
  return sheets;
}

std::vector<int> drop_faces(const std::vector<uint8_t>& dropped, Sheets& sheets) {
  std::vector<int> number(dropped.size(), -1);
  int count = 0;
  int triangle = 0;
  for (size_t f = 0; f < dropped.size(); ++f) {
    for (; triangle <= sheets.face_triangle[f]; ++triangle) sheets.stack_begin[triangle] = count;
    if (dropped[f] != 0) continue;
    sheets.face_part[count] = sheets.face_part[f];
    sheets.face_source[count] = sheets.face_source[f];
    sheets.face_triangle[count] = sheets.face_triangle[f];
    sheets.faces[count] = sheets.faces[f];
    number[f] = count++;
  }
  for (; triangle < static_cast<int>(sheets.stack_begin.size()); ++triangle)
    sheets.stack_begin[triangle] = count;
  sheets.face_part.resize(count);
  sheets.face_source.resize(count);
  sheets.face_triangle.resize(count);
  sheets.faces.resize(count);
  return number;
}

int face_across(const BaseMesh& base, const Sheets& sheets, int face, int k) {
  const EdgeAcross edge = edge_across(base, sheets, face, k);
  for (int f = edge.first_face; f < edge.last_face; ++f)
    if (edge.is_of(sheets.faces[f])) return f;
  return -1;
}

bool has_plain_edges(const BaseMesh& base, const Sheets& sheets, int face) {
  const int t = sheets.face_triangle[face];
  const auto stack = [&sheets](int first, int last) {
    return std::pair(sheets.faces.begin() + first, sheets.faces.begin() + last);
  };
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3;
    const int b = (k + 2) % 3;
    const auto [first, last] = stack(sheets.stack_begin[t], sheets.stack_begin[t + 1]);
    const auto is_beside = [&](const std::array<int, 3>& other) {
      return other[a] == sheets.faces[face][a] && other[b] == sheets.faces[face][b];
    };
    if (std::count_if(first, last, is_beside) > 1) return false;
    const EdgeAcross edge = edge_across(base, sheets, face, k);
    const auto [first_across, last_across] = stack(edge.first_face, edge.last_face);
    const auto is_across = [&](const std::array<int, 3>& other) { return edge.is_of(other); };
    if (std::count_if(first_across, last_across, is_across) > 1) return false;
  }
  return true;
}

std::vector<DepthPair> split_fans(const BaseMesh& base, Sheets& sheets) {
  std::vector<DepthPair> ties;
  const auto [begin, corners] = corners_by_node(sheets.faces, sheets.node_vertex.size());
  const size_t count = sheets.node_vertex.size();
  Fans fans(base, sheets);
  struct Move {
    Corner corner;
    int node;
  };
  std::vector<Move> moves;
  std::vector<std::pair<int, int>> spokes;
  for (size_t n = 0; n < count; ++n) {
    if (is_closed_fan(sheets, corners.data() + begin[n], corners.data() + begin[n + 1], spokes))
      continue;
    const std::vector<int> group =
        fans.groups(corners.data() + begin[n], corners.data() + begin[n + 1]);
    const int groups = group.empty() ? 0 : *std::max_element(group.begin(), group.end()) + 1;
    for (int g = 1; g < groups; ++g) {
      const int copy = static_cast<int>(sheets.node_vertex.size());
      sheets.node_vertex.push_back(sheets.node_vertex[n]);
      sheets.node_part.push_back(0);
      ties.push_back({static_cast<int>(n), copy, true});
      for (size_t i = 0; i < group.size(); ++i)
        if (group[i] == g) moves.push_back({corners[begin[n] + i], copy});
    }
  }
  for (const Move& move : moves) sheets.faces[move.corner / 3][move.corner % 3] = move.node;
  return ties;
}

}  // namespace relievo
