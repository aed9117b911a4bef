#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds the options for the resolution of the mesh.
void add_mesh_options(CLI::App& app, ReliefArguments& relief);

/// Adds the options for the mesh, the method and the shape of the parts.
void add_relief_options(CLI::App& app, ReliefArguments& relief);

/// Adds --visible, and the options of solids.
void add_visibility(CLI::App& app, ReliefArguments& relief);

/// Adds --profile and the options of solids and their bases.
void add_solid_options(CLI::App& app, ReliefArguments& relief);

}  // namespace relievo::cli
