#pragma once

#include "relievo/result.h"

namespace relievo::cli {

constexpr int exit_done = 0;
constexpr int exit_usage = 2;
constexpr int exit_limit = 5;
constexpr int exit_interrupted = 130;

/// Returns the exit code for a kind of failure.
inline int exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::internal:
      return 1;
    case ErrorCode::usage:
      return exit_usage;
    case ErrorCode::bad_input:
      return 3;
    case ErrorCode::contradiction:
      return 4;
    case ErrorCode::limit:
      return exit_limit;
    case ErrorCode::file:
      return 6;
    case ErrorCode::interrupted:
      return exit_interrupted;
  }
  return 1;
}

}  // namespace relievo::cli
