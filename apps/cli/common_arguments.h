#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/exit_code.h"

namespace relievo::cli {

/// Help for the input of commands that take drawings.
inline constexpr const char* input_help =
    "Layered drawing (SVG, OpenRaster, PSD, a folder of pictures), flat picture (PNG, JPEG, GIF, "
    "WebP, AVIF, HEIC), project or scene file (JSON); - reads standard input";

/// Help for the overlay of the commands that draw one without details.
inline constexpr const char* overlay_help =
    "Picture of the drawing with its parts and joins marked (.png)";

/// The command that calls `run` with the arguments. `run` returns a Status, or an exit code.
template <class Arguments, class Run>
Command command(const std::shared_ptr<Arguments>& arguments, Run run) {
  return {arguments->common, [arguments, run](Interruption& interruption) -> Result<int> {
            const auto done = run(*arguments, interruption);
            if (!done) return done.error();
            if constexpr (std::is_same_v<std::decay_t<decltype(*done)>, int>) return *done;
            return exit_done;
          }};
}

/// Adds the input, with `help`, and the options of every command.
void add_common(CLI::App& app, CommonArguments& common, const char* help);

/// Adds the options of every command: --quiet, --timeout and --threads.
void add_run_options(CLI::App& app, CommonArguments& common);

/// Adds --connect.
void add_connect(CLI::App& app, CommonArguments& common);

/// Adds --size, a length in [least, most] mm with or without a unit: 80, 80mm, 8cm, 1.8m or 3in.
void add_size(CLI::App& app, double& mm, double least, double most);

/// Adds --pixel-art.
void add_pixel_art(CLI::App& app, CommonArguments& common);

/// Adds --normal-y.
void add_normal_y(CLI::App& app, bool& normal_y_down);

/// Adds an option that names a file, whose name must end in one of `endings`.
CLI::Option* add_path(CLI::App& app, const char* option, std::string& path, const char* help,
                      const std::vector<std::string>& endings = {".png"});

/// Adds an option that takes one of the given words, and sets `value` to what the word stands for.
template <class Value>
CLI::Option* add_choice(
    CLI::App& app, const char* option, Value& value, const char* help,
    const std::vector<std::pair<const char*, std::type_identity_t<Value>>>& choices) {
  const auto choose = [&value, choices](const std::string& given) {
    for (const auto& [word, meaning] : choices)
      if (given == word) value = meaning;
  };
  return app.add_option_function<std::string>(option, choose, help)->check(CLI::IsMember(choices));
}

/// Requires that a file name ends in one of the given extensions.
CLI::Validator extension(const std::vector<std::string>& allowed);

/// Requires a number in [least, most]. Unlike CLI::Range, rejects "nan".
CLI::Validator within(double least, double most);

}  // namespace relievo::cli
