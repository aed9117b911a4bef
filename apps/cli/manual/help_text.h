#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace relievo::cli {

/// A help text: its first sentence, all text before the examples, and the examples, one per line.
struct HelpText {
  std::string summary;
  std::string description;
  std::vector<std::string> examples;
};

HelpText split_help(const std::string& help);

/// Return the commands and options that help shows.
std::vector<const CLI::App*> shown_commands(const CLI::App& program);

std::vector<const CLI::Option*> shown_options(const CLI::App& command);

/// Returns all names of an option, such as "-o" and "--output".
std::vector<std::string> dashed_names(const CLI::Option& option);

std::string joined(const std::vector<std::string>& words, const char* between);

/// The value of an option: none (a flag), one of several words, a number, or any text.
struct OptionValue {
  enum class Kind { none, word, number, text } kind = Kind::none;
  std::vector<std::string> words;
  std::string formatted;  ///< as in help: "approximate|nonlinear", "INT in [1 - 256]"
};

OptionValue value_of(const CLI::Option& option);

}  // namespace relievo::cli
