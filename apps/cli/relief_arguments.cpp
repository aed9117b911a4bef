#include "apps/cli/relief_arguments.h"

#include <array>
#include <string>

#include "apps/cli/cue_argument.h"
#include "apps/cli/solid_arguments.h"
#include "apps/cli/within.h"

namespace relievo::cli {
namespace {

Visibility visibility(const std::string& name) {
  if (name == "orbit") return Visibility::orbit;
  return name == "all" ? Visibility::all : Visibility::relief;
}

Field field(const std::string& name) {
  if (name == "inflation") return Field::inflation;
  return name == "shift" ? Field::shift : Field::relief;
}

/// Adds an option that takes one of two words. The first one sets the flag, the second clears it.
void add_choice(CLI::App& app, const char* option, const std::array<std::string, 2>& words,
                bool& flag, const char* meaning) {
  app.add_option_function<std::string>(
         option, [&flag, first = words[0]](const std::string& word) { flag = word == first; },
         meaning)
      ->check(CLI::IsMember({words[0], words[1]}));
}

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
  app.add_option_function<std::string>(
         "--method",
         [&relief](const std::string& name) {
           if (name == "nonlinear") relief.options.method = Method::nonlinear;
         },
         "approximate (the default), or nonlinear, which solves inflation and depth order together")
      ->check(CLI::IsMember({"approximate", "nonlinear"}));
  relief::NonlinearOptions& nonlinear = relief.options.nonlinear;
  app.add_option(
         "--lambda-bnd", nonlinear.lambda_bnd,
         "For nonlinear: how firmly outlines beside joins stay down (default 0.01: no pits)")
      ->check(within(relief::min_lambda_bnd, relief::max_lambda_bnd));
  app.add_option("--lambda-shift", nonlinear.lambda_shift,
                 "For nonlinear: the cost of a shift relative to a change of inflation (default 1)")
      ->check(within(relief::min_lambda_shift, relief::max_lambda_shift));
  app.add_option_function<std::string>(
         "--field", [&relief](const std::string& name) { relief.field = field(name); },
         "Height field: relief (the default), or one of its two terms, inflation or shift")
      ->check(CLI::IsMember({"relief", "inflation", "shift"}));
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
      app, "--ramps", {"auto", "robin"}, relief.options.layers.attach,
      "Outlines beside joins: auto leaves the part below gradually (the default); robin uses "
      "the condition of the paper");
  relief::OrderingOptions& ordering = relief.options.ordering;
  add_choice(app, "--limbs", {"straight", "back"}, ordering.straight_limbs,
             "Joined limbs: straight keeps them as far forward as their roots (the default); back "
             "lets them fall back to the drawing plane, as in the paper");
  add_choice(
      app, "--caps", {"closed", "loose"}, ordering.close_caps,
      "Hats and eyes: closed wraps them around the part that they lie on (the default); loose "
      "leaves them as far forward as where they cross it, as in the paper");
  auto* preset = app.add_option_function<std::string>(
      "--preset", [&relief](const std::string& name) { relief.as_in_paper = name == "paper"; },
      "default uses the values of each part; paper uses those of the paper: c = 4 and d = 1 or -1 "
      "for all, round and not tilted, ramps as robin, limbs back, caps loose");
  preset->check(CLI::IsMember({"default", "paper"}));
  for (const char* value :
       {"--c", "--flat", "--lean", "--rho", "--alpha0", "--ramps", "--limbs", "--caps"})
    preset->excludes(app.get_option(value));
  app.add_flag_callback(
      "--no-glue", [&relief] { relief.options.layers.glue = false; },
      "Lets outlines beside joins rise above the part below");
}

void add_visibility(CLI::App& app, ReliefArguments& relief) {
  auto* visible =
      app.add_option_function<std::string>(
             "--visible",
             [&relief](const std::string& name) { relief.visibility = visibility(name); },
             "orbit writes whole parts (the default); relief the surface seen from the front, with "
             "walls (the default for .stl); all writes every face")
          ->check(CLI::IsMember({"relief", "orbit", "all"}));
  app.add_flag_callback(
         "--keep-hidden", [&relief] { relief.visibility = Visibility::all; },
         "Same as --visible all")
      ->excludes(visible);
  add_solid_options(app, relief);
}

}  // namespace relievo::cli
