#include <cstdio>

#include "io/scene/read_scene.h"
#include "relief/pipeline/build_relief.h"

namespace {

constexpr const char* two_squares = R"({
  "format": "relievo-scene", "version": 1, "canvas": { "width": 100, "height": 100 },
  "parts": [
    { "id": "lower", "outline": [[[10,10],[70,10],[70,70],[10,70]]] },
    { "id": "upper", "outline": [[[40,40],[90,40],[90,90],[40,90]]] } ] })";

int fail(const relievo::Error& error) {
  std::fprintf(stderr, "%s\n", relievo::to_string(error).c_str());
  return 1;
}

}  // namespace

int main() {
  const auto scene = relievo::read_scene(two_squares);
  if (!scene) return fail(scene.error());
  relievo::ReliefOptions options;
  options.layers.vertex_budget = 2000;
  const auto relief = relievo::build_relief(*scene, options);
  if (!relief) return fail(relief.error());
  std::printf("%zu\n", relief->ordering.h.size());
  return relief->ordering.h.size() > 1000 ? 0 : 1;
}
