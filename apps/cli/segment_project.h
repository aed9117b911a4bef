#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/project/project.h"
#include "relief/pipeline/keep_edits.h"
#include "relief/pipeline/propose_scene.h"

namespace relievo::cli {

/// A flat drawing, its labels and what the user says about them.
struct SegmentInput {
  std::string drawing_file;  ///< its path or "-"; empty where it is inside a project or made here
  ProjectDrawing drawing;    ///< the artist's own file, or the picture of their vectors
  Image8 pixels;             ///< of the drawing, RGBA
  Image16 labels;
  Scribbles scribbles;
  std::string name;                               ///< of the project; empty where there was none
  EditedScene edited;                             ///< of the project
  std::map<std::string, std::string> other_keys;  ///< of the project, which come along
  Corrections corrections;
  std::vector<std::vector<Point2>> bridges;  ///< gaps in the lines that were closed, px
  std::vector<std::string> notes;            ///< what a person should know
};

/// The project that keeps the drawing, what the user said and what was proposed; `scene` is the
/// result.
Project project_of(const SegmentInput& input, const Proposal& proposal, const Scene& scene);

}  // namespace relievo::cli
