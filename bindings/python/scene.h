#pragma once

#include <pybind11/pybind11.h>

#include "relievo/scene.h"

namespace relievo::python {

/// Converts a Scene of relievo/scene.py. Raises BadInputError, with the path, for values of a wrong
/// type and for unknown parts.
Scene to_scene(const pybind11::handle& scene);

/// Converts to a Scene of relievo/scene.py.
pybind11::object to_python(const Scene& scene);

}  // namespace relievo::python
