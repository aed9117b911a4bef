#include "apps/cli/common_arguments.h"

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
  app.add_option_function<std::string>(
         "--connect", [&common](const std::string& how) { common.connect = how == "auto"; },
         "Where a layered drawing does not say how its parts connect: auto guesses (the default), "
         "none stacks them")
      ->check(CLI::IsMember({"auto", "none"}));
}

CLI::Validator extension(const std::vector<std::string>& allowed) {
  const auto check = [=](const std::string& name) -> std::string {
    std::string known;
    for (const std::string& end : allowed) {
      const bool fits = name.size() > end.size() && name.substr(name.size() - end.size()) == end;
      if (fits) return "";
      known += (known.empty() ? "" : ", ") + end;
    }
    return "\"" + name + "\" must end in " + known;
  };
  return {check, "", "extension"};
}

}  // namespace relievo::cli
