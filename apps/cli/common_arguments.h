#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"

namespace relievo::cli {

/// What commands that take drawings say of their input.
inline constexpr const char* input_help =
    "Layered drawing (SVG, OpenRaster, PSD, a folder of pictures), flat picture (PNG, JPEG, GIF), "
    "project or scene file (JSON); - reads standard input";

/// Adds the input, `what` being its help, and what all commands take.
void add_common(CLI::App& app, CommonArguments& common, const char* what);

/// Adds what all commands take but the input.
void add_run_options(CLI::App& app, CommonArguments& common);

/// Adds how the parts of layered drawings connect.
void add_connect(CLI::App& app, CommonArguments& common);

/// A usage error where the file's extension is none of those given.
CLI::Validator extension(const std::vector<std::string>& allowed);

}  // namespace relievo::cli
