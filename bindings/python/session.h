#pragma once

#include <pybind11/pybind11.h>

namespace relievo::python {

/// Adds the class Session and its options to the module.
void bind_sessions(pybind11::module_& module);

}  // namespace relievo::python
