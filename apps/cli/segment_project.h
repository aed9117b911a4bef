#pragma once

#include <string>
#include <vector>

#include "io/project/project.h"
#include "relief/pipeline/propose_scene.h"

namespace relievo::cli {

/// A flat drawing, its labels and what the user says about them.
struct SegmentInput {
  std::string file;        ///< as given on the command line
  ProjectDrawing drawing;  ///< the artist's own file
  Image8 pixels;           ///< of the drawing, RGBA
  Image16 labels;
  Scribbles scribbles;
  Corrections corrections;
  std::vector<std::vector<Point2>> bridges;  ///< gaps in the lines that were closed, px
  std::vector<std::string> notes;            ///< what a person should know
};

/// The project that keeps the drawing, what the user said and what was proposed.
Project project_of(const SegmentInput& input, const Proposal& proposal);

}  // namespace relievo::cli
