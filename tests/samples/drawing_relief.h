#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "io/svg/read_svg.h"
#include "support/probe.h"

namespace relievo::testing {

/// A drawing with its scene and its relief.
struct DrawnRelief {
  std::string bytes;
  Scene scene;
  Relief relief;
};

inline std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline DrawnRelief relief_of(const std::string& path, const ReliefOptions& options) {
  DrawnRelief drawn;
  drawn.bytes = read_text(path);
  const auto import = read_svg(drawn.bytes);
  EXPECT_TRUE(import.ok()) << path << ": " << (import.ok() ? "" : to_string(import.error()));
  if (!import.ok()) return drawn;
  drawn.scene = import->scene;
  drawn.relief = relief_of(drawn.scene, options);
  return drawn;
}

}  // namespace relievo::testing
