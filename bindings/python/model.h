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

/// What was read to make a relief.
struct Source {
  Drawing drawing;
  std::vector<std::filesystem::path> files;  ///< never to be overwritten
};
using SharedSource = std::shared_ptr<Source>;

/// A model with what saving and rendering it take.
struct ShownModel {
  Model model;
  std::shared_ptr<const Source> source;
  std::optional<Drawing> drawing;   ///< in place of the source's
  std::optional<SolidFacts> solid;  ///< of a solid, whose model is in mm
  bool standing = false;            ///< whether files to print have it upright

  const Drawing& shown() const { return drawing ? *drawing : source->drawing; }
};

/// Maps, and what must not be overwritten when they are saved.
struct ShownMaps {
  ReliefMaps maps;
  std::shared_ptr<const Source> source;
};

/// The classes Model, ModelPart, Maps and SolidFacts.
void bind_models(pybind11::module_& module);

}  // namespace relievo::python
