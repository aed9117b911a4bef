#pragma once

#include <string>
#include <vector>

#include "relievo/bytes.h"

namespace relievo {

/// What lib3mf says of a 3MF package.
struct ThreemfCensus {
  bool readable = false;
  std::vector<std::string> warnings;
  int objects = 0;
  int triangles = 0;
  bool manifold = true;  ///< all objects, and oriented
};

ThreemfCensus census_of_3mf(const Bytes& package);

}  // namespace relievo
