#include "apps/cli/solid_arguments.h"

#include <string>
#include <vector>

#include "apps/cli/within.h"

namespace relievo::cli {
namespace {

BaseShape base_shape(const std::string& name) {
  if (name == "outline") return BaseShape::outline;
  if (name == "plate") return BaseShape::plate;
  return name == "round" ? BaseShape::round : BaseShape::none;
}

}  // namespace

void add_solid_options(CLI::App& app, ReliefArguments& relief) {
  SolidOptions& solid = relief.solid_options;
  auto* profile =
      app.add_option_function<std::string>(
             "--profile",
             [&relief](const std::string& name) {
               relief.solid = name != "relief";
               relief.solid_options.back = name == "figure" ? BackSide::drawing : BackSide::flat;
             },
             "relief: the surface alone (the default); solid: everything below it, closed, with a "
             "flat back, to print or to carve; figure: closed too, with a back as round as its "
             "front")
          ->check(CLI::IsMember({"relief", "solid", "figure"}));
  const std::vector<CLI::Option*> options = {
      app.add_option_function<std::string>(
             "--back",
             [&solid](const std::string& name) {
               if (solid.back == BackSide::flat)
                 throw CLI::ValidationError("--back is of figures: add --profile figure");
               if (name == "parts") solid.back = BackSide::parts;
             },
             "Of a figure: what is on its back, the drawing (the default) or the mean colours of "
             "its parts")
          ->check(CLI::IsMember({"drawing", "parts"})),
      app.add_option("--mirror", solid.mirror,
                     "Of figure: the id of a limb that its far side gets too, a part joined to one "
                     "behind it (repeatable)")
          ->take_all()
          ->expected(1),
      app.add_option_function<std::string>(
             "--base", [&solid](const std::string& name) { solid.base = base_shape(name); },
             "Of solid: none (the default), or a plate below it: outline, plate (a rectangle) or "
             "round; of figure: one under its feet, plate or round")
          ->check(CLI::IsMember({"none", "outline", "plate", "round"})),
      app.add_option("--thickness", solid.thickness,
                     "Of solid: mm below its lowest visible point; also of a base (default 2)")
          ->check(within(0.1, 1000.0)),
      app.add_option("--height", solid.height,
                     "Of solid and figure: mm, its depth at most; it shrinks where there is more")
          ->check(within(0.2, 1000.0)),
      app.add_option_function<std::string>(
             "--height-mode",
             [&solid](const std::string& name) { solid.detail = name == "detail"; },
             "How it shrinks: linear (evenly, the default), or detail (small forms stay)")
          ->check(CLI::IsMember({"linear", "detail"})),
      app.add_option(
             "--margin", solid.margin,
             "Of solid and figure: mm from it, or its feet, to the edge of its base (default 3)")
          ->check(within(0.5, 1000.0)),
      app.add_option("--corner", solid.corner,
                     "Of solid: mm, radius of the corners of a plate (default 3)")
          ->check(within(0.0, 1000.0)),
      app.add_option("--hole", solid.hole, "Of solid: a hole so many mm wide in its base")
          ->check(within(0.5, 100.0)),
      app.add_option("--ring", solid.ring,
                     "Of solid: a loop above its base, its hole so many mm wide")
          ->check(within(0.5, 100.0)),
      app.add_option(
             "--cutter", solid.cutter,
             "Of solid: a wall of 0.8 mm around --base outline, so many mm above it, to cut "
             "dough with")
          ->check(within(1.0, 1000.0)),
      app.add_option("--nozzle", relief.nozzle,
                     "Of solid and figure: width in mm that its walls are checked for (default "
                     "0.4)")
          ->check(within(0.05, 10.0))};
  for (CLI::Option* option : options) option->needs(profile);
}

}  // namespace relievo::cli
