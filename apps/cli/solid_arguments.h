#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds the profile, and what a solid is and stands on.
void add_solid_options(CLI::App& app, ReliefArguments& relief);

}  // namespace relievo::cli
