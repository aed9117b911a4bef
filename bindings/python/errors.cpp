#include "bindings/python/errors.h"

namespace relievo::python {
namespace {

const char* class_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::usage:
      return "UsageError";
    case ErrorCode::bad_input:
      return "BadInputError";
    case ErrorCode::contradiction:
      return "ContradictionError";
    case ErrorCode::limit:
      return "LimitError";
    case ErrorCode::file:
      return "FileError";
    default:
      return "InternalError";
  }
}

}  // namespace

void raise(const Error& error) {
  const pybind11::object kind =
      pybind11::module_::import("relievo.errors").attr(class_name(error.code));
  PyErr_SetObject(kind.ptr(), kind(error.message, error.where).ptr());
  throw pybind11::error_already_set();
}

}  // namespace relievo::python
