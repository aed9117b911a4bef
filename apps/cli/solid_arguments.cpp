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
             "relief writes the surface alone (the default); solid a closed body with a flat back, "
             "to print or carve; figure a closed body with a back as round as its front")
          ->check(CLI::IsMember({"relief", "solid", "figure"}));
  const std::map<std::string, BaseShape> bases(std::begin(base_shapes), std::end(base_shapes));
  std::vector<CLI::Option*> options = {
      app.add_option_function<std::string>(
             "--back",
             [&solid](const std::string& name) {
               if (solid.back == BackSide::flat)
                 throw CLI::ValidationError("--back applies to figures: add --profile figure");
               if (name == "parts") solid.back = BackSide::parts;
             },
             "Colours on the back of a figure: drawing (the default), or parts, the mean colour of "
             "each part")
          ->check(CLI::IsMember({"drawing", "parts"})),
      app.add_option("--mirror", solid.mirror,
                     "Adds a copy of a limb to the far side of a figure: the id of a part that is "
                     "joined to one behind it (repeatable)")
          ->take_all()
          ->expected(1),
      app.add_option_function<std::string>(
             "--base", [&solid, bases](const std::string& name) { solid.base = bases.at(name); },
             "Plate below a solid: none (the default), outline, plate (a rectangle) or round; or "
             "under the feet of a figure: plate or round")
          ->check(CLI::IsMember(bases)),
      app.add_option_function<std::string>(
             "--height-mode",
             [&solid](const std::string& name) { solid.detail = name == "detail"; },
             "How --height reduces depth: linear (evenly, the default), or detail (keeps small "
             "forms)")
          ->check(CLI::IsMember({"linear", "detail"})),
      app.add_option(
             "--nozzle", relief.nozzle,
             "Width in mm of the nozzle that the walls of a solid or figure are checked for "
             "(default 0.4)")
          ->check(within(0.05, 10.0))};
  for (const auto& [name, length, least, most, text] : solid_lengths)
    // --size applies to every model.
    if (length != &SolidOptions::size)
      options.push_back(app.add_option(std::string("--") + name, solid.*length, text)
                            ->check(within(least, most)));
  for (CLI::Option* option : options) option->needs(profile);
}

}  // namespace relievo::cli
