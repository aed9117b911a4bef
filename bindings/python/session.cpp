#include "bindings/python/session.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <mutex>
#include <optional>

#include "bindings/python/arrays.h"
#include "bindings/python/model.h"
#include "bindings/python/scene.h"
#include "bindings/python/work.h"
#include "relievo/pixel_art.h"
#include "relievo/read.h"
#include "relievo/session.h"

namespace relievo::python {
namespace {

namespace py = pybind11;

/// A session that several threads may use, one after the other.
class LockedSession {
  /// Runs work on the session, when other threads have finished theirs.
  template <class Work>
  auto locked(const Work& work) {
    return run([&](const RunContext& context) {
      const std::lock_guard lock(mutex_);
      return work(context);
    });
  }

 public:
  explicit LockedSession(SharedSource source) : source_(std::move(source)) {}

  BuildReport build(const py::handle& scene, const BuildOptions& options) {
    const Scene content = to_scene(scene);
    return locked(
        [&](const RunContext& context) { return session_.build(content, options, context); });
  }

  void make_exact() {
    locked([&](const RunContext& context) { return session_.make_exact(context); });
  }

  ShownModel model(const ModelOptions& options, Field field) {
    return {
        locked([&](const RunContext& context) { return session_.model(options, field, context); }),
        source_, std::nullopt, std::nullopt};
  }

  ShownModel solid(const SolidOptions& options) {
    Solid solid = locked([&](const RunContext& context) {
      return session_.solid(options, source_->drawing, context);
    });
    return {std::move(solid.model), source_, std::move(solid.drawing), std::move(solid.facts),
            stands(options)};
  }

  ShownMaps maps(int longest) {
    return {locked([&](const RunContext& context) { return session_.maps(longest, context); }),
            source_};
  }

