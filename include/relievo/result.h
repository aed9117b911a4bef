#pragma once

#include <cassert>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace relievo {

/// Why an operation failed. The command line has an exit code for each.
enum class ErrorCode {
  internal,       ///< a bug in Relievo
  usage,          ///< a wrong option or argument
  bad_input,      ///< an invalid file or value
  contradiction,  ///< annotations that cannot all hold
  limit,          ///< a size, time or amount of memory over its limit
  file,           ///< a file that cannot be read or written
  interrupted,    ///< cancelled by the caller
};

/// The list that a culprit is an item of: a list of the scene, or the scribbled strokes.
enum class CulpritList { none, parts, joins, relations, robin, cues, strokes };

/// The names of these lists, as scene and scribble files spell them.
inline constexpr const char* culprit_list_names[] = {"",      "parts", "joins",  "relations",
                                                     "robin", "cues",  "strokes"};

/// The item that an error is about, for programs: the scene's `list[index]`.
struct Culprit {
  CulpritList list = CulpritList::none;
  size_t index = 0;
};

/// Formats a culprit as "joins[2]"; empty if there is none.
inline std::string to_string(Culprit culprit) {
  if (culprit.list == CulpritList::none) return "";
  return std::string(culprit_list_names[static_cast<int>(culprit.list)]) + "[" +
         std::to_string(culprit.index) + "]";
}

/// An expected failure: its cause, its place, and how to mend it.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;   ///< one sentence for a person, without a trailing period
  std::string where;     ///< the place, for a person: a file, JSON path, part id or line; or empty
  Culprit culprit = {};  ///< the item at fault, where there is one
};

/// Formats an error as one line: "where: message".
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
