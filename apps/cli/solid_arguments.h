#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Adds --profile and the options of solids and their bases.
void add_solid_options(CLI::App& app, ReliefArguments& relief);

}  // namespace relievo::cli
