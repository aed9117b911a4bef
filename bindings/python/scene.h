#pragma once

#include <pybind11/pybind11.h>

#include "relievo/scene.h"

namespace relievo::python {

/// The scene that an object of relievo/scene.py describes. Raises BadInputError, which names the
/// value that is none of its kind, or the part that there is none of.
Scene to_scene(const pybind11::handle& scene);

/// The object of relievo/scene.py.
pybind11::object to_python(const Scene& scene);

}  // namespace relievo::python
