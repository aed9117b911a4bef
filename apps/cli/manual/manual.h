#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace relievo::cli {

/// The manual page (groff's man macros) of the program, or of a command of it, which is what
/// `--help` says. Precondition: `command` is empty or one of them.
std::string man_page(const CLI::App& program, const std::string& command);

/// What makes a shell complete commands, options and their values: bash, zsh or fish.
std::string completions(const CLI::App& program, const std::string& shell);

/// The pieces of a help text: its first sentence, all before the examples, and these, a line each.
struct HelpText {
  std::string summary;
  std::string description;
  std::vector<std::string> examples;
};
HelpText split_help(const std::string& help);

/// Commands and options that help shows.
std::vector<const CLI::App*> shown_commands(const CLI::App& program);
std::vector<const CLI::Option*> shown_options(const CLI::App& command);

/// "-o", "--output" and so on.
std::vector<std::string> dashed_names(const CLI::Option& option);

std::string joined(const std::vector<std::string>& words, const char* between);

/// What may follow an option: nothing (a flag), one of some words, a number, or anything.
struct OptionValue {
  enum class Kind { none, word, number, text } kind = Kind::none;
  std::vector<std::string> words;
  std::string said;  ///< as help says it: "approximate|nonlinear", "INT in [1 - 256]"
};
OptionValue value_of(const CLI::Option& option);

}  // namespace relievo::cli
