#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "io/scene/read_scene.h"
#include "io/svg/read_svg.h"
#include "relief/pipeline/build_relief.h"
#include "support/probe.h"
#include "support/random_limbs.h"
#include "support/regions.h"
#include "support/seams.h"

// Prints how sharp the joins of drawings are and how deep the pits at their ends.
// Usage: joins VERTICES approximate|nonlinear DRAWING|SEED|FIRST-LAST...

namespace relievo {
namespace {

std::string read_file(const std::string& name) {
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::optional<Scene> read_drawing(const std::string& name) {
  const std::string bytes = read_file(name);
  if (name.size() > 4 && name.substr(name.size() - 4) == ".svg") {
    auto drawing = read_svg(bytes);
    if (drawing) return drawing->scene;
    return std::nullopt;
  }
  if (bytes.find("\"regions\"") != std::string::npos) return testing::read_regions(name);
  auto scene = read_scene(bytes);
  if (scene) return *scene;
  return std::nullopt;
}

struct Worst {
  double median = 0;
  double most = 0;
  double pit = 0;
  double bump = 0;
  int joins = 0;
  int sharp = 0;
};

void study(const std::string& name, const Scene& scene, const ReliefOptions& options,
           Worst& worst) {
  const Result<Relief> relief = build_relief(scene, options);
  if (!relief) {
    std::printf("%s: %s\n", name.c_str(), to_string(relief.error()).c_str());
    return;
  }
  const LayeredMesh& mesh = relief->layers;
  if (std::getenv("ALONE")) {
    Scene apart = scene;
    apart.joins.clear();
    const Result<Relief> alone = build_relief(apart, options);
    for (const testing::SeamChain& chain : testing::seam_chains(mesh)) {
      int lower = -1;
      for (const Join& j : scene.joins)
        if (j.upper == chain.upper) lower = j.lower;
      std::printf("%s,%s", name.c_str(), scene.parts[chain.upper].id.c_str());
      for (int end : {chain.nodes.front(), chain.nodes.back()}) {
        const Point2 p = mesh.vertices[mesh.node_vertex[end]];
        const double fa = alone.ok() ? testing::probe(*alone, p, lower).f : 0;
        std::printf(",%.1f %.1f %.1f -> %.1f %%", fa, signed_root(relief->inflation.u[end]),
                    relief->ordering.h[end],
                    100 * (fa - relief->ordering.h[end]) / chain.length.back());
      }
      std::printf("\n");
    }
  }
  for (const testing::SeamChain& chain : testing::seam_chains(mesh)) {
    const std::vector<double> angles = testing::seam_angles(mesh, relief->ordering.h, chain);
    std::vector<double> heights = relief->ordering.h;
    const std::vector<double> pits = testing::pits(mesh, heights, chain);
    for (double& height : heights) height = -height;
    const std::vector<double> bumps = testing::pits(mesh, heights, chain);
    const double median = angles.empty() ? 0 : angles[angles.size() / 2];
    const double most = angles.empty() ? 0 : angles.back();
    std::printf("%s,%s,%zu,%.0f,%.2f,%.2f,%.1f,%.1f,%.1f,%.1f\n", name.c_str(),
                scene.parts[chain.upper].id.c_str(), chain.nodes.size(), chain.length.back(),
                median, most, 100 * pits[0], 100 * pits[1], 100 * bumps[0], 100 * bumps[1]);
    ++worst.joins;
    worst.sharp += most > 2;
    worst.median = std::max(worst.median, median);
    worst.most = std::max(worst.most, most);
    for (const double pit : pits) worst.pit = std::max(worst.pit, pit);
    for (const double bump : bumps) worst.bump = std::max(worst.bump, bump);
  }
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr,
                 "usage: joins VERTICES approximate|nonlinear DRAWING|SEED|FIRST-LAST...\n");
    return 2;
  }
  relievo::ReliefOptions options;
  options.layers.vertex_budget = std::atoi(argv[1]);
  if (argv[2][0] == 'n') options.method = relievo::Method::nonlinear;
  if (const char* value = std::getenv("ALPHA0")) options.inflation.alpha0 = std::atof(value);
  if (const char* value = std::getenv("RHO")) options.inflation.rho = std::atof(value);
  std::printf("drawing,part,nodes,length,median,most,pit first %%,pit last %%\n");
  relievo::Worst worst;
  for (int k = 3; k < argc; ++k) {
    const std::string name = argv[k];
    if (name.find_first_not_of("0123456789-") == std::string::npos) {
      const size_t dash = name.find('-');
      const int first = std::stoi(name);
      const int last = dash == std::string::npos ? first : std::stoi(name.substr(dash + 1));
      for (int seed = first; seed <= last; ++seed)
        relievo::study("limbs " + std::to_string(seed), relievo::testing::random_limbs(seed),
                       options, worst);
      continue;
    }
    const auto scene = relievo::read_drawing(name);
    if (!scene) {
      std::fprintf(stderr, "%s cannot be read\n", name.c_str());
      return 1;
    }
    relievo::study(name, *scene, options, worst);
  }
  std::printf(
      "%d joins, %d sharper than 2; worst median %.2f, most %.2f degrees; pit %.1f, bump %.1f %%\n",
      worst.joins, worst.sharp, worst.median, worst.most, 100 * worst.pit, 100 * worst.bump);
  return 0;
}
