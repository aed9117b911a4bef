#include "apps/cli/segment_project.h"

#include <filesystem>

namespace relievo::cli {

Project project_of(const SegmentInput& input, const Understanding& understanding) {
  Project project;
  project.name =
      input.name.empty() ? std::filesystem::path(input.drawing.name).stem().string() : input.name;
  project.drawing = input.drawing;
  project.segmentation = understanding.record;
  project.scene = understanding.scene;
  project.scene.drawing = "drawing";
  project.other_keys = input.other_keys;
  return project;
}

}  // namespace relievo::cli
