#include "apps/cli/solid_arguments.h"

#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "apps/cli/within.h"

namespace relievo::cli {

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
  const std::map<std::string, BaseShape> bases(std::begin(base_shapes), std::end(base_shapes));
  std::vector<CLI::Option*> options = {
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
             "--base", [&solid, bases](const std::string& name) { solid.base = bases.at(name); },
             "Of solid: none (the default), or a plate below it: outline, plate (a rectangle) or "
             "round; of figure: one under its feet, plate or round")
          ->check(CLI::IsMember(bases)),
      app.add_option_function<std::string>(
             "--height-mode",
             [&solid](const std::string& name) { solid.detail = name == "detail"; },
             "How it shrinks: linear (evenly, the default), or detail (small forms stay)")
          ->check(CLI::IsMember({"linear", "detail"})),
      app.add_option("--nozzle", relief.nozzle,
                     "Of solid and figure: width in mm that its walls are checked for (default "
                     "0.4)")
          ->check(within(0.05, 10.0))};
  for (const auto& [name, length, least, most, text] : solid_lengths)
    // A size is of every model.
    if (length != &SolidOptions::size)
      options.push_back(app.add_option(std::string("--") + name, solid.*length, text)
                            ->check(within(least, most)));
  for (CLI::Option* option : options) option->needs(profile);
}

}  // namespace relievo::cli
