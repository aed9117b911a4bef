#pragma once

#include <string>
#include <vector>

#include "relief/layers/boundaries.h"
#include "relief/layers/connect_sheets.h"
#include "relief/layers/sheets.h"

namespace relievo {

/// All parts on one triangulation, joined: what the outlines and joins decide.
struct JoinedSheets {
  BaseMesh base;
  Sheets sheets;
  Loops loops;
  Connection connection;
  std::vector<LoopRun> robin;            ///< per Robin range of the scene
  std::vector<LoopRun> relation_ranges;  ///< per relation with a range
  std::vector<DepthPair> copies;         ///< nodes that were split to keep the mesh manifold
  std::vector<CreaseEdge> creases;
  double edge_length = 0;  ///< spacing of the outlines, px
  std::vector<std::string> warnings;
};

}  // namespace relievo
