#include "apps/cli/relief_arguments.h"

#include <iterator>
#include <string>
#include <vector>

#include "apps/cli/common_arguments.h"
#include "apps/cli/cue_argument.h"
#include "relievo/export.h"

namespace relievo::cli {
namespace {

void add_cue_option(CLI::App& app, ReliefArguments& relief) {
  app.add_option_function<std::vector<std::string>>(
         "--cue",
         [&relief](const std::vector<std::string>& cues) {
           for (const std::string& text : cues) {
             const auto cue = parse_cue(text);
             if (!cue) throw CLI::ValidationError("--cue " + text, cue.error().message);
             relief.cues.push_back(*cue);
           }
         },
         "Profile of a part along a line, PART:KIND:X,Y,X,Y,...:VALUE in canvas px (repeatable). "
         "VALUE is, for bulge, the factor by which the part is higher there; for slope, the "
         "degrees "
         "by which it rises along the line; for crease, the degrees by which it rises towards the "
         "line from both sides")
      ->expected(1)
      ->take_all();
}

void add_method_options(CLI::App& app, ReliefArguments& relief) {
  add_choice(
      app, "--method", relief.options.method,
      "approximate (the default), or nonlinear, which solves inflation and depth order together",
      {{"approximate", Method::approximate}, {"nonlinear", Method::nonlinear}});
  relief::NonlinearOptions& nonlinear = relief.options.nonlinear;
  app.add_option(
         "--lambda-bnd", nonlinear.lambda_bnd,
         "For nonlinear: how firmly outlines beside joins stay down (default 0.01: no pits)")
      ->check(within(relief::min_lambda_bnd, relief::max_lambda_bnd));
  app.add_option("--lambda-shift", nonlinear.lambda_shift,
                 "For nonlinear: the cost of a shift relative to a change of inflation (default 1)")
      ->check(within(relief::min_lambda_shift, relief::max_lambda_shift));
  add_choice(app, "--field", relief.field,
             "Height field: relief (the default), or one of its two terms, inflation or shift",
             {{"relief", Field::relief}, {"inflation", Field::inflation}, {"shift", Field::shift}});
}

void add_shape_options(CLI::App& app, ReliefArguments& relief) {
  app.add_option("--c", relief.c, "Inflation of all parts: 4 gives a hemisphere, 2 round limbs")
      ->check(within(min_inflation, max_inflation));
  app.add_option("--flat", relief.flat,
                 "Profile of all parts: from 0, round (the default), to 1, a flat top")
      ->check(within(0.0, 1.0));
  app.add_option_function<std::vector<double>>(
         "--lean",
         [&relief](const std::vector<double>& lean) {
           relief.lean = {lean[0], lean[1]};
         },
         "Tilt of all parts: how much nearer they come per px to the right and per px downwards")
      ->expected(2)
      ->check(within(-max_lean, max_lean));
  add_cue_option(app, relief);
  relief::InflationOptions& inflation = relief.options.inflation;
  app.add_option("--rho", inflation.rho, "Softness of ramps beside joins (default 0.25)")
      ->check(within(0.001, max_rho));
  app.add_option("--alpha0", inflation.alpha0,
                 "How firmly ramps are held where they begin, from 0 (the default) to 1")
      ->check(within(0.0, 1.0));
}

}  // namespace

void add_mesh_options(CLI::App& app, ReliefArguments& relief) {
  relief::LayerOptions& layers = relief.options.layers;
  auto* vertices = app.add_option("--vertices", layers.vertex_budget,
                                  "Approximate number of vertices (default 40000)")
                       ->check(CLI::Range(100, 10000000));
  app.add_option("--edge", layers.edge_length,
                 "Spacing of points on outlines in px, in place of --vertices")
      ->check(within(0.01, 10000.0))
      ->excludes(vertices);
  app.add_option("--max-vertices", layers.max_nodes,
                 "Fails if the mesh would have more vertices (default 4000000)")
      ->check(CLI::Range(100, 100000000));
}

void add_relief_options(CLI::App& app, ReliefArguments& relief) {
  add_mesh_options(app, relief);
  add_method_options(app, relief);
  add_shape_options(app, relief);
  add_choice(
      app, "--ramps", relief.options.layers.attach,
      "Outlines beside joins: auto leaves the part below gradually (the default); robin uses "
      "the condition of the paper",
      {{"auto", true}, {"robin", false}});
  relief::OrderingOptions& ordering = relief.options.ordering;
  add_choice(app, "--limbs", ordering.straight_limbs,
             "Joined limbs: straight keeps them as far forward as their roots (the default); back "
             "lets them fall back to the drawing plane, as in the paper",
             {{"straight", true}, {"back", false}});
  add_choice(
      app, "--caps", ordering.close_caps,
      "Hats and eyes: closed wraps them around the part that they lie on (the default); loose "
      "leaves them as far forward as where they cross it, as in the paper",
      {{"closed", true}, {"loose", false}});
  auto* preset = add_choice(
      app, "--preset", relief.as_in_paper,
      "default uses the values of each part; paper uses those of the paper: c = 4 and d = 1 or -1 "
      "for all, round and not tilted, ramps as robin, limbs back, caps loose",
      {{"default", false}, {"paper", true}});
  for (const char* value :
       {"--c", "--flat", "--lean", "--rho", "--alpha0", "--ramps", "--limbs", "--caps"})
    preset->excludes(app.get_option(value));
  app.add_flag_callback(
      "--no-glue", [&relief] { relief.options.layers.glue = false; },
      "Lets outlines beside joins rise above the part below");
}

void add_visibility(CLI::App& app, ReliefArguments& relief) {
  auto* visible = add_choice(
      app, "--visible", relief.visibility,
      "Faces of the surface: orbit writes whole parts (the default); relief what is seen from the "
      "front, with walls; all writes every face",
      {{"relief", Visibility::relief}, {"orbit", Visibility::orbit}, {"all", Visibility::all}});
  app.add_flag_callback(
         "--keep-hidden", [&relief] { relief.visibility = Visibility::all; },
         "Same as --visible all")
      ->excludes(visible);
  add_choice(
      app, "--ink", relief.ink,
      "Contours: shell makes them lines that turn with the model (the default of .glb, .usdz, "
      ".html and pictures); paint leaves them in the colours of its sides (.obj, .ply); none lets "
      "the paint go on to the outline (.stl, .3mf)",
      {{"shell", Ink::shell}, {"paint", Ink::paint}, {"none", Ink::none}});
  app.add_option("--ink-width", relief.ink_width,
                 "Factor by which shells are wider than the contours drawn (default 1)")
      ->check(CLI::Range(least_ink_width, most_ink_width));
  add_solid_options(app, relief);
}

void add_solid_options(CLI::App& app, ReliefArguments& relief) {
  SolidOptions& solid = relief.solid_options;
  auto* profile =
      app.add_option_function<std::string>(
             "--profile",
             [&relief](const std::string& name) {
               relief.solid = name != "relief";
               relief.solid_options.back = name == "figure" ? BackSide::plain : BackSide::flat;
             },
             "relief writes the surface alone (the default); solid a closed body with a flat back, "
             "to print or carve (the default for .stl and .3mf); figure a closed body with a back "
             "as round as its front")
          ->check(CLI::IsMember({"relief", "solid", "figure"}));
  std::vector<CLI::Option*> options = {
      app.add_option_function<std::string>(
             "--back",
             [&solid](const std::string& name) {
               if (solid.back == BackSide::flat)
                 throw CLI::ValidationError("--back applies to figures: add --profile figure");
               for (const auto& [choice, side] : back_sides)
                 if (name == choice) solid.back = side;
             },
             "Back of a figure: plain, the paint of its parts without marks such as a face (the "
             "default); mirror, the drawing again; or parts, the mean colour of each part")
          ->check(CLI::IsMember({"plain", "mirror", "drawing", "parts"})),
      app.add_option("--mirror", solid.mirror,
                     "Adds a copy of a limb to the far side of a figure: the id of a part that is "
                     "joined to one behind it (repeatable)")
          ->take_all()
          ->expected(1),
      add_choice(
          app, "--base", solid.base,
          "Plate below a solid: none (the default), outline, plate (a rectangle) or round; or "
          "under the feet of a figure: plate or round",
          {std::begin(base_shapes), std::end(base_shapes)}),
      add_choice(app, "--height-mode", solid.detail,
                 "How --height reduces depth: linear (evenly, the default), or detail (keeps small "
                 "forms)",
                 {{"linear", false}, {"detail", true}}),
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
