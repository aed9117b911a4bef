#pragma once

#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "research/rivals/rival.h"

namespace relievo::research {

struct CompareArguments {
  cli::CommonArguments common;
  cli::ReliefArguments relief;  ///< of which only the options of the mesh are used
  std::string method;           ///< name of a rival
  RivalOptions options;
  std::vector<std::string> models;  ///< .glb, .obj, .ply, .stl
  std::string graft_mask;           ///< file; empty: none
  std::string normal_map;           ///< files; empty: not wanted
  std::string depth_map;
  std::string preview;
  std::string report;
  int map_size = 1024;  ///< longest side of the maps, px
};

/// Parses the arguments of relievo-compare.
cli::ParsedArguments parse_compare(int argc, const char* const* argv);

}  // namespace relievo::research
