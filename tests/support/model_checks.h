#pragma once

#include <vector>

#include "relievo/model.h"
#include "support/analytic_discs.h"

namespace relievo {

/// How triangles meet along edges. An edge is an unordered pair of vertices.
struct EdgeCensus {
  int edges = 0;
  int open = 0;      ///< edges run through more often one way than the other
  int crowded = 0;   ///< edges of more than two triangles
  int repeated = 0;  ///< edges that two triangles run through the same way
  std::vector<std::array<int, 2>> open_edges;  ///< vertices as in the model
};

/// Counts by vertex index, or after vertices at exactly the same place were merged.
EdgeCensus count_edges(const Model& model, bool merge_places);

/// Where a relief is open, after vertices at exactly the same place were merged.
struct SilhouetteCensus {
  int outline = 0;    ///< edges of the base triangulation with one triangle
  int along = 0;      ///< open edges of the model that are not upright
  int elsewhere = 0;  ///< open edges that do not join points over that outline
};

SilhouetteCensus count_silhouette(const Model& model, const relief::LayeredMesh& mesh);

/// Triangles that are not vertical walls, by part or of all parts (-1).
std::vector<std::array<int, 3>> sheet_triangles(const Model& model, int part = -1);

bool is_wall(const Model& model, const std::array<int, 3>& triangle);

/// Area of the orthographic front view of the given triangles, px^2.
double front_area(const Model& model, const std::vector<std::array<int, 3>>& triangles);

/// Worst |z - (g + sgn(u) sqrt|u|)| over samples of the sheets of a model of `relief`, with u and
/// g interpolated on the faces of `part`. Includes the middles of all edges.
double worst_departure(const Model& model, const DiscRelief& relief, int part);

/// All numbers of the model as bytes.
std::vector<unsigned char> model_bytes(const Model& model);

}  // namespace relievo
