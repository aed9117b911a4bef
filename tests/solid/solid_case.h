#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "io/mesh/placement.h"
#include "io/mesh/stl_encode.h"
#include "relief/session/build_relief.h"
#include "relief/surface/assemble_model.h"
#include "solid/make_solid.h"

namespace relievo {

/// Makes a solid without mirrored limbs.
inline Result<Solid> make_solid(const relief::VisibleSheet& sheet, const Drawing& drawing,
                                const SolidOptions& options) {
  return make_solid(sheet, {}, drawing, options);
}

}  // namespace relievo

namespace relievo::testing {

/// The drawings of a folder that have layers, SVG or a folder of pictures with their list, by name;
/// none where it is absent.
inline std::vector<std::string> drawings_in(const std::string& folder) {
  std::vector<std::string> paths;
  if (!std::filesystem::exists(folder)) return paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".svg" || std::filesystem::exists(entry.path() / "layers.tsv"))
      paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

inline relief::VisibleSheet sheet_of(const Scene& scene, const relief::Relief& relief) {
  auto sheet =
      relief::assemble_visible_sheet({relief.layers, relief.inflation, relief.ordering, scene}, {});
  EXPECT_TRUE(sheet.ok()) << (sheet.ok() ? "" : to_string(sheet.error()));
  return sheet.ok() ? std::move(*sheet) : relief::VisibleSheet{};
}

inline Result<relief::Relief> relief_of(const Scene& scene, int vertices, bool hidden) {
  relief::ReliefOptions options;
  options.layers.vertex_budget = vertices;
  options.hidden = hidden;
  return relief::build_relief(scene, options);
}

inline relief::VisibleSheet sheet_of(const Scene& scene, int vertices, bool hidden = false) {
  const auto relief = relief_of(scene, vertices, hidden);
  EXPECT_TRUE(relief.ok()) << (relief.ok() ? "" : to_string(relief.error()));
  return relief.ok() ? sheet_of(scene, *relief) : relief::VisibleSheet{};
}

inline std::string stl_of(const Model& model) {
  const auto stl = encode_stl(model, longest_side(model));
  EXPECT_TRUE(stl.ok());
  return stl.ok() ? std::string(stl->begin(), stl->end()) : "";
}

}  // namespace relievo::testing
