#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "io/scene/scene_json.h"
#include "io/svg/read_svg.h"
#include "relief/session/build_relief.h"
#include "support/random_limbs.h"
#include "support/regions.h"
#include "support/seams.h"
#include "understanding/marks/make_parts.h"

// Prints how sharp the joins of drawings are and what pits and bumps there are at their ends, in
// the drawing and where each join's two parts are alone.
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
    if (drawing && understanding::make_parts(*drawing)) return drawing->scene;
    return std::nullopt;
  }
  if (bytes.find("\"regions\"") != std::string::npos) return testing::read_regions(name);
  auto scene = read_scene(bytes);
  if (scene) return *scene;
  return std::nullopt;
}

/// Over all joins.
struct Tally {
  std::vector<double> medians;  ///< of the angles across each, degrees
  std::vector<double> largest;
  std::vector<double> pits;  ///< at each end, relative to the join's length
  std::vector<double> bumps;
  std::vector<double> pits_alone;  ///< where only the join's two parts are built
  std::vector<double> bumps_alone;
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// A row's columns for what stands at both ends.
void print_ends(const std::vector<double>& ends) {
  for (const double end : ends) std::printf(",%.1f", 100 * end);
}

void add(const std::vector<double>& ends, std::vector<double>& all) {
  all.insert(all.end(), ends.begin(), ends.end());
}

void study(const std::string& name, const Scene& scene, const relief::ReliefOptions& options,
           Tally& tally) {
  const Result<relief::Relief> relief = relief::build_relief(scene, options);
  if (!relief) {
    std::printf("%s: %s\n", name.c_str(), to_string(relief.error()).c_str());
    return;
  }
  const relief::LayeredMesh& mesh = relief->layers;
  for (const testing::SeamChain& chain : testing::seam_chains(mesh)) {
    const std::vector<double> angles = testing::seam_angles(mesh, relief->ordering.h, chain);
    const testing::JoinEnds ends = testing::join_ends(mesh, relief->ordering.h, chain);
    const testing::JoinEnds alone = testing::join_ends_alone(scene, mesh, chain, options);
    const double median = angles.empty() ? 0 : angles[angles.size() / 2];
    const double most = angles.empty() ? 0 : angles.back();
    std::printf("%s,%s,%zu,%.0f,%.2f,%.2f", name.c_str(), scene.parts[chain.upper].id.c_str(),
                chain.nodes.size(), chain.length.back(), median, most);
    for (const auto* values : {&ends.pits, &ends.bumps, &alone.pits, &alone.bumps})
      print_ends(*values);
    std::printf("\n");
    add(ends.pits, tally.pits);
    add(ends.bumps, tally.bumps);
    add(alone.pits, tally.pits_alone);
    add(alone.bumps, tally.bumps_alone);
    if (angles.empty()) continue;
    tally.medians.push_back(median);
    tally.largest.push_back(most);
  }
}

void print(const char* what, const std::vector<double>& values, double factor) {
  std::printf("%s: median %.2f, 90 %% %.2f, most %.2f\n", what, factor * quantile(values, 0.5),
              factor * quantile(values, 0.9), factor * quantile(values, 1));
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  using namespace relievo;
  if (argc < 4) {
    std::fprintf(stderr,
                 "usage: joins VERTICES approximate|nonlinear DRAWING|SEED|FIRST-LAST...\n");
    return 2;
  }
  relief::ReliefOptions options;
  options.layers.vertex_budget = std::atoi(argv[1]);
  if (argv[2][0] == 'n') options.method = Method::nonlinear;
  std::printf(
      "drawing,part,nodes,length,median,most,pit %%,pit %%,bump %%,bump %%,"
      "pit alone %%,pit alone %%,bump alone %%,bump alone %%\n");
  Tally tally;
  for (int k = 3; k < argc; ++k) {
    const std::string name = argv[k];
    if (name.find_first_not_of("0123456789-") == std::string::npos) {
      const size_t dash = name.find('-');
      const int last = std::stoi(dash == std::string::npos ? name : name.substr(dash + 1));
      for (int seed = std::stoi(name); seed <= last; ++seed)
        study("limbs " + std::to_string(seed), testing::random_limbs(seed), options, tally);
      continue;
    }
    const auto scene = read_drawing(name);
    if (!scene) {
      std::fprintf(stderr, "%s cannot be read\n", name.c_str());
      return 1;
    }
    study(name, *scene, options, tally);
  }
  print("angle across joins, median of each, degrees", tally.medians, 1);
  print("angle across joins, largest of each, degrees", tally.largest, 1);
  print("pits, % of the join's length", tally.pits, 100);
  print("bumps, % of the join's length", tally.bumps, 100);
  print("pits where its two parts are alone", tally.pits_alone, 100);
  print("bumps where its two parts are alone", tally.bumps_alone, 100);
  return 0;
}
