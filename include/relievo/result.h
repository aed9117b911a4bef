#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace relievo {

/// The reason of a failure. The command line maps each to an exit code.
enum class ErrorCode {
  internal,       ///< an internal error, to be reported
  usage,          ///< wrong options or arguments
  bad_input,      ///< an invalid file or value
  contradiction,  ///< annotations that cannot all hold
  limit,          ///< size, time or memory over a stated limit
  file,           ///< reading or writing failed
  interrupted,    ///< cancelled by the caller
};

/// An expected failure, with its culprit and, if there is one, a remedy.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;  ///< one sentence for the user, without a trailing period
  std::string where;    ///< culprit: file, JSON path, part id or line; may be empty
};

/// Formats the error as one line: "where: message".
inline std::string to_string(const Error& error) {
  return error.where.empty() ? error.message : error.where + ": " + error.message;
}

/// A value or the error that prevented it.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::move(error)) {}

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// Returns the value. Precondition: ok().
  T& value() & {
    assert(ok());
    return std::get<0>(content_);
  }
  const T& value() const& {
    assert(ok());
    return std::get<0>(content_);
  }
  T&& value() && {
    assert(ok());
    return std::get<0>(std::move(content_));
  }

  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }

  /// Returns the error. Precondition: !ok().
  const Error& error() const {
    assert(!ok());
    return std::get<1>(content_);
  }

 private:
  std::variant<T, Error> content_;
};

/// Success without a value, or an error.
struct Done {};
using Status = Result<Done>;

}  // namespace relievo
