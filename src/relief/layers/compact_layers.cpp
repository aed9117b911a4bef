#include "relief/layers/compact_layers.h"

#include <algorithm>
#include <array>
#include <utility>

#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

class Compactor {
 public:
  Compactor(const SheetMesh& mesh, const FaceOrder& order) : sheets_(mesh), order_(order) {
    triangle_.assign(mesh.base.triangles.size(), -1);
    vertex_.assign(mesh.points.size(), -1);
    node_.assign(mesh.node_vertex.size(), -1);
  }

  LayeredMesh run(const Boundaries& boundaries, const std::vector<DepthPair>& pairs) {
    copy_triangles(!boundaries.bump_nodes.empty());
    copy_nodes();
    copy_roles(boundaries, out_);
    copy_bumps(boundaries, out_);
    copy_constraints(pairs, out_);
    return std::move(out_);
  }

 private:
  void copy_roles(const Boundaries& boundaries, LayeredMesh& mesh) const {
    mesh.node_role.resize(mesh.node_vertex.size());
    for (size_t n = 0; n < node_.size(); ++n)
      if (node_[n] >= 0) mesh.node_role[node_[n]] = boundaries.role[n];
    mesh.ramps = boundaries.ramps;
    for (RampNode node : boundaries.ramp_nodes) {
      node.node = node_[node.node];
      if (node.below >= 0) node.below = node_[node.below];
      if (node.node >= 0) mesh.ramp_nodes.push_back(node);
    }
  }

  void copy_bumps(const Boundaries& boundaries, LayeredMesh& mesh) const {
    for (BumpNode node : boundaries.bump_nodes) {
      node.node = node_[node.node];
      if (node.node >= 0) mesh.bump_nodes.push_back(node);
    }
  }

  void copy_constraints(const std::vector<DepthPair>& pairs, LayeredMesh& mesh) const {
    const std::vector<uint8_t> seen = seen_nodes(mesh);
    for (DepthPair pair : pairs) {
      pair.lower = node_[pair.lower];
      pair.upper = node_[pair.upper];
      if (pair.lower >= 0 && pair.upper >= 0 && seen[pair.lower] != 0 && seen[pair.upper] != 0)
        mesh.constraints.push_back(pair);
    }
  }

  void copy_triangles(bool with_sources) {
    out_.stack_begin.push_back(0);
    const auto covered = [&](int t) {
      return t >= 0 && sheets_.stack_begin[t + 1] > sheets_.stack_begin[t];
    };
    int count = 0;
    for (size_t t = 0; t < triangle_.size(); ++t)
      if (covered(static_cast<int>(t))) triangle_[t] = count++;
    for (size_t t = 0; t < triangle_.size(); ++t) {
      if (triangle_[t] < 0) continue;
      for (const int v : sheets_.base.triangles[t]) vertex_[v] = 0;
      std::array<int, 3> across{};
      for (int k = 0; k < 3; ++k) {
        const int next = sheets_.base.neighbours[t][k];
        across[k] = covered(next) ? triangle_[next] : -1;
      }
      out_.neighbours.push_back(across);
      out_.triangles.push_back(sheets_.base.triangles[t]);
      for (int i = sheets_.stack_begin[t]; i < sheets_.stack_begin[t + 1]; ++i) {
        const int f = order_.local.is_usual() ? i : order_.local.faces[i];
        out_.faces.push_back(sheets_.faces[f]);
        out_.face_part.push_back(sheets_.face_part[f]);
        out_.face_triangle.push_back(triangle_[t]);
        if (with_sources) out_.face_source.push_back(sheets_.face_source[f]);
        out_.face_flap.push_back(order_.flaps[f]);
      }
      out_.stack_begin.push_back(static_cast<int>(out_.faces.size()));
    }
    for (size_t v = 0; v < vertex_.size(); ++v) {
      if (vertex_[v] < 0) continue;
      vertex_[v] = static_cast<int>(out_.vertices.size());
      out_.vertices.push_back(sheets_.points[v]);
    }
    for (auto& triangle : out_.triangles)
      for (int& v : triangle) v = vertex_[v];
  }

  void copy_nodes() {
    const std::vector<int> part = frontmost_parts(sheets_);
    for (size_t n = 0; n < node_.size(); ++n) {
      if (part[n] < 0) continue;
      node_[n] = static_cast<int>(out_.node_vertex.size());
      out_.node_vertex.push_back(vertex_[sheets_.node_vertex[n]]);
      out_.node_part.push_back(part[n]);
    }
    for (auto& face : out_.faces)
      for (int& n : face) n = node_[n];
  }

  const SheetMesh& sheets_;
  const FaceOrder& order_;
  std::vector<int> triangle_;
  std::vector<int> vertex_;
  std::vector<int> node_;
  LayeredMesh out_;
};

}  // namespace

LayeredMesh compact_layers(const SheetMesh& mesh, const Boundaries& boundaries,
                           const FaceOrder& faces, const std::vector<DepthPair>& pairs) {
  return Compactor(mesh, faces).run(boundaries, pairs);
}

}  // namespace relievo::relief
