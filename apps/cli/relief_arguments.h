#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds how fine the mesh is.
void add_mesh_options(CLI::App& app, ReliefArguments& relief);

/// Adds the mesh, the method and the shape of the parts.
void add_relief_options(CLI::App& app, ReliefArguments& relief);

/// Adds which surface a model holds, and what a solid is and stands on.
void add_visibility(CLI::App& app, ReliefArguments& relief);

}  // namespace relievo::cli