 private:
  std::mutex mutex_;
  Session session_;
  SharedSource source_;
};

void bind_options(py::module_& module) {
  py::enum_<Method>(module, "Method")
      .value("approximate", Method::approximate)
      .value("nonlinear", Method::nonlinear);
  py::class_<BuildOptions>(module, "BuildOptions")
      .def(py::init())
      .def_readwrite("method", &BuildOptions::method)
      .def_readwrite("vertices", &BuildOptions::vertices)
      .def_readwrite("edge", &BuildOptions::edge)
      .def_readwrite("alpha0", &BuildOptions::alpha0)
      .def_readwrite("rho", &BuildOptions::rho)
      .def_readwrite("lambda_bnd", &BuildOptions::lambda_bnd)
      .def_readwrite("lambda_shift", &BuildOptions::lambda_shift)
      .def_readwrite("glue", &BuildOptions::glue)
      .def_readwrite("attach", &BuildOptions::attach);
  py::enum_<Visibility>(module, "Visibility")
      .value("relief", Visibility::relief)
      .value("orbit", Visibility::orbit)
      .value("all", Visibility::all);
  py::enum_<Field>(module, "Field")
      .value("relief", Field::relief)
      .value("inflation", Field::inflation)
      .value("shift", Field::shift);
  py::class_<ModelOptions>(module, "ModelOptions")
      .def(py::init())
      .def_readwrite("visible", &ModelOptions::visibility)
      .def_readwrite("rim_tolerance", &ModelOptions::rim_tolerance)
      .def_readwrite("max_rim_levels", &ModelOptions::max_rim_levels);
}

void bind_solid_options(py::module_& module) {
  py::enum_<BaseShape> shapes(module, "BaseShape");
  for (const auto& [name, shape] : base_shapes) shapes.value(name, shape);
  py::enum_<Ink>(module, "Ink")
      .value("shell", Ink::shell)
      .value("paint", Ink::paint)
      .value("none", Ink::none);
  py::enum_<BackSide> sides(module, "BackSide");
  for (const auto& [name, side] : back_sides) sides.value(name, side);
  py::class_<SolidOptions> options(module, "SolidOptions");
  options.def(py::init())
      .def_readwrite("back", &SolidOptions::back)
      .def_readwrite("base", &SolidOptions::base)
      .def_readwrite("mirror", &SolidOptions::mirror)
      .def_readwrite("detail", &SolidOptions::detail)
      .def_readwrite("ink", &SolidOptions::ink)
      .def_readwrite("ink_width", &SolidOptions::ink_width);
  for (const SolidLength& length : solid_lengths)
    options.def_readwrite(length.name, length.value, length.text);
}

void bind_render_options(py::module_& module) {
  py::enum_<Shading>(module, "Shading")
      .value("clay", Shading::clay)
      .value("textured", Shading::textured);
  py::enum_<Background>(module, "Background")
      .value("transparent", Background::transparent)
      .value("white", Background::white)
      .value("gradient", Background::gradient);
  py::class_<RenderOptions>(module, "RenderOptions")
      .def(py::init())
      .def_readwrite("width", &RenderOptions::width)
      .def_readwrite("height", &RenderOptions::height)
      .def_readwrite("yaw", &RenderOptions::yaw)
      .def_readwrite("pitch", &RenderOptions::pitch)
      .def_readwrite("shading", &RenderOptions::shading)
      .def_readwrite("background", &RenderOptions::background)
      .def_readwrite("light_radius", &RenderOptions::light_radius)
      .def_readwrite("samples", &RenderOptions::samples)
      .def_readwrite("ambient_rays", &RenderOptions::ambient_rays)
      .def_readwrite("ink", &RenderOptions::ink)
      .def_property(
          "light",
          [](const RenderOptions& self) {
            return std::array<double, 3>{self.light.x, self.light.y, self.light.z};
          },
          [](RenderOptions& self, const std::array<double, 3>& to) {
            self.light = {to[0], to[1], to[2]};
          })
      .def_property(
          "window",
          [](const RenderOptions& self) -> std::optional<std::array<double, 3>> {
            if (!self.window) return std::nullopt;
            return std::array<double, 3>{self.window->centre.x, self.window->centre.y,
                                         self.window->width};
          },
          [](RenderOptions& self, const std::optional<std::array<double, 3>>& to) {
            self.window.reset();
            if (to) self.window = RenderWindow{{(*to)[0], (*to)[1]}, (*to)[2]};
          });
}

py::tuple read(const std::filesystem::path& path, std::optional<bool> pixel_art) {
  DrawnScene drawn = run([&](const RunContext& context) { return read_drawing(path, context); });
  if (pixel_art) drawn.drawing.pixel_art = own_pixels(drawn.drawing.rgba, pixel_art);
  auto source = std::make_shared<Source>(Source{std::move(drawn.drawing), std::move(drawn.files)});
  return py::make_tuple(to_python(drawn.scene), std::move(source), drawn.warnings, drawn.proposed);
}

}  // namespace

void bind_sessions(py::module_& module) {
  bind_options(module);
  bind_solid_options(module);
  bind_render_options(module);
  py::class_<Source, SharedSource>(module, "Source")
      .def(py::init([](const py::object& array, std::optional<bool> pixel_art) {
             Source source{to_drawing(array), {}};
             source.drawing.pixel_art = own_pixels(source.drawing.rgba, pixel_art);
             return source;
           }),
           py::arg("drawing") = py::none(), py::arg("pixel_art") = py::none())
      .def("map_side", [](const Source& self, int usual) { return map_side(self.drawing, usual); })
      .def_property_readonly("drawing", [](const py::object& self) {
        return view_image(self.cast<Source&>().drawing.rgba, self);
      });
  py::class_<BuildReport>(module, "Report")
      .def_readonly("vertices", &BuildReport::vertices)
      .def_readonly("faces", &BuildReport::faces)
      .def_readonly("equalities", &BuildReport::equalities)
      .def_readonly("inequalities", &BuildReport::inequalities)
      .def_readonly("active", &BuildReport::active)
      .def_readonly("max_violation", &BuildReport::max_violation)
      .def_readonly("worst_overlap", &BuildReport::worst_overlap)
      .def_readonly("energy", &BuildReport::energy)
      .def_readonly("converged", &BuildReport::converged)
      .def_readonly("milliseconds", &BuildReport::milliseconds)
      .def_readonly("warnings", &BuildReport::warnings);
  py::class_<LockedSession>(module, "Session")
      .def(py::init<SharedSource>(), py::arg("source"))
      .def("build", &LockedSession::build, py::arg("scene"), py::arg("options"))
      .def("make_exact", &LockedSession::make_exact)
      .def("model", &LockedSession::model, py::arg("options"), py::arg("field"))
      .def("solid", &LockedSession::solid, py::arg("options"))
      .def("maps", &LockedSession::maps, py::arg("longest"));
  module.def("read", read, py::arg("path"), py::arg("pixel_art"));
}

}  // namespace relievo::python
