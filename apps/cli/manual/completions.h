#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace relievo::cli {

/// What makes a shell complete commands, options and their values: bash, zsh or fish.
std::string completions(const CLI::App& program, const std::string& shell);

}  // namespace relievo::cli
