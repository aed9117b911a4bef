#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo::testing {

/// A named set of rings from a corpus of difficult polygons.
struct CorpusPolygon {
  std::string name;
  Outline rings;
};

inline std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                   const std::string& extension) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// earcut's fixtures: [[[x, y], ...], [hole], ...].
inline std::vector<CorpusPolygon> earcut_polygons(const std::filesystem::path& folder) {
  std::vector<CorpusPolygon> polygons;
  for (const auto& file : files_in(folder, ".json")) {
    std::ifstream in(file);
    const nlohmann::json json = nlohmann::json::parse(in);
    if (!json.is_array()) continue;
    CorpusPolygon polygon{file.filename().string(), {}};
    for (const auto& ring : json) {
      polygon.rings.emplace_back();
      for (const auto& point : ring)
        polygon.rings.back().push_back({point[0].get<double>(), point[1].get<double>()});
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

/// CDT's inputs: counts, vertices, edges. The rings are the maximal chains of consecutive edges,
/// closed, and all vertices in order as one more.
inline std::vector<CorpusPolygon> cdt_polygons(const std::filesystem::path& folder) {
  std::vector<CorpusPolygon> polygons;
  for (const auto& file : files_in(folder, ".txt")) {
    std::ifstream in(file);
    size_t vertices = 0;
    size_t edges = 0;
    if (!(in >> vertices >> edges)) continue;
    Ring points(vertices);
    for (Point2& p : points) in >> p.x >> p.y;
    CorpusPolygon polygon{file.filename().string(), {points}};
    size_t end = vertices;
    for (size_t e = 0; e < edges; ++e) {
      size_t a = 0;
      size_t b = 0;
      in >> a >> b;
      if (a >= vertices || b >= vertices) continue;
      if (a != end) polygon.rings.push_back({points[a]});
      polygon.rings.back().push_back(points[b]);
      end = b;
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

/// Clipper2's cases: captions followed by paths, one a line, "x,y, x,y, ...".
inline std::vector<CorpusPolygon> clipper_polygons(const std::filesystem::path& file) {
  std::vector<CorpusPolygon> polygons;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("CAPTION", 0) == 0) polygons.push_back({line, {}});
    if (line.empty() || polygons.empty() || (line[0] != '-' && std::isdigit(line[0]) == 0))
      continue;
    for (char& c : line) c = c == ',' ? ' ' : c;
    std::istringstream numbers(line);
    Ring ring;
    for (Point2 p; numbers >> p.x >> p.y;) ring.push_back(p);
    polygons.back().rings.push_back(std::move(ring));
  }
  return polygons;
}

}  // namespace relievo::testing
