#include "bindings/python/errors.h"

namespace relievo::python {
namespace {

/// The classes of relievo/errors.py for the kinds of errors, in the order of ErrorCode. An
/// interruption raises the exception of its signal instead.
constexpr const char* class_names[] = {"InternalError",      "UsageError", "BadInputError",
                                       "ContradictionError", "LimitError", "FileError",
                                       "InternalError"};

}  // namespace

void raise(const Error& error) {
  const pybind11::object kind =
      pybind11::module_::import("relievo.errors").attr(class_names[static_cast<int>(error.code)]);
  PyErr_SetObject(kind.ptr(), kind(error.message, error.where).ptr());
  throw pybind11::error_already_set();
}

}  // namespace relievo::python
