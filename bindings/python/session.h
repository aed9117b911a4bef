#pragma once

#include <pybind11/pybind11.h>

namespace relievo::python {

/// Adds the class Session, and the options of its functions, to the module.
void bind_sessions(pybind11::module_& module);

}  // namespace relievo::python
