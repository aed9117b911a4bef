#include "support/solid_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

namespace relievo {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Corner = std::array<float, 3>;

struct Soup {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<size_t>> triangles;
};

Soup read_soup(std::string_view stl) {
  Soup soup;
  std::map<Corner, size_t> numbers;
  uint32_t count = 0;
  std::memcpy(&count, stl.data() + 80, sizeof count);
  for (uint32_t t = 0; t < count; ++t) {
    std::vector<size_t>& triangle = soup.triangles.emplace_back();
    for (size_t k = 0; k < 3; ++k) {
      Corner corner{};
      std::memcpy(corner.data(), stl.data() + 84 + size_t{50} * t + 12 * (k + 1), sizeof corner);
      const auto [at, fresh] = numbers.try_emplace(corner, soup.points.size());
      if (fresh) soup.points.emplace_back(corner[0], corner[1], corner[2]);
      triangle.push_back(at->second);
    }
  }
  return soup;
}

int count_uneven(const Soup& soup) {
  std::map<std::array<size_t, 2>, int> uses;
  for (const std::vector<size_t>& t : soup.triangles)
    for (size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  int uneven = 0;
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge[1], edge[0]});
    if (count != 1 || back == uses.end() || back->second != 1) ++uneven;
  }
  return uneven;
}

Mesh mesh_of(const Soup& soup) {
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  return mesh;
}

void measure(Mesh& mesh, SolidCensus& census) {
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> crossing;
  pmp::self_intersections(mesh, std::back_inserter(crossing));
  census.self_intersections = static_cast<int>(crossing.size());
  auto component = mesh.add_property_map<Mesh::Face_index, size_t>("f:component").first;
  census.pieces = static_cast<int>(pmp::connected_components(mesh, component));
  const int euler = static_cast<int>(mesh.number_of_vertices()) -
                    static_cast<int>(mesh.number_of_edges()) +
                    static_cast<int>(mesh.number_of_faces());
  census.holes = census.pieces - euler / 2;
  if (CGAL::is_closed(mesh)) census.volume = pmp::volume(mesh);
}

}  // namespace

SolidCensus census_of_stl(std::string_view stl) {
  const Soup soup = read_soup(stl);
  SolidCensus census;
  census.triangles = static_cast<int>(soup.triangles.size());
  census.uneven = count_uneven(soup);
  census.manifold = pmp::is_polygon_soup_a_polygon_mesh(soup.triangles);
  if (!census.manifold) return census;
  Mesh mesh = mesh_of(soup);
  measure(mesh, census);
  return census;
}

SolidCensus shared_by_stl(std::string_view one, std::string_view other) {
  Mesh first = mesh_of(read_soup(one));
  Mesh second = mesh_of(read_soup(other));
  Mesh shared;
  SolidCensus census;
  census.manifold = pmp::corefine_and_compute_intersection(first, second, shared);
  shared.collect_garbage();
  census.triangles = static_cast<int>(shared.number_of_faces());
  measure(shared, census);
  return census;
}

std::string what_is_wrong(const SolidCensus& census) {
  if (census.triangles == 0) return "it has no triangles";
  if (census.uneven > 0) return std::to_string(census.uneven) + " edges without two triangles";
  if (!census.manifold) return "it is no manifold";
  if (census.self_intersections > 0)
    return std::to_string(census.self_intersections) + " pairs of triangles cross";
  return census.volume > 0 ? "" : "its volume is " + std::to_string(census.volume);
}

std::string admesh_complaints(const std::string& path) {
  FILE* pipe = popen(("admesh '" + path + "' 2>&1").c_str(), "r");
  if (pipe == nullptr) return "admesh cannot be run";
  std::string text;
  std::array<char, 4096> buffer{};
  for (size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), n);
  if (pclose(pipe) != 0) return "admesh failed: " + text;
  for (const char* fault :
       {"Total disconnected facets        :", "Degenerate facets     :", "Edges fixed           :",
        "Facets removed        :", "Facets added          :", "Facets reversed       :",
        "Backwards edges       :"}) {
    const size_t at = text.find(fault);
    if (at == std::string::npos) return std::string("admesh does not tell ") + fault;
    const std::string line = text.substr(at, text.find('\n', at) - at);
    if (line.find_first_of("123456789", std::strlen(fault)) != std::string::npos) return line;
  }
  return "";
}

}  // namespace relievo
