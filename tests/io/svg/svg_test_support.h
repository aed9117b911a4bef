#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/svg/read_svg.h"
#include "io/svg/svg_drawing.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// An <svg> of 1000 x 1000 px with the content, and with attributes for the root.
std::string svg_file(const std::string& content, const std::string& attributes = "");

/// The flattened drawing of a file that must be readable.
SvgDrawing drawing_of(const std::string& file);

/// A file with its parts (see make_parts).
Result<understanding::LayeredDrawing> read_parts(const std::string& file,
                                                 const SvgOptions& options = {});

/// The parts of a file that must have some.
understanding::LayeredDrawing import_of(const std::string& file);

/// What a renderer paints of a file.
Result<Drawing> painted_svg(const std::string& file, int width, int height);

/// What the only shape of the content fills on the canvas of svg_file.
Region fill_of_only_shape(const std::string& content);

std::string file_bytes(const std::filesystem::path& path);

/// All files with the extension below the folder, sorted; empty where there is no such folder.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               const std::string& extension);

}  // namespace relievo
