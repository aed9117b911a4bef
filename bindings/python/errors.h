#pragma once

#include <pybind11/pybind11.h>

#include <utility>

#include "relievo/result.h"

namespace relievo::python {

/// Raises the exception of relievo/errors.py that stands for the error's code. Needs the
/// interpreter's lock.
[[noreturn]] void raise(const Error& error);

/// The value, or the exception.
template <class T>
T taken(Result<T> result) {
  if (!result) raise(result.error());
  return std::move(result).value();
}

}  // namespace relievo::python
