#include "apps/cli/manual/help_text.h"

#include <sstream>

namespace relievo::cli {
namespace {

/// Returns the words of "TEXT:{a,b}"; none if there are no braces.
std::vector<std::string> words_in_braces(const std::string& type) {
  const size_t open = type.find('{');
  const size_t close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

}  // namespace

HelpText split_help(const std::string& help) {
  HelpText text;
  const size_t examples = help.find("\n\nExamples:\n");
  for (const char c : help.substr(0, examples)) text.description += c == '\n' ? ' ' : c;
  const size_t sentence = std::min(text.description.find(". "), text.description.find(": "));
  text.summary = text.description.substr(0, sentence);
  if (!text.summary.empty() && text.summary.back() == '.') text.summary.pop_back();
  if (examples == std::string::npos) return text;
  std::istringstream lines(help.substr(examples + 2));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line))
    text.examples.push_back(line.substr(line.find_first_not_of(' ')));
  return text;
}

std::vector<const CLI::App*> shown_commands(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App* command) {
    return !command->get_group().empty() && !command->get_name().empty();
  });
}

std::vector<const CLI::Option*> shown_options(const CLI::App& command) {
  auto options = command.get_options([](const CLI::Option* option) {
    return option->nonpositional() && !option->get_group().empty();
  });
  // CLI11 represents a group of options as a command without a name.
  for (const CLI::App* group :
       command.get_subcommands([](const CLI::App* sub) { return sub->get_name().empty(); }))
    for (const CLI::Option* option : shown_options(*group)) options.push_back(option);
  return options;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> dashed_names(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

OptionValue value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  const std::string type = option.get_type_name();
  OptionValue value{OptionValue::Kind::text, words_in_braces(type),
                    type.substr(type.find(':') + 1)};
  if (type.starts_with("INT") || type.starts_with("FLOAT")) value.kind = OptionValue::Kind::number;
  if (value.words.empty()) return value;
  value.kind = OptionValue::Kind::word;
  value.formatted = joined(value.words, "|");
  return value;
}

}  // namespace relievo::cli
