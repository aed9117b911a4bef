#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace relievo::cli {

/// Returns the manual page of the program, or of one of its commands, in groff's man macros. It has
/// the contents of `--help`. Precondition: `command` is empty or the name of a command.
std::string man_page(const CLI::App& program, const std::string& command);

}  // namespace relievo::cli
