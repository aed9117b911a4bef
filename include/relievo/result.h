#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace relievo {

/// Why an operation could not be done. The command line maps each to an exit code.
enum class ErrorCode {
  internal,       ///< a defect of ours
  usage,          ///< the call itself is wrong (options, arguments)
  bad_input,      ///< a file or value that does not say something valid
  contradiction,  ///< annotations that cannot all hold
  limit,          ///< size, time or memory over a stated limit
  file,           ///< reading or writing failed
  interrupted,    ///< cancelled by the caller
};

/// An expected failure: what is wrong, where, and what to do about it.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;  ///< one sentence for a person, without a trailing period
  std::string where;    ///< culprit: file, JSON path, part id or line; may be empty
};

/// The error as one line: "where: message".
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

  /// The value. Precondition: ok().
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

  /// The error. Precondition: !ok().
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
