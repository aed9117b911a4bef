#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"

namespace relievo::testing {

/// Converts a file of named polygons with "open" closing edges into a scene: every open edge of a
/// region in front of the body is a join with the part that contains its middle; regions behind
/// the body stay apart. Empty where the file is absent.
inline std::optional<Scene> read_regions(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return std::nullopt;
  const nlohmann::json json = nlohmann::json::parse(in);
  Scene scene;
  scene.width = json["canvas"][0].get<double>();
  scene.height = json["canvas"][1].get<double>();
  for (const auto& region : json["regions"]) {
    Part part;
    part.id = region["name"].get<std::string>();
    part.outline.emplace_back();
    for (const auto& p : region["polygon"])
      part.outline[0].push_back({p[0].get<double>(), p[1].get<double>()});
    scene.parts.push_back(part);
  }
  for (size_t upper = 0; upper < scene.parts.size(); ++upper)
    for (const auto& open : json["regions"][upper]["open"]) {
      const Ring& ring = scene.parts[upper].outline[0];
      const Point2 a = ring[open[0].get<size_t>()];
      const Point2 b = ring[open[1].get<size_t>()];
      int lower = static_cast<int>(upper) - 1;
      while (lower >= 0 && !contains(scene.parts[lower].outline, 0.5 * (a + b))) --lower;
      if (lower >= 0) scene.joins.push_back({static_cast<int>(upper), lower, {a, b}});
    }
  return scene;
}

}  // namespace relievo::testing
