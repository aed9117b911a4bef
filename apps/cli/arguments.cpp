#include "apps/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "apps/cli/batch/batch_command.h"
#include "apps/cli/build_arguments.h"
#include "apps/cli/check_command.h"
#include "apps/cli/exit_code.h"
#include "apps/cli/manual/completions.h"
#include "apps/cli/manual/help_text.h"
#include "apps/cli/manual/man_page.h"
#include "apps/cli/messages.h"
#include "apps/cli/render_command.h"
#include "apps/cli/segment_command.h"
#include "apps/cli/sequence/sequence_command.h"
#include "apps/cli/version.h"

namespace relievo::cli {
namespace {

constexpr const char* main_help =
    R"(Turns a drawing of a character, layered or flat, into a seamless high relief.

Examples:
  relievo build wolf.svg -o wolf.glb
  relievo build wolf.svg -o wolf.glb --preview wolf.png --normal-map wolf-normal.png
  relievo build photo.jpg -o photo.glb --overlay understood.png
  relievo check wolf.svg
  relievo render wolf.glb -o wolf-sheet.png --view sheet)";

/// Adds the command that packages use to print manual pages. Help does not show it.
void add_manual(CLI::App& main, Command& chosen) {
  const auto what = std::make_shared<std::string>();
  const auto page = std::make_shared<std::string>();
  CLI::App& app = *main.add_subcommand("manual", "Prints a manual page or a shell's completions.");
  app.group("");
  app.add_option("WHAT", *what, "man, bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
  std::vector<std::string> names;
  for (const CLI::App* command : shown_commands(main)) names.push_back(command->get_name());
  app.add_option("COMMAND", *page,
                 "The command whose page is printed (default: that of the program)")
      ->check(CLI::IsMember(names));
  app.callback([what, page, &main, &chosen] {
    print_result(*what == "man" ? man_page(main, *page) : completions(main, *what));
    chosen.run = [](Interruption&) { return exit_done; };
  });
}

}  // namespace

ParsedArguments parse_arguments(int argc, const char* const* argv) {
  // "help" and "help COMMAND" mean --help and COMMAND --help.
  std::vector<const char*> words(argv, argv + argc);
  if (argc > 1 && argc < 4 && std::string(argv[1]) == "help") {
    words.erase(words.begin() + 1);
    words.push_back("--help");
  }
  CLI::App app(main_help, "relievo");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(0, 1);
  Command chosen;
  for (const auto add :
       {add_build, add_batch, add_check, add_render, add_segment, add_sequence, add_manual})
    add(app, chosen);
  try {
    app.parse(static_cast<int>(words.size()), words.data());
    if (!chosen.run)
      throw CLI::RequiredError("A command (build, batch, check, render, segment or sequence)");
    return chosen;
  } catch (const CLI::ParseError& error) {
    // Help and the version go to standard output, errors to standard error.
    return app.exit(error, std::cout, std::cerr) == 0 ? exit_done : exit_code(ErrorCode::usage);
  }
}

}  // namespace relievo::cli
