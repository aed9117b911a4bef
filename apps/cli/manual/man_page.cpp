#include "apps/cli/manual/man_page.h"

#include <cctype>

#include "apps/cli/manual/help_text.h"

namespace relievo::cli {
namespace {

constexpr const char* exit_codes = R"(.SH EXIT STATUS
0 success, 1 internal error (please report it), 2 usage error, 3 bad input, 4 contradictory
annotations, 5 limit exceeded, 6 file error, 130 interrupted.
)";

/// Escapes text for groff: hyphens stay hyphens, and no line is read as a request.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool starts_line = out.empty() || out.back() == '\n';
    if (starts_line && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Lower-cases the first letter, as the list of manual pages shows a sentence.
std::string uncapitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

std::string options(const CLI::App& app) {
  std::string text = ".SH OPTIONS\n";
  for (const CLI::Option* option : shown_options(app)) {
    text += ".TP\n\\fB" + escaped(joined(dashed_names(*option), ", ")) + "\\fR";
    if (const OptionValue value = value_of(*option); value.kind != OptionValue::Kind::none)
      text += " \\fI" + escaped(value.formatted) + "\\fR";
    text += "\n" + escaped(option->get_description()) + "\n";
  }
  return text;
}

std::string positionals(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option :
       app.get_options([](const CLI::Option* o) { return o->get_positional(); }))
    text += ".TP\n\\fI" + escaped(option->get_name(true)) + "\\fR\n" +
            escaped(option->get_description()) + "\n";
  return text.empty() ? text : ".SH ARGUMENTS\n" + text;
}

std::string commands(const CLI::App& program) {
  std::string text = ".SH COMMANDS\n";
  for (const CLI::App* command : shown_commands(program))
    text += ".TP\n\\fB" + escaped(command->get_name()) + "\\fR\n" +
            escaped(split_help(command->get_description()).summary) + "; see \\fBrelievo\\-" +
            escaped(command->get_name()) + "\\fR(1).\n";
  return text;
}

std::string examples(const HelpText& help) {
  if (help.examples.empty()) return "";
  std::string text = ".SH EXAMPLES\n.nf\n";
  for (const std::string& line : help.examples) text += escaped(line) + "\n";
  return text + ".fi\n";
}

}  // namespace

std::string man_page(const CLI::App& program, const std::string& command) {
  const CLI::App& app = command.empty() ? program : *program.get_subcommand(command);
  const HelpText help = split_help(app.get_description());
  const std::string page = command.empty() ? "relievo" : "relievo-" + command;
  std::string text =
      ".TH " + escaped(upper(page)) + " 1 \"\" \"relievo " RELIEVO_VERSION "\" \"User Commands\"\n";
  text += ".SH NAME\n" + escaped(page) + " \\- " + escaped(uncapitalised(help.summary)) + "\n";
  text += ".SH SYNOPSIS\n\\fBrelievo" + (command.empty() ? "" : " " + command) + "\\fR ";
  text +=
      command.empty() ? "\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n" : "[\\fIOPTIONS\\fR] \\fIINPUT\\fR\n";
  text += ".SH DESCRIPTION\n" + escaped(help.description) + "\n";
  text += command.empty() ? commands(app) : positionals(app);
  text += options(app) + examples(help) + exit_codes;
  return text + (command.empty() ? "" : ".SH SEE ALSO\n\\fBrelievo\\fR(1)\n");
}

}  // namespace relievo::cli
