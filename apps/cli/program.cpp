#include "apps/cli/program.h"

#include <exception>
#include <new>
#include <system_error>

#include "apps/cli/exit_code.h"
#include "apps/cli/messages.h"
#include "kernel/base/workers.h"

namespace relievo::cli {
namespace {

int run(const Command& command) {
  set_quiet(command.common.quiet);
  set_worker_count(command.common.threads);
  Interruption interruption(command.common.timeout);
  Result<int> code = command.run(interruption);
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
  return exit_code(ErrorCode::limit);
}

}  // namespace

int run_program(int argc, const char* const* argv,
                ParsedArguments (*parse)(int argc, const char* const* argv)) {
  try {
    const ParsedArguments parsed = parse(argc, argv);
    const int* code = std::get_if<int>(&parsed);
    return code != nullptr ? *code : run(std::get<Command>(parsed));
  } catch (const std::bad_alloc&) {
    return give_up_for_memory();
  } catch (const std::exception& bug) {
    // A thread cannot start if there is no memory for its stack.
    const auto* system = dynamic_cast<const std::system_error*>(&bug);
    if (system && (system->code() == std::errc::resource_unavailable_try_again ||
                   system->code() == std::errc::not_enough_memory))
      return give_up_for_memory();
    print_error(
        {ErrorCode::internal, std::string("internal error (please report it): ") + bug.what(), ""});
    return exit_code(ErrorCode::internal);
  }
}

}  // namespace relievo::cli
