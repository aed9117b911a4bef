#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// Help for the input of commands that take drawings.
inline constexpr const char* input_help =
    "Layered drawing (SVG, OpenRaster, PSD, a folder of pictures), flat picture (PNG, JPEG, GIF), "
    "project or scene file (JSON); - reads standard input";

/// Adds the input, with `help`, and the options of every command.
void add_common(CLI::App& app, CommonArguments& common, const char* help);

/// Adds the options of every command: --quiet, --timeout and --threads.
void add_run_options(CLI::App& app, CommonArguments& common);

/// Adds --connect.
void add_connect(CLI::App& app, CommonArguments& common);

/// Requires that a file name ends in one of the given extensions.
CLI::Validator extension(const std::vector<std::string>& allowed);

}  // namespace relievo::cli
