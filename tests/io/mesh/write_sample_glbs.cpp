#include <cstdio>
#include <filesystem>

#include "io/mesh/glb_encode.h"
#include "relievo/files.h"
#include "support/sample_models.h"

namespace {

using namespace relievo;

/// Two parts and a pit with names that need escaping.
Model composite() {
  Model model = empty_model(200, 150);
  add_ellipsoid(model, {"body \"Ω\"\n", {90, 80}, 0, {70, 50, 40}});
  add_ellipsoid(model, {"", {120, 60}, 20, {30, 30, 30}});
  add_ellipsoid(model, {"\xff not UTF-8", {60, 80}, 0, {12, 9, -8}});
  return model;
}

}  // namespace

/// Writes GLB files for the validator into the folder given as the only argument.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const Drawing drawing = quarters();
  Model unused_vertices = hemisphere(20);
  unused_vertices.positions.push_back({0, 0, 0});
  unused_vertices.normals.push_back({0, 0, 0});
  unused_vertices.uvs.push_back({0, 0});
  Model inked = composite();
  inked.ink = ink_rectangle({20, 30}, {90, 40}, 50, false);
  const Status status = write_files({
      {folder / "plain.glb", *encode_glb(split_hemisphere(10), nullptr)},
      {folder / "textured.glb", *encode_glb(composite(), &drawing, {.size_mm = 250})},
      {folder / "large.glb", *encode_glb(hemisphere(100, 190), &drawing)},
      {folder / "inked.glb", *encode_glb(inked, &drawing)},
      {folder / "unused.glb", *encode_glb(unused_vertices, &drawing)},
  });
  if (!status.ok()) std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
  return status.ok() ? 0 : 1;
}
