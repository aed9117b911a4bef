#include "bindings/python/model.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>

#include "bindings/python/arrays.h"
#include "bindings/python/work.h"
#include "relievo/export.h"

namespace relievo::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

double longest_side(const Model& model) {
  Point3 low = model.positions.front();
  Point3 high = low;
  for (const Point3& p : model.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

Status save(const ShownModel& shown, const fs::path& path, std::optional<double> size,
            ExportOptions options) {
  if (path.extension() == ".3mf" && !shown.solid)
    return Error{ErrorCode::usage, "holds solids alone: save relief.solid()", path.string()};
  options.standing = shown.standing;
  if (size)
    options.size_mm = *size;
  else if (shown.solid && !shown.model.positions.empty())
    options.size_mm = longest_side(shown.model);
  const auto files = export_model(shown.model, shown.shown(), path, options);
  if (!files) return files.error();
  return write_files(*files, shown.source->files);
}

py::array render(const ShownModel& shown, const RenderOptions& options) {
  const Drawing& drawing = shown.shown();
  return to_array(run([&](const RunContext& context) {
    return render_model(shown.model, drawing.rgba.empty() ? nullptr : &drawing, options, context);
  }));
}

Status save_maps(const ShownMaps& shown, const fs::path& normals, const fs::path& heights,
                 const fs::path& parts) {
  std::vector<OutputFile> files;
  const auto add = [&](const fs::path& path, auto encode) -> Status {
    if (path.empty()) return Done{};
    auto bytes = encode(shown.maps);
    if (!bytes) return bytes.error();
    files.push_back({path, std::move(*bytes)});
    return Done{};
  };
  const auto encode_normals = [](const ReliefMaps& maps) { return encode_normal_map(maps); };
  if (Status status = add(normals, encode_normals); !status) return status;
  if (Status status = add(heights, encode_depth_map); !status) return status;
  if (Status status = add(parts, encode_part_map); !status) return status;
  return write_files(files, shown.source->files);
}

/// Returns the getter of a list of the model, as an array with a row of numbers for each item.
template <class Number, class Value>
auto rows(std::vector<Value> Model::*list) {
  return [list](const py::object& self) {
    return view_rows<Number>(self.cast<ShownModel&>().model.*list, self);
  };
}

/// Returns the getter of a map, as an array.
template <class Map>
auto picture(Map ReliefMaps::*map) {
  return
      [map](const py::object& self) { return view_image(self.cast<ShownMaps&>().maps.*map, self); };
}

void bind_model(py::module_& module) {
  py::class_<ShownModel>(module, "Model")
      .def_property_readonly("vertices", rows<double>(&Model::positions))
      .def_property_readonly("normals", rows<double>(&Model::normals))
      .def_property_readonly("uvs", rows<double>(&Model::uvs))
      .def_property_readonly("faces", rows<int>(&Model::triangles))
      .def_property_readonly("parts", [](const ShownModel& self) { return self.model.parts; })
      .def_property_readonly("solid", [](const ShownModel& self) { return self.solid; })
      .def(
          "save",
          [](const ShownModel& self, const fs::path& path, std::optional<double> size,
             bool grounded, int texture_size, int filaments, Slicer slicer, std::optional<Ink> ink,
             double ink_width) {
            const ExportOptions options = {.grounded = grounded,
                                           .texture_size = texture_size,
                                           .filaments = filaments,
                                           .slicer = slicer,
                                           .ink = ink,
                                           .ink_width = ink_width};
            run([&](const RunContext&) { return save(self, path, size, options); });
          },
          py::arg("path"), py::arg("size"), py::arg("grounded"), py::arg("texture_size"),
          py::arg("filaments"), py::arg("slicer"), py::arg("ink"), py::arg("ink_width"))
      .def("render", render, py::arg("options"));
}

void bind_maps(py::module_& module) {
  py::class_<ShownMaps>(module, "Maps")
      .def_property_readonly("heights", picture(&ReliefMaps::height))
      .def_property_readonly("normals", picture(&ReliefMaps::normal))
      .def_property_readonly("parts", picture(&ReliefMaps::part))
      .def(
          "save",
          [](const ShownMaps& self, const fs::path& normals, const fs::path& heights,
             const fs::path& parts) {
            run([&](const RunContext&) { return save_maps(self, normals, heights, parts); });
          },
          py::kw_only(), py::arg("normals") = "", py::arg("heights") = "", py::arg("parts") = "");
}

}  // namespace

void bind_models(py::module_& module) {
  py::class_<ModelPart>(module, "ModelPart")
      .def_readonly("id", &ModelPart::id)
      .def_readonly("first_face", &ModelPart::first_triangle)
      .def_readonly("face_count", &ModelPart::triangle_count)
      .def_readonly("hidden_count", &ModelPart::hidden_count);
  py::enum_<Slicer>(module, "Slicer").value("prusa", Slicer::prusa).value("bambu", Slicer::bambu);
  py::class_<SolidFacts>(module, "SolidFacts")
      .def_readonly("volume", &SolidFacts::volume)
      .def_readonly("pieces", &SolidFacts::pieces)
      .def_readonly("loose", &SolidFacts::loose);
  bind_model(module);
  bind_maps(module);
  module.def(
      "save_picture",
      [](const fs::path& path, const py::array& picture) {
        const Image8 image = to_image(picture, "picture");
        run([&](const RunContext&) -> Status {
          auto bytes = encode_picture(image);
          if (!bytes) return bytes.error();
          return write_files({{path, std::move(*bytes)}});
        });
      },
      py::arg("path"), py::arg("picture"));
}

}  // namespace relievo::python
