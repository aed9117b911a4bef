#pragma once

#include <pybind11/pybind11.h>

#include <utility>

#include "relievo/result.h"

namespace relievo::python {

/// Raises the exception of relievo/errors.py for the code of an error. Precondition: the caller
/// holds the interpreter's lock.
[[noreturn]] void raise(const Error& error);

/// Returns the value of a result, or raises its error.
template <class T>
T unwrap(Result<T> result) {
  if (!result) raise(result.error());
  return std::move(result).value();
}

}  // namespace relievo::python
