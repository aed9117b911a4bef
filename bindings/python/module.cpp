#include <pybind11/pybind11.h>

#include "bindings/python/model.h"
#include "bindings/python/session.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of relievo; use the package.";
  relievo::python::bind_models(module);
  relievo::python::bind_sessions(module);
  module.attr("version") = RELIEVO_VERSION;
}
