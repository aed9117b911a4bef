#include "apps/cli/common_arguments.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "io/files/number_text.h"

namespace relievo::cli {
namespace {

/// Units of lengths, in mm; without one it is mm.
constexpr std::pair<std::string_view, double> length_units[] = {
    {"", 1}, {"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}};

}  // namespace

void add_common(CLI::App& app, CommonArguments& common, const char* help) {
  app.add_option("INPUT", common.input, help)->required();
  add_run_options(app, common);
}

void add_run_options(CLI::App& app, CommonArguments& common) {
  app.add_flag("-q,--quiet", common.quiet, "Print errors only");
  app.add_option("--timeout", common.timeout, "Give up after this many seconds")
      ->check(CLI::PositiveNumber);
  app.add_option("--threads", common.threads,
                 "Number of threads (default: one per processor); the results do not depend on it")
      ->check(CLI::Range(1, 256));
}

void add_connect(CLI::App& app, CommonArguments& common) {
  add_choice(app, "--connect", common.connect,
             "Where a layered drawing does not say how its parts connect: auto guesses (the "
             "default), none stacks them",
             {{"auto", true}, {"none", false}});
}

void add_size(CLI::App& app, double& mm, double least, double most) {
  const auto read = [&mm, least, most](const std::string& text) {
    const size_t end = std::min(text.find_first_not_of("0123456789.+-e"), text.size());
    const std::string unit = text.substr(end);
    const auto known = std::find_if(std::begin(length_units), std::end(length_units),
                                    [&unit](const auto& one) { return one.first == unit; });
    double number = 0;
    if (known == std::end(length_units) || !CLI::detail::lexical_cast(text.substr(0, end), number))
      throw CLI::ValidationError("--size",
                                 text + " is not a length, such as 80, 80mm, 8cm or 1.8m");
    number *= known->second;
    if (!(number >= least && number <= most))
      throw CLI::ValidationError("--size", text + " is not from " + shortest_text(least) + " to " +
                                               shortest_text(most) + " mm");
    mm = number;
  };
  app.add_option_function<std::string>(
      "--size", read, "Longest side in mm, or with a unit: 80mm, 8cm, 1.8m or 3in (default 100)");
}

void add_pixel_art(CLI::App& app, CommonArguments& common) {
  add_choice(app, "--pixel-art", common.pixel_art,
             "Whether the drawing is pixel art, which keeps its pixels and colours: yes or no "
             "(default: recognised by its colours and steps)",
             {{"yes", true}, {"no", false}});
}

void add_normal_y(CLI::App& app, bool& normal_y_down) {
  add_choice(app, "--normal-y", normal_y_down,
             "Green of the normal map: + is up (OpenGL), - is down (DirectX)",
             {{"+", false}, {"-", true}});
}

CLI::Option* add_path(CLI::App& app, const char* option, std::string& path, const char* help,
                      const std::vector<std::string>& endings) {
  return app.add_option(option, path, help)->check(extension(endings));
}

CLI::Validator extension(const std::vector<std::string>& allowed) {
  const auto check = [=](const std::string& name) -> std::string {
    std::string known;
    for (const std::string& end : allowed) {
      if (name.size() > end.size() && name.ends_with(end)) return "";
      known += (known.empty() ? "" : ", ") + end;
    }
    return "\"" + name + "\" must end in " + known;
  };
  return {check, "", "extension"};
}

CLI::Validator within(double least, double most) {
  const CLI::Range range(least, most);
  const auto check = [=](std::string& value) -> std::string {
    double number = 0;
    if (CLI::detail::lexical_cast(value, number) && std::isnan(number))
      return value + " is not a number";
    return range(value);
  };
  return {check, range.get_description(), "range"};
}

}  // namespace relievo::cli
