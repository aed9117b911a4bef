#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace relievo::cli {

/// The manual page (groff's man macros) of the program, or of a command of it, which is what
/// `--help` says. Precondition: `command` is empty or one of them.
std::string man_page(const CLI::App& program, const std::string& command);

}  // namespace relievo::cli
