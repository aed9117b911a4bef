#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "io/layered/read_layer_folder.h"
#include "io/svg/read_svg.h"
#include "io/svg/render_svg.h"
#include "support/probe.h"
#include "understanding/marks/make_parts.h"
#include "understanding/scene/connect_scene.h"

namespace relievo::testing {

/// A drawing with its scene and its relief.
struct DrawnRelief {
  Scene scene;
  Drawing drawing;  ///< one pixel a px of the canvas
  relief::Relief relief;
};

inline std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline DrawnRelief drawn_svg(const std::string& path) {
  DrawnRelief drawn;
  const std::string bytes = read_text(path);
  auto import = read_svg(bytes);
  EXPECT_TRUE(import.ok()) << path << ": " << (import.ok() ? "" : to_string(import.error()));
  if (!import.ok()) return drawn;
  EXPECT_TRUE(understanding::make_parts(*import).ok()) << path;
  drawn.scene =
      understanding::connect_scene(import->scene, import->proposed, import->colors, import->anchors)
          .scene;
  const auto drawing = render_svg(import->paintable, static_cast<int>(drawn.scene.width),
                                  static_cast<int>(drawn.scene.height));
  EXPECT_TRUE(drawing.ok()) << path;
  if (drawing.ok()) drawn.drawing = *drawing;
  return drawn;
}

inline DrawnRelief drawn_folder(const std::string& path) {
  DrawnRelief drawn;
  std::vector<std::filesystem::path> files;
  auto import = read_layer_folder(path, files);
  EXPECT_TRUE(import.ok()) << path << ": " << (import.ok() ? "" : to_string(import.error()));
  if (!import.ok()) return drawn;
  EXPECT_TRUE(understanding::make_parts(*import).ok()) << path;
  drawn.scene = understanding::connect_scene(import->scene, import->proposed, import->colors).scene;
  drawn.drawing = import->picture;
  return drawn;
}

inline DrawnRelief relief_of(const std::string& path, const relief::ReliefOptions& options) {
  DrawnRelief drawn = std::filesystem::is_directory(path) ? drawn_folder(path) : drawn_svg(path);
  if (!drawn.scene.parts.empty()) drawn.relief = relief_of(drawn.scene, options);
  return drawn;
}

}  // namespace relievo::testing
