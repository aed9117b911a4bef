#include "apps/cli/common_arguments.h"

#include <cmath>

namespace relievo::cli {

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
