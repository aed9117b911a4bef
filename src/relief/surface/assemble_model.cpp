#include "relief/surface/assemble_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "relief/surface/cut_faces.h"
#include "relief/surface/model_builder.h"
#include "relief/surface/sheet_surface.h"
#include "relief/surface/walls.h"

namespace relievo::relief {
namespace {

constexpr double min_rim_tolerance = 1e-6;
constexpr int most_rim_levels = 8;
/// Heights that differ by less than this count as equal, of the canvas's longer side.
constexpr double weld_fraction = 1e-9;
/// Faces count as hidden from this depth below the front part on, of the canvas's longer side.
constexpr double hidden_fraction = 0.004;

Status check_options(const ModelOptions& options) {
  if (!(options.rim_tolerance >= min_rim_tolerance && std::isfinite(options.rim_tolerance)))
    return Error{ErrorCode::usage, "the rim tolerance must be at least 1e-6 px", "rim_tolerance"};
  if (options.max_rim_levels < 0 || options.max_rim_levels > most_rim_levels)
    return Error{ErrorCode::usage, "the number of rim levels must be from 0 to 8",
                 "max_rim_levels"};
  return Done{};
}

/// Adds the surface's own vertices. They take the height of the ordering itself, which is exactly
/// equal where parts touch.
void add_corner_vertices(const SolvedSurface& surface, const SheetSurface& sheets,
                         ModelBuilder& builder) {
  const LayeredMesh& mesh = surface.mesh;
  for (size_t v = 0; v < sheets.vertex_node.size(); ++v) {
    const int node = sheets.vertex_node[v];
    const auto [face, corner] = sheets.vertex_corner[v];
    builder.add_vertex(mesh.vertices[mesh.node_vertex[node]], surface.ordering.h[node],
                       surface_normal(corner_sample(surface, face, corner)));
  }
}

/// Adds the cuts of edge e, which runs from corner `first` to corner `last` of one face, with the
/// normals of that face.
void add_cuts_of(const CutSurface& surface, size_t e, FaceEdge first, FaceEdge last,
                 ModelBuilder& builder) {
  const LayeredMesh& mesh = surface.solved.mesh;
  const auto position = [&](FaceEdge at) {
    return mesh.vertices[mesh.node_vertex[mesh.faces[at.face][at.corner]]];
  };
  const SurfaceSample from = corner_sample(surface.solved, first.face, first.corner);
  const SurfaceSample to = corner_sample(surface.solved, last.face, last.corner);
  for (int i = surface.cuts.begin[e]; i < surface.cuts.begin[e + 1]; ++i) {
    const double t = surface.cuts.t[i];
    const SurfaceSample sample = interpolate(from, to, t);
    builder.add_vertex((1 - t) * position(first) + t * position(last), height(sample),
                       surface_normal(sample));
  }
}

void add_cut_vertices(const CutSurface& surface, ModelBuilder& builder) {
  const size_t edges = surface.sheets.edge_owner.size();
  for (size_t e = 0; e < edges; ++e) {
    const auto [face, corner] = surface.sheets.edge_owner[e];
    add_cuts_of(surface, e, {face, next_place(corner)}, {face, last_place(corner)}, builder);
  }
  for (size_t e = 0; e < edges; ++e) {
    if (surface.cuts.twin[e] < 0) continue;
    const auto [face, corner] = surface.sheets.edge_twin[e];
    add_cuts_of(surface, e, {face, last_place(corner)}, {face, next_place(corner)}, builder);
  }
}

/// Builds the faces that are kept and passes them to `finish`.
template <class Finish>
Status build_faces(const SolvedSurface& solved, const ModelOptions& options,
                   const RunContext& context, Finish finish) {
  const auto& [mesh, inflation, ordering, scene] = solved;
  if (Status status = check_options(options); !status.ok()) return status;
  if (Status status = check_surface(solved); !status.ok()) return status;
  context.report("model", 0);
  const SheetSurface sheets = connect_faces(mesh, scene, ordering.crossing, options.visibility);
  if (context.cancelled()) return interrupted_error();
  const auto cuts = cut_edges(sheets, inflation, options);
  if (!cuts) return cuts.error();
  context.report("model", 0.3);
  const CutSurface surface{solved, sheets, *cuts};
  ModelBuilder builder(scene);
  builder.reserve(sheets.vertex_node.size() + cuts->t.size(),
                  mesh.faces.size() + 2 * cuts->t.size());
  add_corner_vertices(solved, sheets, builder);
  add_cut_vertices(surface, builder);
  const double hidden_depth = hidden_fraction * std::max(scene.width, scene.height);
  if (Status s = cut_faces(surface, hidden_depth, context, builder); !s) return s;
  context.report("model", 0.8);
  finish(surface, builder);
  context.report("model", 1);
  return Done{};
}

}  // namespace

Result<Model> assemble_model(const SolvedSurface& surface, const ModelOptions& options,
                             const RunContext& context) {
  Model model;
  const double weld_tolerance = weld_fraction * std::max(surface.scene.width, surface.scene.height);
  Status status =
      build_faces(surface, options, context, [&](const CutSurface& cut, ModelBuilder& builder) {
        close_open_edges(cut, weld_tolerance, builder);
        model = std::move(builder).build();
        drop_unused_vertices(model);
      });
  if (!status) return status.error();
  model.unfinished = true;
  return model;
}

Result<VisibleSheet> assemble_visible_sheet(const SolvedSurface& surface,
                                            const ModelOptions& options,
                                            const RunContext& context) {
  ModelOptions relief = options;
  relief.visibility = Visibility::relief;
  VisibleSheet sheet;
  Status status =
      build_faces(surface, relief, context, [&](const CutSurface& cut, ModelBuilder& builder) {
        for (const auto& [first, second] : cut.sheets.open_edges) {
          SheetStep& step = sheet.steps.emplace_back();
          append_edge_points(cut, first, false, step.first);
          append_edge_points(cut, second, true, step.second);
        }
        sheet.back = back_points(cut);
        sheet.model = std::move(builder).build();
      });
  if (!status) return status.error();
  return sheet;
}

}  // namespace relievo::relief
