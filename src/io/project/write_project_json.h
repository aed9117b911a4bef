#pragma once

#include <string>

#include "io/project/project.h"

namespace relievo {

/// Returns the text of project.json. The scene, the labels and the drawing's bytes are entries of
/// their own.
std::string write_project_json(const Project& project);

}  // namespace relievo
