#include "apps/cli/manual/completions.h"

#include "apps/cli/manual/help_text.h"

namespace relievo::cli {
namespace {

using Kind = OptionValue::Kind;

/// Puts a backslash before each character of `special`.
std::string guarded(const std::string& text, const std::string& special) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) out += '\\';
    out += c;
  }
  return out;
}

/// Puts the text in single quotes.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return "'" + out + "'";
}

std::string summary(const CLI::App& command) {
  return split_help(command.get_description()).summary;
}

std::string bash(const CLI::App& program) {
  std::vector<std::string> names;
  std::string values;
  std::string options;
  for (const CLI::App* command : shown_commands(program)) {
    const std::string& name = command->get_name();
    names.push_back(name);
    std::vector<std::string> words;
    for (const CLI::Option* option : shown_options(*command)) {
      for (const std::string& word : dashed_names(*option)) words.push_back(word);
      if (const OptionValue value = value_of(*option); value.kind == Kind::word)
        values += "    " + name + ":" + joined(dashed_names(*option), ("|" + name + ":").c_str()) +
                  ") words=\"" + joined(value.words, " ") + "\" ;;\n";
    }
    options += "    " + name + ":-*) words=\"" + joined(words, " ") + "\" ;;\n";
  }
  return R"(_relievo() {
  local current="${COMP_WORDS[COMP_CWORD]}" words=""
  [ "$COMP_CWORD" -gt 1 ] || words=")" +
         joined(names, " ") + R"( --help --version"
  case "${COMP_WORDS[1]}:$current" in
)" + options +
         R"(  esac
  case "${COMP_WORDS[1]}:${COMP_WORDS[COMP_CWORD - 1]}" in
)" + values +
         R"(  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o default -F _relievo relievo
)";
}

std::string zsh_option(const CLI::Option& option) {
  const OptionValue value = value_of(option);
  std::string tail = "[" + guarded(option.get_description(), "[]:\\") + "]";
  if (value.kind == Kind::word) tail += ":value:(" + joined(value.words, " ") + ")";
  if (value.kind == Kind::number) tail += ":number:";
  if (value.kind == Kind::text) tail += ":file:_files";
  std::string text;
  for (const std::string& name : dashed_names(option))
    text += " \\\n        " + quoted("*" + name + tail);
  return text;
}

std::string zsh(const CLI::App& program) {
  std::string names;
  std::string cases;
  for (const CLI::App* command : shown_commands(program)) {
    names += "    " + quoted(command->get_name() + ":" + guarded(summary(*command), ":")) + "\n";
    cases += "    " + command->get_name() + ")\n      _arguments";
    for (const CLI::Option* option : shown_options(*command)) cases += zsh_option(*option);
    cases += " \\\n        '*:file:_files' ;;\n";
  }
  return R"(#compdef relievo
_relievo() {
  local -a commands=(
)" + names +
         R"(  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  shift words
  ((CURRENT--))
  case $words[1] in
)" + cases +
         R"(  esac
}
_relievo "$@"
)";
}

std::string fish_option(const std::string& condition, const CLI::Option& option) {
  const OptionValue value = value_of(option);
  std::string text = "complete -c relievo -n " + quoted(condition);
  for (const std::string& name : option.get_snames()) text += " -s " + name;
  for (const std::string& name : option.get_lnames()) text += " -l " + name;
  if (value.kind == Kind::word) text += " -x -a " + quoted(joined(value.words, " "));
  if (value.kind == Kind::number) text += " -x";
  if (value.kind == Kind::text) text += " -r -F";
  return text + " -d " + quoted(guarded(option.get_description(), "\\")) + "\n";
}

std::string fish(const CLI::App& program) {
  std::string text;
  for (const CLI::App* command : shown_commands(program)) {
    const std::string& name = command->get_name();
    text += "complete -c relievo -n __fish_use_subcommand -f -a " + name + " -d " +
            quoted(summary(*command)) + "\n";
    for (const CLI::Option* option : shown_options(*command))
      text += fish_option("__fish_seen_subcommand_from " + name, *option);
  }
  return text;
}

}  // namespace

std::string completions(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return bash(program);
  return shell == "zsh" ? zsh(program) : fish(program);
}

}  // namespace relievo::cli
