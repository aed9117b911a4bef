#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace relievo::cli {

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
