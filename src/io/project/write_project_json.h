#pragma once

#include <string>

#include "io/project/project.h"

namespace relievo {

/// project.json without the scene, the labels and the drawing's bytes, which are entries of their
/// own.
std::string write_project_json(const Project& project);

}  // namespace relievo
