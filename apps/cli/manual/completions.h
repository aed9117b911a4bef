#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace relievo::cli {

/// Returns the script with which bash, zsh or fish completes commands, options and their values.
std::string completions(const CLI::App& program, const std::string& shell);

}  // namespace relievo::cli
