#include "relief/cues/part_sheet.h"

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
namespace {

/// Flags the nodes that faces of several parts use, #N.
std::vector<uint8_t> shared_nodes(const LayeredMesh& mesh) {
  std::vector<int> first(mesh.node_vertex.size(), -1);
  std::vector<uint8_t> shared(first.size(), 0);
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    for (const int n : mesh.faces[f]) {
      if (first[n] < 0) first[n] = mesh.face_part[f];
      if (first[n] != mesh.face_part[f]) shared[n] = 1;
    }
  return shared;
}

/// Returns the face of the same part across the edge opposite to corner k, or -1.
int face_beside(const LayeredMesh& mesh, int face, int k) {
  const int t = mesh.neighbours[mesh.face_triangle[face]][k];
  if (t < 0) return -1;
  for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f)
    if (mesh.face_part[f] == mesh.face_part[face]) return f;
  return -1;
}

/// Unites the corners of the face with those of its neighbours in the part at each base vertex, but
/// not across cut edges, and flags open edges. Both are named by the opposite corner, #F x 3.
void connect(const LayeredMesh& mesh, int face, const std::vector<uint8_t>& cut,
             std::vector<uint8_t>& open, DisjointSets& corners) {
  const Triangle& here = mesh.triangles[mesh.face_triangle[face]];
  for (int k = 0; k < 3; ++k) {
    const int other = face_beside(mesh, face, k);
    if (other < 0) open[corner_of(face, k)] = 1;
    if (other < 0 || cut[corner_of(face, k)] != 0) continue;
    const Triangle& there = mesh.triangles[mesh.face_triangle[other]];
    for (const int i : {next_place(k), last_place(k)})
      corners.unite(corner_of(face, i), corner_of(other, place_of_node(there, here[i])));
  }
}

}  // namespace

std::vector<PartSheet> part_sheets(const LayeredMesh& mesh, const std::vector<bool>& wanted,
                                   bool cut_creases, double scale) {
  const size_t corner_count = 3 * mesh.faces.size();
  const std::vector<uint8_t> shared = shared_nodes(mesh);
  std::vector<uint8_t> cut(corner_count, 0);
  if (cut_creases)
    for (const CreaseEdge& edge : mesh.creases)
      for (const Corner corner : edge.corner) cut[corner] = 1;
  std::vector<uint8_t> open(corner_count, 0);
  DisjointSets corners(static_cast<int>(corner_count));
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (wanted[mesh.face_part[f]]) connect(mesh, static_cast<int>(f), cut, open, corners);
  std::vector<PartSheet> sheets(wanted.size());
  std::vector<int> vertex(corner_count, -1);  // of the sheet, at the first corner of each set
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
    if (!wanted[mesh.face_part[f]]) continue;
    PartSheet& sheet = sheets[mesh.face_part[f]];
    Triangle triangle{};
    for (int k = 0; k < 3; ++k) {
      const Corner first = corners.find(corner_of(f, k));
      if (first == corner_of(f, k)) {
        vertex[first] = static_cast<int>(sheet.positions.size());
        sheet.positions.push_back(scale * mesh.vertices[mesh.triangles[mesh.face_triangle[f]][k]]);
        sheet.rim.push_back(0);
        sheet.seam.push_back(0);
      }
      triangle[k] = vertex[first];
    }
    for (int k = 0; k < 3; ++k) {
      if (shared[mesh.faces[f][k]] != 0) sheet.seam[triangle[k]] = 1;
      if (open[corner_of(f, k)] != 0)
        sheet.rim[triangle[next_place(k)]] = sheet.rim[triangle[last_place(k)]] = 1;
    }
    sheet.faces.push_back(f);
    sheet.triangles.push_back(triangle);
  }
  return sheets;
}

}  // namespace relievo::relief
