#include "apps/cli/batch/batch_arguments.h"

#include <cstdio>

#include "apps/cli/build_arguments.h"

namespace relievo::cli {
namespace {

constexpr const char* help =
    R"(Builds many drawings with the same options, several at once, and keeps a journal: begun again,
it does what is missing or has changed, and nothing twice. A drawing that fails is told, and
the rest goes on. Takes the options of build besides its outputs.

Examples:
  relievo batch drawings -o models
  relievo batch *.svg -o models --make glb,normal,depth --vertices 10000 --sheet
  relievo batch sprites.tsv -o models
  relievo batch drawings -o models --shard 3/20
  relievo batch --merge -o models)";

/// The options of `build`, in the help.
constexpr const char* choices_group = "Each drawing";

Shard shard(const std::string& text) {
  Shard shard;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%d/%d%c", &shard.index, &shard.count, &rest);
  if (read != 2 || shard.count < 1 || shard.index < 1 || shard.index > shard.count)
    throw CLI::ValidationError("--shard " + text, "is not of the form 3/20, from 1/20 to 20/20");
  return shard;
}

void add_work(CLI::App& app, BatchArguments& batch) {
  app.add_option("--jobs", batch.jobs, "Drawings at once (default: as many as processors)")
      ->check(CLI::Range(1, 1024));
  app.add_option("--memory", batch.memory_mb,
                 "Memory for all of them together in MB (default: 80 % of what is free)")
      ->check(CLI::Range(200.0, 1e7));
  app.add_option_function<std::string>(
      "--shard", [&batch](const std::string& text) { batch.shard = shard(text); },
      "Build the Kth of N shares alone, with a journal of its own; K/N");
  app.add_flag("--retry", batch.retry, "Try those again that failed");
  app.add_flag("--sheet", batch.sheet, "Make a contact sheet, index.html, and its pictures");
  app.add_flag("--merge", batch.merge, "Build nothing; make one journal of those of the shards");
  app.add_flag("-q,--quiet", batch.common.quiet, "Say nothing but errors");
}

}  // namespace

CLI::App& add_batch(CLI::App& main, BatchArguments& batch, BuildArguments& choices) {
  CLI::App& app = *main.add_subcommand("batch", help);
  app.add_option("INPUT", batch.inputs,
                 "Drawings, folders that are searched for them, tables of drawings (.tsv)");
  app.add_option("-o,--output", batch.output, "Folder of the results")->required();
  app.add_option(
         "--make", batch.make,
         "What to make of each, between commas: glb (the default), obj, ply, stl, 3mf, usdz, "
         "html, normal, depth, part, occlusion, preview, overlay, report")
      ->delimiter(',')
      ->check(CLI::IsMember({"glb", "obj", "ply", "stl", "3mf", "usdz", "html", "normal", "depth",
                             "part", "occlusion", "preview", "overlay", "report"}));
  add_work(app, batch);
  CLI::App& group = *app.add_option_group(choices_group);
  group.add_option("--timeout", choices.common.timeout, "Give up a drawing after so many seconds")
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
