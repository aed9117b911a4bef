#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "relievo/files.h"
#include "relievo/maps.h"
#include "relievo/model.h"
#include "relievo/render.h"
#include "relievo/solid.h"

namespace relievo::python {

/// The drawing and the files from which a relief is made.
struct Source {
  Drawing drawing;
  std::vector<std::filesystem::path> files;  ///< never to be overwritten
};
using SharedSource = std::shared_ptr<Source>;

/// A model with the data to save and render it.
struct ShownModel {
  Model model;
  std::shared_ptr<const Source> source;
  std::optional<Drawing> drawing;   ///< replaces that of the source
  std::optional<SolidFacts> solid;  ///< of a solid, whose model is in mm
  bool standing = false;            ///< upright in files to print

  const Drawing& shown() const { return drawing ? *drawing : source->drawing; }
};

/// Maps, and the source, whose files must not be overwritten.
struct ShownMaps {
  ReliefMaps maps;
  std::shared_ptr<const Source> source;
};

/// Adds the classes Model, ModelPart, Maps and SolidFacts to the module.
void bind_models(pybind11::module_& module);

}  // namespace relievo::python
