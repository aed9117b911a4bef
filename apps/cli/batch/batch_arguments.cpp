#include "apps/cli/batch/batch_arguments.h"

#include <cstdio>

#include "apps/cli/build_arguments.h"

namespace relievo::cli {
namespace {

constexpr const char* help =
    R"(Builds many drawings with the same options, several at once, and keeps a journal. Run the same
command again and only drawings that are new, changed or missing their output are built.
A drawing that fails is reported and does not stop the others. Takes the options of build.

Examples:
  relievo batch drawings -o models
  relievo batch *.svg -o models --make glb,normal,depth --vertices 10000 --sheet
  relievo batch sprites.tsv -o models
  relievo batch drawings -o models --shard 3/20
  relievo batch --merge -o models)";

/// Heading of the options of `build` in the help.
constexpr const char* choices_group = "Each drawing";

void set_shard(const std::string& text, BatchArguments& batch) {
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%d/%d%c", &batch.shard, &batch.shards, &rest);
  if (read != 2 || batch.shards < 1 || batch.shard < 1 || batch.shard > batch.shards)
    throw CLI::ValidationError("--shard " + text, "must be of the form 3/20, from 1/20 to 20/20");
}

void add_work(CLI::App& app, BatchArguments& batch) {
  app.add_option("--jobs", batch.jobs,
                 "Number of drawings to build at once (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  app.add_option("--memory", batch.memory_mb,
                 "Memory for all of them together in MB (default: 80 % of the free memory)")
      ->check(CLI::Range(200.0, 1e7));
  app.add_option_function<std::string>(
      "--shard", [&batch](const std::string& text) { set_shard(text, batch); },
      "Builds only the Kth of N shares, given as K/N, with a journal of its own");
  app.add_flag("--retry", batch.retry, "Builds failed drawings again");
  app.add_flag("--sheet", batch.sheet, "Makes a contact sheet, index.html, and its pictures");
  app.add_flag("--merge", batch.merge,
               "Merges the journals of all shards into one, and builds nothing");
  app.add_flag("-q,--quiet", batch.common.quiet, "Print errors only");
}

}  // namespace

CLI::App& add_batch(CLI::App& main, BatchArguments& batch, BuildArguments& choices) {
  CLI::App& app = *main.add_subcommand("batch", help);
  app.add_option("INPUT", batch.inputs,
                 "Drawings, folders to search for drawings, or tables of drawings (.tsv)");
  app.add_option("-o,--output", batch.output, "Output folder")->required();
  app.add_option(
         "--make", batch.make,
         "Outputs for each drawing, separated by commas: glb (the default), obj, ply, stl, 3mf, "
         "usdz, html, normal, depth, part, occlusion, preview, overlay, report")
      ->delimiter(',')
      ->check(CLI::IsMember({"glb", "obj", "ply", "stl", "3mf", "usdz", "html", "normal", "depth",
                             "part", "occlusion", "preview", "overlay", "report"}));
  add_work(app, batch);
  CLI::App& group = *app.add_option_group(choices_group);
  group
      .add_option("--timeout", choices.common.timeout,
                  "Give up on a drawing after this many seconds")
      ->check(CLI::PositiveNumber);
  add_build_choices(group, choices);
  return app;
}

void settle_batch(const CLI::App& app, BatchArguments& batch) {
  if (batch.merge == !batch.inputs.empty())
    throw CLI::ValidationError(batch.merge ? "--merge takes no drawings"
                                           : "no drawings: give files, folders or tables");
  for (const CLI::Option* option : app.get_option_group(choices_group)->get_options()) {
    const std::vector<std::string>& values = option->results();
    const bool flag = option->get_expected_max() == 0;
    const int each = flag ? 1 : option->get_expected_min();
    for (auto value = values.begin(); value != values.end(); value += each) {
      batch.words.push_back("--" + option->get_single_name());
      if (!flag) batch.words.insert(batch.words.end(), value, value + each);
    }
  }
}

}  // namespace relievo::cli
