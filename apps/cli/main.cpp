#include <exception>
#include <new>
#include <system_error>

#include "apps/cli/arguments.h"
#include "apps/cli/batch/batch_command.h"
#include "apps/cli/build_command.h"
#include "apps/cli/check_command.h"
#include "apps/cli/compare_command.h"
#include "apps/cli/exit_code.h"
#include "apps/cli/interruption.h"
#include "apps/cli/messages.h"
#include "apps/cli/render_command.h"
#include "apps/cli/segment_command.h"
#include "apps/cli/sequence/sequence_command.h"
#include "kernel/base/workers.h"

namespace relievo::cli {
namespace {

const CommonArguments& common(const Command& command) {
  return std::visit(
      [](const auto& arguments) -> const CommonArguments& { return arguments.common; }, command);
}

/// The exit code of a command that has done its work.
Result<int> run(const Command& command, Interruption& interruption) {
  const auto done = [](const Status& status) -> Result<int> {
    if (!status) return status.error();
    return exit_done;
  };
  if (const auto* batch = std::get_if<BatchArguments>(&command))
    return run_batch(*batch, interruption);
  if (const auto* build = std::get_if<BuildArguments>(&command))
    return done(run_build(*build, interruption));
  if (const auto* check = std::get_if<CheckArguments>(&command))
    return done(run_check(*check, interruption));
  if (const auto* compare = std::get_if<CompareArguments>(&command))
    return done(run_compare(*compare, interruption));
  if (const auto* segment = std::get_if<SegmentArguments>(&command))
    return done(run_segment(*segment, interruption));
  if (const auto* sequence = std::get_if<SequenceArguments>(&command))
    return done(run_sequence(*sequence, interruption));
  return done(run_render(std::get<RenderArguments>(command), interruption));
}

int run_program(int argc, const char* const* argv) {
  const ParsedArguments parsed = parse_arguments(argc, argv);
  if (const int* code = std::get_if<int>(&parsed)) return *code;
  const auto& command = std::get<Command>(parsed);
  set_worker_count(common(command).threads);
  Interruption interruption(common(command).timeout);
  Result<int> code = run(command, interruption);
  if (code)
    if (Status status = flush_results(); !status) code = status.error();
  if (code) return *code;
  const bool stopped = code.error().code == ErrorCode::interrupted;
  const Error error = stopped ? interruption.reason() : code.error();
  print_error(error);
  return exit_code(error.code);
}

int give_up_for_memory() {
  print_error({ErrorCode::limit,
               "out of memory: try fewer --vertices, a smaller picture, or more memory", ""});
  return exit_limit;
}

}  // namespace
}  // namespace relievo::cli

int main(int argc, char** argv) {
  using relievo::ErrorCode;
  namespace cli = relievo::cli;
  try {
    return cli::run_program(argc, argv);
  } catch (const std::bad_alloc&) {
    return cli::give_up_for_memory();
  } catch (const std::exception& defect) {
    // A thread that cannot be started has no memory for its stack.
    const auto* system = dynamic_cast<const std::system_error*>(&defect);
    if (system && (system->code() == std::errc::resource_unavailable_try_again ||
                   system->code() == std::errc::not_enough_memory))
      return cli::give_up_for_memory();
    cli::print_error({ErrorCode::internal, std::string("defect: ") + defect.what(), ""});
    return cli::exit_code(ErrorCode::internal);
  }
}
