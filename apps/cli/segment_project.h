#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/project/project.h"
#include "relief/pipeline/understand_drawing.h"

namespace relievo::cli {

/// A flat drawing and what is known of it.
struct SegmentInput {
  std::string drawing_file;  ///< its path or "-"; empty where it is inside a project or made here
  ProjectDrawing drawing;    ///< the artist's own file, or the picture of their vectors
  Image8 pixels;             ///< of the drawing, RGBA
  SegmentationRecord record;
  std::string name;                               ///< of the project; empty where there was none
  Scene scene;                                    ///< likewise
  std::map<std::string, std::string> other_keys;  ///< of the project, which come along
  std::vector<std::vector<Point2>> bridges;       ///< gaps in the lines that were closed, px
  std::vector<std::string> notes;                 ///< what a person should know
};

/// The project that keeps the drawing and what was understood of it.
Project project_of(const SegmentInput& input, const Understanding& understanding);

}  // namespace relievo::cli
