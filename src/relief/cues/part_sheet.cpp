#include "relief/cues/part_sheet.h"

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
namespace {

/// Nodes that faces of several parts use.
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

/// The face of the same part across the edge opposite to corner k, or -1.
int face_beside(const LayeredMesh& mesh, int face, int k) {
  const int t = mesh.neighbours[mesh.face_triangle[face]][k];
  if (t < 0) return -1;
  for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f)
    if (mesh.face_part[f] == mesh.face_part[face]) return f;
  return -1;
}

class SheetMaker {
 public:
  SheetMaker(const LayeredMesh& mesh, AcrossCreases creases)
      : mesh_(mesh),
        corners_(static_cast<int>(3 * mesh.faces.size())),
        cut_(3 * mesh.faces.size(), 0),
        open_(cut_) {
    if (creases == AcrossCreases::whole) return;
    for (const CreaseEdge& edge : mesh.creases)
      for (const int corner : edge.corner) cut_[corner] = 1;
  }

  /// Unites the corners of the face with those of its neighbours in the part at each base vertex.
  void connect(int face) {
    for (int k = 0; k < 3; ++k) {
      const int other = face_beside(mesh_, face, k);
      if (other < 0) open_[corner_of(face, k)] = 1;
      if (other < 0 || cut_[corner_of(face, k)] != 0) continue;
      const auto& here = mesh_.triangles[mesh_.face_triangle[face]];
      const auto& there = mesh_.triangles[mesh_.face_triangle[other]];
      for (const int i : {next_place(k), last_place(k)})
        corners_.unite(corner_of(face, i), corner_of(other, place_of_node(there, here[i])));
    }
  }

  void append(int face, const std::vector<uint8_t>& shared, double scale, PartSheet& sheet) {
    Triangle triangle{};
    for (int k = 0; k < 3; ++k) {
      const Corner first = corners_.find(corner_of(face, k));
      if (first == corner_of(face, k)) {
        number_.resize(cut_.size(), -1);
        number_[first] = static_cast<int>(sheet.positions.size());
        const int vertex = mesh_.triangles[mesh_.face_triangle[face]][k];
        sheet.positions.push_back(scale * mesh_.vertices[vertex]);
        sheet.rim.push_back(0);
        sheet.seam.push_back(0);
      }
      triangle[k] = number_[first];
    }
    for (int k = 0; k < 3; ++k) {
      if (shared[mesh_.faces[face][k]] != 0) sheet.seam[triangle[k]] = 1;
      if (open_[corner_of(face, k)] != 0)
        sheet.rim[triangle[next_place(k)]] = sheet.rim[triangle[last_place(k)]] = 1;
    }
    sheet.faces.push_back(face);
    sheet.triangles.push_back(triangle);
  }

 private:
  const LayeredMesh& mesh_;
  DisjointSets corners_;
  std::vector<uint8_t> cut_;   ///< #F x 3, the edge opposite to the corner is a cut
  std::vector<uint8_t> open_;  ///< #F x 3, the part ends there
  std::vector<int> number_;    ///< #F x 3, vertex of the sheet that the first corner of a set is
};

}  // namespace

std::vector<PartSheet> part_sheets(const LayeredMesh& mesh, const std::vector<bool>& wanted,
                                   AcrossCreases creases, double scale) {
  std::vector<PartSheet> sheets(wanted.size());
  const std::vector<uint8_t> shared = shared_nodes(mesh);
  SheetMaker maker(mesh, creases);
  const int faces = static_cast<int>(mesh.faces.size());
  for (int f = 0; f < faces; ++f)
    if (wanted[mesh.face_part[f]]) maker.connect(f);
  for (int f = 0; f < faces; ++f)
    if (wanted[mesh.face_part[f]]) maker.append(f, shared, scale, sheets[mesh.face_part[f]]);
  return sheets;
}

}  // namespace relievo::relief
